#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <rigor/base/interrupt.hpp>
#include <rigor/grader/bypass.hpp>
#include <rigor/grader/diagnose.hpp>
#include <rigor/grader/judge.hpp>
#include <rigor/grader/misconceptions.hpp>
#include <rigor/grader/sanitize.hpp>
#include <rigor/grader/shrink.hpp>
#include <set>

namespace rigor::grader {
namespace {

namespace fs = std::filesystem;

Verdict verdict_of(Death::Kind kind) {
  switch (kind) {
    case Death::Kind::timeout: return Verdict::timeout;
    case Death::Kind::memory: return Verdict::memory;
    default: return Verdict::crash;
  }
}

// All calls of one case; the death of one ends it.
struct Run {
  std::vector<Reply> replies;
  std::optional<Death> death;
};
Run run_case(const Student& student, const Check& check, const Scenario& s) {
  Run run;
  for (const Call& call : check.calls(s)) {
    Answer answer = student(call);
    if (auto* death = std::get_if<Death>(&answer)) {
      run.death = *death;
      return run;
    }
    run.replies.push_back(std::get<Reply>(answer));
  }
  return run;
}

double ratio_of(const Check& check, const Scenario& s, const std::vector<Reply>& replies, bool own, double tolerance) {
  return check.judge(s, replies, own).ratio() / tolerance;
}

// A function that is slow or never returns costs this much of our time, and no more; nobody else's function pays for it.
// Its own time counts (processor and sleep), so that a busy machine changes nothing; the wall is a far backstop.
class Patience {
 public:
  explicit Patience(const Limits& limits) : limit_s_(40 * limits.call_s) {}
  /// A call that takes long on its own account (a whole scene) has a limit of its own.
  void count(StudentFunction function, const Call& call, double own_s, double wall_s) {
    if (call.seconds > 0) return;
    own_s_[function] += own_s;
    wall_s_[function] += wall_s;
  }
  bool short_of(StudentFunction f) const { return used(f) >= limit_s_ / 4; }
  bool ended(StudentFunction f) const { return used(f) >= limit_s_; }
  std::string words() const {
    char text[160];
    std::snprintf(text, sizeof text, "the function is slow, and the %g s that its calls may take in all are used up", limit_s_);
    return text;
  }

 private:
  static double at(const std::map<StudentFunction, double>& seconds, StudentFunction f) {
    const auto found = seconds.find(f);
    return found == seconds.end() ? 0 : found->second;
  }
  double used(StudentFunction f) const { return std::max(at(own_s_, f), at(wall_s_, f) / 10); }

  double limit_s_;
  std::map<StudentFunction, double> own_s_, wall_s_;
};

class Trial {
 public:
  // `inertia_failed`: an inertia function was found wrong, so what calls it may follow from that. `failed`: the checks
  // that failed so far. `deaths_allowed`: three, or one where the same function has died three times in an earlier check.
  Trial(const Student& student, const Check& check, const Rubric& rubric, const Selection& selection, const Patience& patience, bool inertia_failed,
        const std::set<std::string>& failed, int deaths_allowed)
      : student_(student), check_(check), patience_(patience), rubric_(rubric), selection_(selection), deaths_allowed_(deaths_allowed), own_(check.carries && inertia_failed), follows_(own_) {
    std::copy_if(check.follows.begin(), check.follows.end(), std::back_inserter(given_), [&](const std::string& id) { return failed.count(id) != 0; });
    result_.check = &check;
    result_.max_points = rubric.points_of(check);
  }

  // Runs the cases; a check is all or nothing, and stops after three deaths, or one case after a timeout.
  std::pair<CheckResult, std::vector<Record>> finish() {
    const int all = rubric_.cases_of(check_);
    const int first = selection_.single_case < 0 ? 0 : selection_.single_case, last = selection_.single_case < 0 ? all : first + 1;
    for (int k = first; k < last && deaths_ < deaths_allowed_; ++k) {
      if (interrupted() != 0) {
        result_.words = "interrupted after " + std::to_string(result_.cases) + " cases";
        break;
      }
      if (patience_.ended(check_.function)) {
        out_of_patience_ = true;
        break;
      }
      one_case(k);
    }
    conclude();
    return {std::move(result_), std::move(records_)};
  }

