#pragma once
#include <functional>
#include <rigor/grader/report.hpp>
#include <rigor/grader/rubric.hpp>
#include <rigor/grader/submission.hpp>

namespace rigor::grader {

/// Anything that answers requests: a worker process, or the model student in tests and audits.
using Student = std::function<Answer(const Call&)>;

/// What of a submission is to be judged; the defaults are everything.
struct Selection {
  std::vector<std::string> only;  ///< check ids; empty: all
  int single_case = -1;           ///< replay of one case
};

/// Runs the checks against a student. `functions` says which functions are there at all. Fills results and score. Where a
/// chosen check fails, what it takes to say why is run too and not reported: verdict and diagnosis are those of the whole.
/// Looks at interrupted(): what was not run is skipped and says so.
void judge(const Student& student, const std::array<FunctionStatus, student_functions>& functions, const Rubric& rubric,
           const Selection& selection, Report& report);

/// Builds a submission, starts workers, judges. Never fails for what the submission contains.
/// Faults: those of build().
Outcome<Report> grade(const Submission& submission, const Rubric& rubric, const Selection& selection, const BuildOptions& options);

}  // namespace rigor::grader
