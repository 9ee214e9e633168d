#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <rigor/grader/check.hpp>
#include <string>
#include <vector>

namespace rigor::grader {

/// Who reads a report. Students see neither the graded seed nor a check that is not visible to them, and a command that
/// repeats a case only where they have it.
enum class Reader {
  instructor,
  practice,  ///< a student with the kit: ./practice, the seed for practice
  platform,  ///< a student on Autolab or Gradescope
};

enum class Verdict { pass, fail, crash, timeout, memory, not_compiled, not_implemented, skipped };
const char* name(Verdict verdict);

/// A case on which a check failed, as small as it could be made.
struct Counterexample {
  int number = 0;          ///< of the case that failed first; replay with --check ID --case NUMBER
  Scenario inputs;         ///< shrunk
  Function function = Function::update;
  Judgement judgement;     ///< empty where the call got no answer
  std::string death;       ///< how it ended then
};

/// What the judge believes went wrong, with its evidence.
struct Diagnosis {
  std::string id;          ///< misconception ids joined by '+', or "relation"
  std::string text;
  int agreements = 0, cases = 0;
};

struct CheckResult {
  const Check* check = nullptr;
  std::string group;       ///< the heading it stands under; checks of one group follow each other
  const char* visibility = "visible";  ///< to students, in Gradescope's words
  Verdict verdict = Verdict::skipped;
  double points = 0, max_points = 0;
  int cases = 0;           ///< run
  int answered = 0;        ///< of them: those that got an answer, over which worst_ratio is taken
  double worst_ratio = 0;  ///< largest |error|/bound over all cases
  std::string words;       ///< for a person: why skipped, the compiler's error, how it crashed
  std::vector<std::string> notes;          ///< variants seen, "follows from ..."
  std::optional<Counterexample> counterexample;
  std::vector<Diagnosis> diagnosis;
};

/// Errors of `update` in halved steps beside those of the assignment's stepper, for a picture.
struct Ladder {
  std::vector<double> steps;                                ///< s
  std::array<std::vector<double>, 4> errors, reference;     ///< position, velocity, spin, rotation; of their scales
};

/// What the submission's own scene does over 20 s, for a picture.
struct SceneTrace {
  std::vector<double> time, energy, momentum, angular_momentum;  ///< s, J, N s, kg m^2/s
  double blew_up_at = 0;   ///< s, when a number was first not finite; 0: never
};

/// Everything that is known about one graded submission; every format is written from this.
struct Report {
  std::string tool, rubric_title, rubric_hash;
  std::string submission, submission_path, submission_hash, kit_hash, tool_hash;
  Reader reader = Reader::instructor;
  std::string rubric_path;          ///< as it was asked for; empty: the default
  double rubric_points = 100;       ///< of all checks of the rubric, chosen or not
  std::uint64_t seed = 0;
  int cases = 0;
  int asked_cases = 0;              ///< where the command line asked for more than the rubric; else 0
  std::vector<std::string> isolation, notes;
  double score = 0, max_score = 0;
  std::vector<CheckResult> results;
  std::optional<Ladder> ladder;            ///< where update answered
  std::optional<SceneTrace> scene;         ///< where the scene ran
  std::string output;      ///< what the student's code printed, clipped
  double seconds = 0;
};

std::string report_text(const Report& report, bool colour);
std::string report_json(const Report& report);
std::string report_html(const Report& report);

/// A case's inputs as "name", "value with unit" rows: those that the called function sees.
std::vector<std::pair<std::string, std::string>> named_inputs(const Counterexample& example);
/// Where a case touches: the point that is handed to the function, or the deepest corner where it finds that itself.
Vec3<double> contact_point(const Counterexample& example);
/// Whether the report's reader may see a check: an instructor all, marked; a student those with visibility "visible".
bool shown(const Report& report, const CheckResult& result);
/// For students: how many checks are not shown and what they are worth, one sentence; "" when all are.
std::string withheld(const Report& report);
/// "3 cases", "1 case".
std::string counted(int n, const char* what);
/// What a check asks for; of one that fails that it must hold, lest "fail" and the law contradict each other.
std::string said_of(const CheckResult& result);
/// The number that is wrong by most of what is allowed for it; nullptr where there is no answer.
const Component* worst(const Counterexample& example);
/// "rigor grade PATH --rubric R --check ID --case N --seed S"; "./practice --check ID --case N" in the kit; "" where a
/// student has nothing that would repeat it.
std::string replay_command(const Report& report, const CheckResult& result);
/// Shortest digits that read back to the same double.
std::string shortest(double x);

}  // namespace rigor::grader
