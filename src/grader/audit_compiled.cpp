#include <memory>
#include <rigor/grader/audit.hpp>
#include <rigor/grader/misconceptions.hpp>
#include <rigor/grader/workers.hpp>

namespace rigor::grader {
namespace {

Auditee auditee_of(std::string id, const BuildResult& built, const std::filesystem::path& executable) {
  Auditee a;
  a.id = std::move(id);
  a.functions = built.functions;
  a.enter = [executable] {
    const auto workers = std::make_shared<Workers>(executable, Limits{});
    return Student([workers](const Call& call) { return workers->call(call); });
  };
  return a;
}

Outcome<BuildResult> built_whole(const Submission& submission, const BuildOptions& options) {
  auto built = build(submission, options);
  if (!built) return built.fault();
  if (built->executable.empty()) return Fault{Fault::Kind::unsupported, submission.name, "a sample of the audit cannot be built here"};
  return built;
}

}  // namespace

Outcome<std::vector<Auditee>> switched_auditees(const Submission& submission, const std::vector<std::string>& ids, const BuildOptions& options) {
  const auto built = built_whole(submission, options);
  if (!built) return built.fault();
  // beside the program in the cache, so that a link is possible and every process may read it
  const std::filesystem::path room = built->executable.parent_path().parent_path() / "audit" / built->executable.filename();
  std::error_code ec;
  std::filesystem::create_directories(room, ec);
  std::vector<Auditee> list;
  for (const std::string& id : ids) {
    const std::filesystem::path named = room / id;
    if (!std::filesystem::exists(named, ec)) std::filesystem::create_hard_link(built->executable, named, ec);
    if (!std::filesystem::exists(named, ec)) return Fault{Fault::Kind::unwritable, named.string(), "a link to a program cannot be made"};
    list.push_back(auditee_of(id, *built, named));
  }
  return list;
}

Outcome<Auditee> compiled_auditee(const Submission& submission, const BuildOptions& options) {
  const auto built = built_whole(submission, options);
  if (!built) return built.fault();
  return auditee_of(submission.name, *built, built->executable);
}

Auditee model_auditee(const std::string& id) {
  Auditee a;
  a.id = id;
  a.enter = [id] {
    const Habits habits = habits_with(id);
    return Student([habits](const Call& call) -> Answer { return model_answer(habits, call.constants, call.request); });
  };
  return a;
}

}  // namespace rigor::grader
