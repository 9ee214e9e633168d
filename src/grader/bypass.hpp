#pragma once
#include <functional>
#include <optional>
#include <rigor/grader/workers.hpp>

namespace rigor::grader {

/// The processes of one submission, for a judge who charges a function for itself alone: what every call runs through
/// without being asked for is gone around once it dies. That is computeBodyCoordsMOI, which the constructor calls (the
/// handed-out one takes its place: the driver sets the tensors itself), and the helpers asked for beside a call
/// (want_helpers: the answer then carries none). A function that the call itself runs through still counts.
class Bypass {
 public:
  /// `rebuilt` gives the program with the handed-out computeBodyCoordsMOI; an empty path where there is none.
  Bypass(std::filesystem::path executable, Limits limits, std::function<std::filesystem::path()> rebuilt)
      : own_(std::move(executable), limits), rebuilt_(std::move(rebuilt)), limits_(limits) {}

  Answer call(const Call& call) {
    if (call.request.function == std::uint32_t(Function::body_inertia)) return asked(own_, call);
    if (around_) return with_helpers(*around_, call);
    Answer answer = with_helpers(own_, call);
    if (!died(answer) || call.request.function == std::uint32_t(Function::scene_steps) || !constructor_dies(call)) return answer;
    const std::filesystem::path executable = rebuilt_();
    if (executable.empty()) return answer;
    around_.emplace(executable, limits_);
    notes_.push_back("Cuboid::computeBodyCoordsMOI, which the constructor calls, does not return: the other functions are judged with the handed-out one");
    return with_helpers(*around_, call);
  }

  const std::vector<std::string>& notes() const { return notes_; }
  /// Of the process asked last.
  std::string take_output() { return last_ == nullptr ? "" : last_->take_output(); }
  std::vector<std::string> isolation() const { return last_ == nullptr ? std::vector<std::string>{} : last_->isolation(); }

 private:
  static bool died(const Answer& answer) {
    const Death* death = std::get_if<Death>(&answer);
    return death != nullptr && death->kind != Death::Kind::absent && death->kind != Death::Kind::unstarted;
  }
  Answer asked(Workers& workers, const Call& call) {
    last_ = &workers;
    return workers.call(call);
  }
  Answer with_helpers(Workers& workers, Call call) {
    if (!helpers_) call.request.flags &= ~want_helpers;
    Answer answer = asked(workers, call);
    if (!died(answer) || (call.request.flags & want_helpers) == 0) return answer;
    call.request.flags &= ~want_helpers;
    const Answer alone = asked(workers, call);
    if (died(alone)) return answer;
    helpers_ = false;
    return alone;
  }
  bool constructor_dies(Call call) {
    call.request.function = std::uint32_t(Function::body_inertia);
    call.request.flags = call.request.direct = 0;
    return died(asked(own_, call));
  }

  Workers own_;
  std::function<std::filesystem::path()> rebuilt_;
  Limits limits_;
  std::optional<Workers> around_;
  Workers* last_ = nullptr;
  bool helpers_ = true;
  std::vector<std::string> notes_;
};

}  // namespace rigor::grader
