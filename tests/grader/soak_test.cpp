// Right submissions with slips of the keyboard, graded end to end: whatever they do, the judge gives a report.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <rigor/grader/judge.hpp>
#include <set>
#include <tests/grader/build_samples.hpp>
#include <tests/grader/mutate_submission.hpp>
#include <thread>

namespace rigor::grader {
namespace {

TEST(Mutations, AreTheSameEveryTimeAndChangeSomething) {
  const auto right = open_submission(samples() / "right" / "expressions");
  ASSERT_TRUE(right);
  std::map<std::string, int> kinds;
  for (int k = 0; k < 60; ++k) {
    const Mutation a = mutated(*right, k), b = mutated(*right, k);
    EXPECT_EQ(a.what, b.what);
    EXPECT_FALSE(a.what.empty());
    for (std::size_t i = 0; i < a.submission.files.size(); ++i) EXPECT_EQ(a.submission.files[i].text, b.submission.files[i].text);
    for (const std::string& what : a.what) ++kinds[what.ends_with("deleted") ? "deleted" : what.ends_with("exchanged") ? "exchanged" : "turned"];
  }
  for (const auto& [kind, count] : kinds) EXPECT_GT(count, 20) << kind;  // about 40 of 120
  EXPECT_EQ(kinds.size(), 3u);
}

// What became of all of them; printed, and kept in docs/figures.md for the complete run.
struct Tally {
  std::map<std::string, int> submissions, verdicts;
  double slowest = 0;
};

void count(Tally& tally, const Report& report, const nlohmann::json& json) {
  static const std::set<std::string> vocabulary{"pass", "fail", "crash", "timeout", "memory", "not-compiled", "not-implemented", "skipped"};
  std::set<std::string> seen;
  double points = 0;
  for (const auto& check : json["checks"]) {
    const std::string verdict = check["verdict"];
    EXPECT_TRUE(vocabulary.contains(verdict)) << report.submission << " " << check["id"] << ": " << verdict;
    EXPECT_EQ(verdict == "pass" ? check["max_points"] : nlohmann::json(0), check["points"]) << report.submission << " " << check["id"];
    points += double(check["points"]);
    seen.insert(verdict);
    ++tally.verdicts[verdict];
  }
  EXPECT_NEAR(points, report.score, 1e-9) << report.submission;
  EXPECT_LE(report.score, 100) << report.submission;
  ++tally.submissions[report.score == 100 ? "full marks" : report.score == 0 ? "no points" : "some points"];
  for (const std::string& verdict : seen) ++tally.submissions["with " + verdict];
  tally.slowest = std::max(tally.slowest, report.seconds);
}

// 25 of a thousand (./rigor test --all, or RIGOR_ALL=1): graded without a crash or a hang of the judge, every verdict one
// of the eight, points where it passes and nowhere else. RIGOR_SOAK_FROM=600 goes on where a run was ended.
TEST(Soak, EveryMutationOfARightSubmissionGetsAReport) {
  const char* asked = std::getenv("RIGOR_SOAK_FROM");
  const int from = asked != nullptr ? std::atoi(asked) : 0, all = std::getenv("RIGOR_ALL") != nullptr ? 1000 : from + 25;
  std::vector<Submission> right;
  for (const std::string& name : samples_in("right")) right.push_back(*open_submission(samples() / "right" / name));
  const Directory cache;  // a thousand builds nobody asks for again
  Rubric rubric;
  rubric.cases = 8;
  rubric.limits.call_s = 0.1;
  std::atomic<int> next{from};
  std::mutex mutex;
  Tally tally;
  int graded = 0;
  const auto work = [&] {
    for (int k = next++; k < all; k = next++) {
      const Mutation m = mutated(right[std::size_t(k) % right.size()], k);
      BuildOptions options;
      options.cache = cache.path;
      const auto report = grade(m.submission, rubric, {}, options);
      const std::lock_guard lock(mutex);
      ASSERT_TRUE(report) << k << ": " << report.fault().text();
      std::string what;
      for (const std::string& slip : m.what) what += slip + "; ";
      SCOPED_TRACE(what);
      for (const std::string& text : {report_text(*report, false), report_html(*report)}) EXPECT_FALSE(text.empty());
      count(tally, *report, nlohmann::json::parse(report_json(*report)));
      if (++graded % 50 == 0) std::printf("mutations from %d on: %d graded\n", from, graded), std::fflush(stdout);
    }
  };
  {
    checks();  // built once, before the threads
    std::vector<std::jthread> threads;
    for (int k = 0; k < 2; ++k) threads.emplace_back(work);
  }
  std::printf("%d mutations", graded);
  for (const auto& [what, n] : tally.submissions) std::printf("; %s %d", what.c_str(), n);
  std::printf("; slowest %.1f s\n", tally.slowest);
  // they are mutations worth grading: some are harmless, most are not, and every way to fail is among them
  EXPECT_GT(tally.submissions["some points"], (all - from) / 4);
  EXPECT_GT(tally.verdicts["fail"], (all - from) / 10);
  EXPECT_GT(tally.verdicts["not-compiled"], (all - from) / 10);
}

}  // namespace
}  // namespace rigor::grader