 private:
  void one_case(int number) {
    const Scenario s = draw_case(check_, rubric_.seed, number);
    Run run = run_case(student_, check_, s);
    ++result_.cases;
    if (run.death) {
      ++deaths_;
      if (!worst_death_) worst_death_ = run.death, died_at_ = number;
      if (run.death->kind == Death::Kind::timeout) deaths_allowed_ = std::min(deaths_allowed_, std::max(2, deaths_));
      return;
    }
    const double ratio = ratio_of(check_, s, run.replies, false, rubric_.tolerance_of(check_));
    ++result_.answered;
    const Judgement judgement = check_.judge(s, run.replies, false);
    if (!judgement.note.empty() && std::find(result_.notes.begin(), result_.notes.end(), judgement.note) == result_.notes.end())
      result_.notes.push_back(judgement.note);
    if (!(ratio <= result_.worst_ratio)) result_.worst_ratio = ratio;
    if (!(ratio <= 1)) {
      if (failed_at_ < 0) failed_at_ = number;
      follows_ = follows_ && ratio_of(check_, s, run.replies, true, rubric_.tolerance_of(check_)) <= 1;
      if (!given_.empty() && !(check_.given(s, run.replies, own_).ratio() <= rubric_.tolerance_of(check_))) given_.clear();
    }
    records_.push_back({s, std::move(run.replies)});
  }

  void conclude() {
    if (out_of_patience_ && !worst_death_) {
      result_.verdict = Verdict::timeout;
      result_.words = "stopped after " + std::to_string(result_.cases) + " cases: " + patience_.words();
      return;
    }
    if (worst_death_) {
      result_.verdict = verdict_of(worst_death_->kind);
      result_.words = worst_death_->words + (deaths_ >= deaths_allowed_ ? " (the check stopped there)" : "");
      show(died_at_, [&](const Scenario& s) { return run_case(student_, check_, s).death.has_value(); });
      return;
    }
    if (result_.cases == 0 || interrupted() != 0) return;  // skipped
    if (failed_at_ < 0) {
      result_.verdict = Verdict::pass;
    } else if (follows_) {
      result_.verdict = Verdict::pass;
      result_.notes.push_back("right given the submission's own inertia functions, which are charged for on their own");
    } else if (!given_.empty()) {
      result_.verdict = Verdict::pass;
      result_.notes.push_back("right given what fails in " + given_.front() + ", which is charged for there");
    } else {
      result_.verdict = Verdict::fail;
      show(failed_at_, [&](const Scenario& s) {
        const Run run = run_case(student_, check_, s);
        return !run.death && !(ratio_of(check_, s, run.replies, false, rubric_.tolerance_of(check_)) <= 1);
      });
    }
    if (result_.verdict == Verdict::pass) result_.points = result_.max_points;
  }

  void show(int number, const std::function<bool(const Scenario&)>& fails) {
    Counterexample example;
    example.number = number;
    // a death costs a process, a timeout seconds: those cases are shown as drawn
    const int calls = patience_.short_of(check_.function) ? 0 : !worst_death_ ? 200 : worst_death_->kind == Death::Kind::crash ? 12 : 0;
    example.inputs = shrink(check_, draw_case(check_, rubric_.seed, number), fails, calls);
    example.function = Function(check_.calls(example.inputs)[0].request.function);
    if (worst_death_) {
      example.death = worst_death_->words;
      result_.counterexample = example;
      return;
    }
    const Run run = run_case(student_, check_, example.inputs);
    if (run.death) example.death = run.death->words;
    else example.judgement = check_.judge(example.inputs, run.replies, false);
    for (Component& c : example.judgement.components) c.bound *= rubric_.tolerance_of(check_);
    const auto finite = [](const Component& c) { return std::isfinite(c.got); };
    if (result_.verdict == Verdict::fail && !std::all_of(example.judgement.components.begin(), example.judgement.components.end(), finite))
      result_.words = "the answer is no finite number (nan or inf): something was divided by zero, or a root taken of a negative number";
    result_.counterexample = example;
  }

