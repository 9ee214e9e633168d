#pragma once
#include <map>
#include <rigor/grader/check.hpp>
#include <tuple>

namespace rigor::grader {

/// The processes of one submission: constants are fixed before the student's static constructors run, so there is one
/// process for each set of them, started when it is first asked. Use from one thread.
class Workers {
 public:
  Workers(std::filesystem::path executable, Limits limits) : executable_(std::move(executable)), limits_(limits) {}

  Answer call(const Call& call) {
    const Constants& c = call.constants;
    Worker& worker = processes_.try_emplace({c.restitution, c.static_friction, c.dynamic_friction, c.delta_t}, executable_, c, limits_).first->second;
    Answer answer = worker.call(call.request, call.seconds);
    last_ = &worker;
    return answer;
  }
  /// Of the process asked last.
  std::string take_output() { return last_ == nullptr ? "" : last_->take_output(); }
  std::vector<std::string> isolation() const { return last_ == nullptr ? std::vector<std::string>{} : last_->isolation(); }

 private:
  std::filesystem::path executable_;
  Limits limits_;
  std::map<std::tuple<double, double, double, double>, Worker> processes_;
  Worker* last_ = nullptr;
};

}  // namespace rigor::grader
