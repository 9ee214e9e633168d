#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <rigor/base/file.hpp>
#include <rigor/base/interrupt.hpp>
#include <rigor/cli/audit.hpp>
#include <rigor/cli/in_range.hpp>
#include <rigor/cli/progress.hpp>
#include <rigor/cli/texts.hpp>
#include <rigor/grader/audit.hpp>
#include <rigor/grader/misconceptions.hpp>
#include <set>
#include <thread>

namespace rigor::cli {
namespace {

namespace fs = std::filesystem;

/// The samples carried inside the program, as files for as long as this lives.
class Samples {
 public:
  Samples() {
    std::string pattern = (fs::temp_directory_path() / "rigor-audit-XXXXXX").string();
    if (::mkdtemp(pattern.data()) != nullptr) path_ = pattern;
    for (const Text& text : texts())
      if (text.path.starts_with("tests/submissions/")) {
        const fs::path relative = fs::path(text.path).lexically_relative("tests/submissions");
        const fs::path sample = *relative.begin() / *std::next(relative.begin());
        whole_ = whole_ && !path_.empty() && write_file(path_ / relative, std::string(text.content));
        names_.insert(sample.string());
      }
  }
  ~Samples() {
    std::error_code ec;
    fs::remove_all(path_, ec);
  }
  Samples(const Samples&) = delete;
  Samples& operator=(const Samples&) = delete;

  bool whole() const { return whole_; }
  const std::set<std::string>& names() const { return names_; }  ///< "right/polar", "audit/switched"
  Outcome<grader::Submission> open(const std::string& name) const { return grader::open_submission(path_ / name); }

 private:
  fs::path path_;
  bool whole_ = true;
  std::set<std::string> names_;
};

Outcome<std::pair<std::vector<grader::Auditee>, std::vector<grader::Auditee>>> compiled() {
  const Samples samples;
  if (!samples.whole()) return Fault{Fault::Kind::unwritable, fs::temp_directory_path().string(), "the samples cannot be written there"};
  std::vector<std::string> wrong_ids, reading_ids;
  for (const grader::Misconception& m : grader::misconceptions()) wrong_ids.push_back(m.id);
  for (const grader::Misconception& v : grader::variants()) reading_ids.push_back(v.id);
  const auto switched = samples.open("audit/switched");
  if (!switched) return switched.fault();
  const auto wrong = grader::switched_auditees(*switched, wrong_ids);
  if (!wrong) return wrong.fault();
  const auto right = grader::switched_auditees(*switched, reading_ids);
  if (!right) return right.fault();
  std::vector<grader::Auditee> all_right = *right;
  for (const std::string& name : samples.names()) {
    if (!name.starts_with("right/")) continue;
    const auto submission = samples.open(name);
    if (!submission) return submission.fault();
    const auto auditee = grader::compiled_auditee(*submission);
    if (!auditee) return auditee.fault();
    all_right.push_back(*auditee);
  }
  return std::pair{*wrong, all_right};
}

}  // namespace

void add_audit(CLI::App& app, int& exit_status) {
  struct Options {
    grader::AuditOptions run;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  options->run.jobs = int(std::max(1u, std::thread::hardware_concurrency()));
  CLI::App* command = app.add_subcommand("audit", "tries the checks on every known mistake and every legitimate reading, compiled and run as submissions are");
  command->add_option("--seeds", options->run.seeds, "seeds 1 to N")->check(in_range(1, 1000))->capture_default_str();
  command->add_option("--cases", options->run.cases, "random inputs for each check")->check(in_range(1, 100000))->capture_default_str();
  command->add_option("--jobs", options->run.jobs, "submissions at a time; all processors by default")->check(in_range(1, 256));
  command->add_flag("--json", options->json, "as JSON");
  command->footer("Example:  rigor audit --seeds 20");
  command->callback([options, &exit_status] {
    const auto subjects = compiled();
    if (!subjects) {
      std::fprintf(stderr, "rigor audit: %s\n", subjects.fault().text().c_str());
      exit_status = 2;
      return;
    }
    options->run.progress = Progress(isatty(STDERR_FILENO) != 0);
    const grader::Audit audit = grader::audit(subjects->first, subjects->second, options->run);
    std::fputs((options->json ? grader::audit_json(audit) : grader::audit_text(audit)).c_str(), stdout);
    if (interrupted() != 0) std::fprintf(stderr, "rigor audit: interrupted; the figures are of what was run until then\n");
    exit_status = interrupted() != 0 ? 128 + interrupted() : audit.holds() ? 0 : 1;
  });
}

}  // namespace rigor::cli
