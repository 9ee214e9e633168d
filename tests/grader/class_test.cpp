#include <gtest/gtest.h>

#include <fstream>
#include <rigor/base/file.hpp>
#include <rigor/grader/class_run.hpp>

namespace rigor::grader {
namespace {

namespace fs = std::filesystem;

class Class : public ::testing::Test {
 protected:
  void SetUp() override {
    root = fs::temp_directory_path() / ("rigor-class-test-" + std::to_string(::getpid()));
    fs::remove_all(root);
    fs::create_directories(root / "in");
  }
  void TearDown() override { fs::remove_all(root); }
  void hand_in(const std::string& as, const std::string& sample) {
    fs::copy(fs::path(RIGOR_SOURCE_DIR) / "tests" / "submissions" / sample, root / "in" / as, fs::copy_options::recursive);
  }
  fs::path root;
};

TEST_F(Class, ReadsTheDirectoryNamesOfThePlatforms) {
  for (const char* name : {"ada@x.edu_1_handin", "ada@x.edu_12_handin", "ada@x.edu_3_handin", "lovelaceada_LATE_1234_77_work", "plain"}) fs::create_directories(root / "in" / name);
  const auto roster = read_roster(root / "in");
  ASSERT_TRUE(roster);
  ASSERT_EQ(roster->size(), 3u);
  EXPECT_EQ((*roster)[0].student, "ada@x.edu");
  EXPECT_EQ((*roster)[0].version, 12);
  EXPECT_EQ((*roster)[0].versions, 3);
  EXPECT_EQ((*roster)[1].student, "lovelaceada_1234");
  EXPECT_TRUE((*roster)[1].late);
  EXPECT_EQ((*roster)[2].student, "plain");
}

TEST_F(Class, ReadsAGradescopeExport) {
  const fs::path dir = root / "in" / "assignment_7_export";
  fs::create_directories(dir / "submission_42");
  std::ofstream(dir / "submission_metadata.yml") << "submission_41:\n  :submitters:\n  - :name: Other\nsubmission_42:\n  :submitters:\n  - :name: Ada Lovelace\n";
  const auto roster = read_roster(root / "in");
  ASSERT_TRUE(roster);
  EXPECT_EQ((*roster)[0].student, "Ada Lovelace");
}

TEST_F(Class, RefusesWhatHoldsNoStudent) {
  EXPECT_EQ(read_roster(root / "nowhere").fault().kind, Fault::Kind::unreadable);
  EXPECT_EQ(read_roster(root / "in").fault().kind, Fault::Kind::missing);
}

TEST_F(Class, GradesEveryoneAndTakesUpWhereItStopped) {
  hand_in("ada", "right/expressions");
  hand_in("bob <b>", "wrong/no-gyroscopic-term");
  fs::create_directories(root / "in" / "empty");
  const auto roster = read_roster(root / "in");
  Rubric rubric;
  rubric.cases = 20;
  ClassOptions options;
  options.out = root / "out";
  options.jobs = 2;
  options.tool = "test 1";
  const auto first = grade_class(*roster, rubric, options);
  ASSERT_EQ(first.size(), 3u);
  EXPECT_EQ(first[0].score, 100);
  EXPECT_EQ(first[1].score, 94);
  EXPECT_EQ(first[1].diagnoses, std::vector<std::string>{"update.no-gyroscopic"});
  EXPECT_NE(first[2].trouble, "") << "one that cannot be graded does not stop the others";
  const auto again = grade_class(*roster, rubric, options);
  EXPECT_TRUE(again[0].reused && again[1].reused);
  EXPECT_EQ(scores_csv(again), scores_csv(first));
  options.tool = "test 2";
  EXPECT_FALSE(grade_class(*roster, rubric, options)[0].reused) << "another tool grades again";
  EXPECT_EQ(class_html(first, rubric).find("<b>"), std::string::npos);
}

ClassRow row(const std::string& student, double score, std::map<std::string, std::string> verdicts) {
  ClassRow r;
  r.entry.student = student;
  r.score = score;
  r.max_score = 100;
  r.verdicts = std::move(verdicts);
  return r;
}

TEST(ScoresCsv, QuotesCommasAndDisarmsFormulas) {
  const std::string csv = scores_csv({row("=HYPERLINK(\"x\")", 1, {}), row("a,b", 2, {})});
  EXPECT_NE(csv.find("\n\"'=HYPERLINK(\"\"x\"\")\",1,"), std::string::npos);
  EXPECT_NE(csv.find("\n\"a,b\",2,"), std::string::npos);
}

TEST(Fairness, FindsWhoFailedMoreAndHasMorePoints) {
  const auto a = row("a", 90, {{"moi.body", "fail"}, {"force.sum", "fail"}}), b = row("b", 80, {{"moi.body", "fail"}, {"force.sum", "pass"}});
  EXPECT_EQ(unfair({a, b}).size(), 1u);
  EXPECT_TRUE(unfair({row("a", 70, {{"moi.body", "fail"}, {"force.sum", "fail"}}), b}).empty());
}

TEST(SafeName, KeepsOutOfOtherDirectories) {
  EXPECT_EQ(safe_name("../x"), "%2E.%2Fx");
  EXPECT_EQ(safe_name("ada@x.edu"), "ada@x.edu");
  EXPECT_EQ(safe_name("a\nb"), "a%0Ab");
}

}  // namespace
}  // namespace rigor::grader
