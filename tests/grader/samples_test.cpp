// Real submissions, end to end: compiled, run in their sandbox, judged.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <rigor/grader/judge.hpp>
#include <set>

namespace rigor::grader {
namespace {

namespace fs = std::filesystem;
const fs::path submissions = fs::path(RIGOR_SOURCE_DIR) / "tests" / "submissions";

std::vector<fs::path> directories(const fs::path& in) {
  std::vector<fs::path> list;
  for (const auto& entry : fs::directory_iterator(in))
    if (entry.is_directory()) list.push_back(entry.path());
  std::sort(list.begin(), list.end());
  return list;
}
std::set<std::string> expected(const fs::path& directory) {
  std::ifstream in(directory / "EXPECT");
  std::set<std::string> ids;
  for (std::string line; std::getline(in, line);)
    if (!line.empty() && line[0] != '#') ids.insert(line);
  return ids;
}
Report graded(const fs::path& directory, int cases, std::uint64_t seed) {
  const auto submission = open_submission(directory);
  EXPECT_TRUE(submission);
  Rubric rubric;
  rubric.cases = cases;
  rubric.seed = seed;
  const auto report = grade(*submission, rubric, {}, {});
  EXPECT_TRUE(report);
  return *report;
}

TEST(Samples, RightOnesGetFullMarksAtAnySeed) {
  for (const fs::path& directory : directories(submissions / "right"))
    for (const std::uint64_t seed : {20260414u, 5u}) {
      const Report report = graded(directory, 200, seed);
      EXPECT_EQ(report.score, 100) << report_text(report, false);
    }
}

TEST(Samples, EachWrongOneFailsExactlyTheChecksItShould) {
  for (const fs::path& directory : directories(submissions / "wrong")) {
    const Report report = graded(directory, 60, 20260414);
    std::set<std::string> failed;
    for (const CheckResult& r : report.results)
      if (r.verdict != Verdict::pass && r.max_points > 0) failed.insert(r.check->id);
    EXPECT_EQ(failed, expected(directory)) << directory;
  }
}

TEST(Samples, TheKitAsHandedOutHasNothingAndIsRecognised) {
  const Report report = graded(submissions / "kit", 20, 20260414);
  EXPECT_EQ(report.score, 0);
  for (const CheckResult& r : report.results) EXPECT_EQ(r.verdict, Verdict::not_implemented) << r.check->id;
}

}  // namespace
}  // namespace rigor::grader
