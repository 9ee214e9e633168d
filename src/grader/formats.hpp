#pragma once
#include <rigor/grader/report.hpp>

namespace rigor::grader {

/// JUnit XML: a suite for each part, a case for each check. crash, timeout and memory are <error>, fail is <failure>,
/// not-compiled, not-implemented and skipped are <skipped>. Names do not depend on the seed.
std::string report_junit(const Report& report);

/// Gradescope's results.json: a test for each check with points, advice as tests without points.
std::string report_gradescope(const Report& report);

/// The same when nothing could be graded: one failed test that says why.
std::string gradescope_failure(const std::string& why);

/// The last two lines Autolab reads from stdout: semantic feedback, then the scores by part. Only letters, digits, blanks,
/// '_' and '-' in names, because its parser rewrites "word:" inside strings of the last line.
std::string report_autolab(const Report& report);

/// What Autolab is told when nothing could be graded: every part 0, the reason as a hint.
std::string autolab_failure(const std::string& why, const std::vector<std::string>& groups);

}  // namespace rigor::grader