  const Student& student_;
  const Check& check_;
  const Patience& patience_;
  const Rubric& rubric_;
  const Selection& selection_;
  int deaths_allowed_;
  bool out_of_patience_ = false;
  CheckResult result_;
  std::vector<Record> records_;
  std::optional<Death> worst_death_;
  int deaths_ = 0, died_at_ = 0, failed_at_ = -1;
  const bool own_;                  // by the submission's own inertia functions, because they are wrong
  bool follows_;                    // right by them so far
  std::vector<std::string> given_;  // failed checks that this one follows, while it is right by the answer's own value of them
};

// What the build already knows about a function. pass: it is there.
Verdict missing(const FunctionStatus& status) {
  if (status.kind == FunctionStatus::Kind::not_compiled) return Verdict::not_compiled;
  if (status.kind == FunctionStatus::Kind::not_implemented) return Verdict::not_implemented;
  return Verdict::pass;
}

bool chosen(const Selection& selection, const Check& check) {
  return selection.only.empty() || std::find(selection.only.begin(), selection.only.end(), check.id) != selection.only.end();
}

// What the report draws besides counterexamples, from answers that were asked for anyway.
void keep_pictures(const Check& check, const Record& seen, Report& report) {
  if (std::string_view(check.id) == "update.convergence") {
    std::vector<Reply> right;
    for (const Call& call : check.calls(seen.inputs)) right.push_back(model_answer(Habits{}, call.constants, call.request));
    const Convergence student = convergence(seen.inputs, seen.replies), reference = convergence(seen.inputs, right);
    Ladder ladder;
    ladder.steps.assign(student.h.begin(), student.h.end());
    for (std::size_t part = 0; part < 4; ++part) {
      ladder.errors[part].assign(student.error[part].begin(), student.error[part].end());
      ladder.reference[part].assign(reference.error[part].begin(), reference.error[part].end());
    }
    report.ladder = ladder;
  } else if (std::string_view(check.id) == "scene.runs") {
    SceneTrace trace;
    for (const auto& [time, energy, momentum, angular] : seen.replies[0].trace) {
      if (!(time > 0)) break;  // it did not come that far
      if (!std::isfinite(energy + momentum + angular)) {
        trace.blew_up_at = time;
        break;
      }
      trace.time.push_back(time), trace.energy.push_back(energy), trace.momentum.push_back(momentum), trace.angular_momentum.push_back(angular);
    }
    if (trace.time.size() > 1 || trace.blew_up_at > 0) report.scene = trace;
  }
}

// A reading the rubric does not take for right.
void apply_refused(CheckResult& result, const std::set<std::string>& refused) {
  if (result.verdict != Verdict::pass) return;
  for (const std::string& id : refused) {
    const Misconception& reading = *find_misconception(id);
    if (std::find(result.notes.begin(), result.notes.end(), reading.text) == result.notes.end()) continue;
    result.verdict = Verdict::fail;
    result.points = 0;
    result.words = "not accepted by the rubric: " + reading.text;
  }
}

// A failure whose whole explanation the rubric accepts counts as right.
void apply_accepted(CheckResult& result, const std::set<std::string>& accepted) {
  if (result.verdict != Verdict::fail || result.diagnosis.empty()) return;
  if (accepted.count(result.diagnosis.front().id) == 0) return;
  result.verdict = Verdict::pass;
  result.points = result.max_points;
  result.notes.push_back("accepted by the rubric: " + result.diagnosis.front().text);
}

/// The checks that decide what is behind the failures among `results`, where not all of them were chosen: of the functions
/// that failed and of those before them, whose mistakes are charged there. Empty where nothing is missing.
std::vector<std::string> missing_evidence(const std::vector<CheckResult>& results, const Selection& selection) {
  std::optional<StudentFunction> last;
  for (const CheckResult& r : results)
    if (r.verdict == Verdict::fail) last = std::max(last.value_or(r.check->function), r.check->function);
  std::vector<std::string> ids;
  bool complete = selection.single_case < 0;
  for (const Check& check : checks()) {
    const bool run = chosen(selection, check), decides = last && check.points > 0 && check.function <= *last;
    if (run || decides) ids.push_back(check.id);
    complete = complete && (run || !decides);
  }
  return last && !complete ? ids : std::vector<std::string>{};
}

// What the whole of the evidence says of a check that failed on the cases chosen.
void take_over(CheckResult& result, const std::vector<CheckResult>& whole) {
  const auto same = std::find_if(whole.begin(), whole.end(), [&](const CheckResult& w) { return w.check == result.check; });
  if (result.verdict != Verdict::fail || same == whole.end()) return;
  result.diagnosis = same->diagnosis;
  if (same->verdict != Verdict::pass) return;
  result.verdict = Verdict::pass;
  result.points = result.max_points;
  result.words.clear();
  result.notes = same->notes;
  result.counterexample.reset();
}

}  // namespace

void judge(const Student& student, const std::array<FunctionStatus, student_functions>& functions, const Rubric& rubric,
           const Selection& selection, Report& report) {
  report.rubric_points = std::fabs(rubric.total_points() - 100) < 1e-9 ? 100 : rubric.total_points();
  std::vector<std::vector<Record>> records;
  bool inertia_failed = false;
  std::set<StudentFunction> dead;
  std::set<std::string> failed;
  Patience patience(rubric.limits);
  for (const Check& check : checks()) {
    if (!chosen(selection, check)) continue;
    const FunctionStatus& status = functions[std::size_t(check.function)];
    if (const Verdict verdict = missing(status); verdict != Verdict::pass) {
      CheckResult result;
      result.check = &check;
      result.verdict = verdict;
      result.max_points = rubric.points_of(check);
      result.words = verdict == Verdict::not_implemented
                         ? std::string(student_function_name(check.function)) + " is as handed out"
                         : status.error;
      report.results.push_back(std::move(result));
      records.emplace_back();
      continue;
    }
    const Student watched = [&](const Call& call) {
      const auto start = std::chrono::steady_clock::now();
      Answer answer = student(call);
      patience.count(check.function, call, answer.seconds, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
      return answer;
    };
    auto [result, seen] = Trial(watched, check, rubric, selection, patience, inertia_failed, failed, dead.count(check.function) != 0 ? 1 : 3).finish();
    if (result.verdict == Verdict::crash || result.verdict == Verdict::timeout || result.verdict == Verdict::memory) dead.insert(check.function);
    if (result.verdict == Verdict::fail) failed.insert(check.id);
    inertia_failed = inertia_failed || (check.group == "Inertia" && result.verdict == Verdict::fail);
    if (!seen.empty()) keep_pictures(check, seen.front(), report);
    report.results.push_back(std::move(result));
    records.push_back(std::move(seen));
  }
  if (const auto ids = missing_evidence(report.results, selection); !ids.empty()) {
    Report whole;
    judge(student, functions, rubric, {ids, -1}, whole);
    for (CheckResult& result : report.results) take_over(result, whole.results);
  } else {
    std::vector<History> histories;
    for (std::size_t i = 0; i < report.results.size(); ++i)
      if (!records[i].empty()) histories.push_back({&report.results[i], std::move(records[i])});
    diagnose(histories);
  }
  for (CheckResult& result : report.results) {
    apply_accepted(result, rubric.accepted);
    apply_refused(result, rubric.refused);
    result.group = rubric.group_of(*result.check);
    result.visibility = name(rubric.visibility_of(*result.check));
    report.score += result.points;
    report.max_score += result.max_points;
  }
  const std::vector<std::string> groups = rubric.group_names();
  const auto place = [&](const CheckResult& r) { return std::find(groups.begin(), groups.end(), r.group) - groups.begin(); };
  std::stable_sort(report.results.begin(), report.results.end(), [&](const CheckResult& a, const CheckResult& b) { return place(a) < place(b); });
}

Outcome<Report> grade(const Submission& submission, const Rubric& rubric, const Selection& selection, const BuildOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  BuildOptions plain = options;
  plain.sanitize = false;
  const auto built = build(submission, plain);
  if (!built) return built.fault();
  Report report;
  report.rubric_title = rubric.title;
  report.rubric_hash = rubric.hash();
  report.rubric_path = rubric.path;
  report.submission = submission.name;
  report.submission_hash = submission.hash;
  report.kit_hash = kit_hash();
  report.tool_hash = tool_hash();
  report.seed = rubric.seed;
  report.cases = selection.single_case < 0 ? rubric.cases : 1;
  report.notes = submission.notes;
  report.notes.insert(report.notes.end(), built->notes.begin(), built->notes.end());
  const auto layers = [](const char* of, const std::vector<std::string>& lines) {
    std::string all = of;
    for (const std::string& line : lines) all += (&line == &lines.front() ? ": " : "; ") + line;
    return all;
  };
  report.isolation = {layers("compiler", built->isolation)};

  Bypass workers(built->executable, rubric.limits, [&]() -> fs::path {
    BuildOptions without = plain;
    without.replaced = {StudentFunction::body_inertia};
    const auto other = build(submission, without);
    return other ? other->executable : fs::path();
  });
  Constants own;
  if (built->own_constants && !built->executable.empty()) {
    Worker worker(built->executable, own, rubric.limits);
    Request q{};
    q.function = std::uint32_t(Function::constants);
    const Answer answer = worker.call(q);
    if (const Reply* r = std::get_if<Reply>(&answer)) own = {r->constants[0], r->constants[1], r->constants[2], r->constants[3]};
    report.notes.push_back("brings its own Constants.h: checks that vary the constants use its values where they can");
  }
  auto functions = built->functions;
  if (built->executable.empty())
    for (FunctionStatus& f : functions)
      if (f.kind == FunctionStatus::Kind::compiled) f = {FunctionStatus::Kind::not_compiled, "the submission could not be linked"};
  const Student student = [&](const Call& call) -> Answer {
    Answer answer = workers.call(call);
    if (report.output.size() < 4096) report.output += workers.take_output();
    if (report.isolation.size() == 1) report.isolation.push_back(layers("program", workers.isolation()));
    return answer;
  };
  judge(student, functions, rubric, selection, report);
  report.notes.insert(report.notes.end(), workers.notes().begin(), workers.notes().end());
  if (options.sanitize && interrupted() == 0) report.notes.push_back(sanitizer_advice(submission, rubric, options));
  if (report.output.size() > 4096) report.output.resize(4096);
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace rigor::grader
