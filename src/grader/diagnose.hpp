#pragma once
#include <rigor/grader/report.hpp>

namespace rigor::grader {

/// A case as it was run: the student's replies beside the inputs.
struct Record {
  Scenario inputs;
  std::vector<Reply> replies;
};

/// The cases run for one check, answered ones only.
struct History {
  CheckResult* result;
  std::vector<Record> records;
};

/// Names what is behind failed checks: for each student function the one misconception (or pair) whose model gives
/// the student's numbers on every case of every check of that function. Nothing is named when two explanations that
/// differ agree equally well, or when none fits; then simple relations (a constant factor, a sign, a transpose).
/// Marks checks that are right given a mistake made elsewhere ("follows from tangent.not-normalised") as passed.
void diagnose(std::vector<History>& histories);

}  // namespace rigor::grader
