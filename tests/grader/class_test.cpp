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

const Entry* entry_of(const std::vector<Entry>& roster, const std::string& student) {
  for (const Entry& entry : roster)
    if (entry.student == student) return &entry;
  return nullptr;
}

TEST_F(Class, OfGradescopeKeepsTwoOfOneNameApartAndEverybodyOfAGroup) {
  const fs::path dir = root / "in" / "assignment_7_export";
  for (const char* name : {"submission_1", "submission_2", "submission_3", "submission_4"}) fs::create_directories(dir / name);
  std::ofstream(dir / "submission_metadata.yml") << R"(---
submission_1:
  :submitters:
  - :name: Bob
    :sid: '11'
    :email: robert@uni.edu
  :created_at: 2026-05-01 10:00:00
  :history:
  - :name: nobody
    :email: history@uni.edu
submission_2:
  :submitters:
  - :name: Bob
    :sid: '12'
    :email: bob@uni.edu
submission_3:
  :submitters:
    - :name: "Grace \"G\" Hopper"
      :sid:
      :email: grace@uni.edu
    - :name: 'Edsger O''D'
      :sid: 14
      :email: edsger@uni.edu
  :status: processed
submission_4:
  :submitters:
  - :name: Ada
    :email: ada@uni.edu
  - :name: Alan
    :email: alan@uni.edu
  - :name: Alonzo
    :email: alonzo@uni.edu
)";
  const auto roster = read_roster(root / "in");
  ASSERT_TRUE(roster);
  ASSERT_EQ(roster->size(), 4u);
  const Entry *first = entry_of(*roster, "Bob (robert@uni.edu)"), *second = entry_of(*roster, "Bob (bob@uni.edu)");
  ASSERT_TRUE(first != nullptr && second != nullptr);
  EXPECT_EQ(first->uploads, std::vector<fs::path>{dir / "submission_1"});
  EXPECT_EQ(first->people.size(), 1u) << "the history has no submitters";
  EXPECT_EQ(second->uploads, std::vector<fs::path>{dir / "submission_2"});
  EXPECT_EQ(second->people.at(0).school_id, "12");
  const Entry* pair = entry_of(*roster, "Grace \"G\" Hopper and Edsger O'D");
  ASSERT_NE(pair, nullptr);
  EXPECT_EQ(pair->people.at(0).school_id, "");
  EXPECT_EQ(pair->people.at(1).email, "edsger@uni.edu");
  ASSERT_NE(entry_of(*roster, "Ada and 2 others"), nullptr);

  ClassRow row;
  row.entry = *entry_of(*roster, "Ada and 2 others");
  row.score = 80;
  row.max_score = 100;
  const std::string csv = scores_csv({row});
  for (const char* name : {"\nAda,80,100,", "\nAlan,80,100,", "\nAlonzo,80,100,"}) EXPECT_NE(csv.find(name), csv.npos) << csv;

  fs::create_directories(root / "in" / "assignment_8_export");
  EXPECT_EQ(read_roster(root / "in").fault().kind, Fault::Kind::malformed) << "which of two exports is not guessed";
}

TEST_F(Class, OfAutolabTakesAnEmailWithAnUnderscoreForOneStudent) {
  for (const char* name : {"bob_b@cmu.edu_1_handin", "bob_b@cmu.edu_10_handin", "bob_b@cmu.edu_2_handin_v_3"}) fs::create_directories(root / "in" / name);
  const auto roster = read_roster(root / "in");
  ASSERT_TRUE(roster);
  ASSERT_EQ(roster->size(), 1u);
  EXPECT_EQ((*roster)[0].student, "bob_b@cmu.edu");
  EXPECT_EQ((*roster)[0].version, 10);
  EXPECT_EQ((*roster)[0].versions, 3);
}

TEST_F(Class, DoesNotChooseBetweenTwoUploadsThatNothingTellsApart) {
  hand_in("sam", "right/expressions");
  std::ofstream(root / "in" / "sam.zip") << "PK";
  fs::create_directories(root / "in" / "a@x.edu_2_handin");
  std::ofstream(root / "in" / "a@x.edu_2_handin.tar") << "x";
  fs::create_directories(root / "in" / "a@x.edu_1_handin");
  const auto roster = read_roster(root / "in");
  ASSERT_TRUE(roster);
  ASSERT_EQ(roster->size(), 2u);
  EXPECT_NE((*roster)[0].trouble.find("a@x.edu_2_handin and a@x.edu_2_handin.tar"), std::string::npos) << (*roster)[0].trouble;
  EXPECT_NE((*roster)[1].trouble.find("sam and sam.zip"), std::string::npos) << (*roster)[1].trouble;
  ClassOptions options;
  options.out = root / "out";
  const auto rows = grade_class({(*roster)[1]}, {}, options);
  EXPECT_EQ(rows[0].trouble, (*roster)[1].trouble);
  EXPECT_FALSE(fs::exists(root / "out" / "sam"));
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

  EXPECT_EQ(read_class(options.out).fault().kind, Fault::Kind::malformed) << "reports alone are no run";
  EXPECT_TRUE(write_file(options.out / "scores.csv", scores_csv(first)));
  const auto earlier = read_class(options.out);
  ASSERT_TRUE(earlier);
  ASSERT_EQ(earlier->size(), 2u);
  EXPECT_EQ((*earlier)[1].entry.student, "bob <b>");
  // bob is gone, and ada's zip is broken now; a directory that is no report of ours stays
  ClassRow broken = first[0];
  broken.trouble = "damaged";
  fs::create_directories(options.out / "mine");
  EXPECT_TRUE(write_file(options.out / "mine" / "report.json", "{}"));
  EXPECT_EQ(remove_stale_reports(options.out, {broken}), (std::vector<std::string>{"ada", "bob <b>"}));
  EXPECT_FALSE(fs::exists(options.out / "ada"));
  EXPECT_FALSE(fs::exists(options.out / safe_name("bob <b>")));
  EXPECT_TRUE(fs::exists(options.out / "mine" / "report.json"));
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

TEST(ClassPage, SaysNothingWrittenOnceAndCountsOnlyWhatWasWritten) {
  std::map<std::string, std::string> stub, one;
  for (const Check& check : checks())
    if (check.points > 0) stub[check.id] = "not-implemented", one[check.id] = "pass";
  one["force.sum"] = "fail";
  one["tangent.slip"] = "not-implemented";
  const std::string page = class_html({row("ada", 0, stub), row("bob", 90, one)}, Rubric{});
  EXPECT_NE(page.find("<td>nothing written</td>"), page.npos);
  EXPECT_NE(page.find("<td>force.sum; not written: frictionTangent</td>"), page.npos);
  const std::string most = page.substr(page.find("Most failed checks"), page.find("Misconceptions") - page.find("Most failed checks"));
  EXPECT_NE(most.find("force.sum"), most.npos);
  EXPECT_EQ(most.find("force.torque"), most.npos) << "a stub fills no table";
  EXPECT_NE(most.find("2 students have some"), most.npos);
  EXPECT_LT(page.find("<h2>Students"), page.find("<svg")) << "who before how many";
}

TEST(SafeName, KeepsALongNameWithinWhatFileSystemsTake) {
  const std::string a = safe_name(std::string(300, 'a')), b = safe_name(std::string(300, 'a') + "b");
  EXPECT_LE(a.size(), 255u);
  EXPECT_NE(a, b);
}

TEST(SafeName, KeepsOutOfOtherDirectories) {
  EXPECT_EQ(safe_name("../x"), "%2E.%2Fx");
  EXPECT_EQ(safe_name("ada@x.edu"), "ada@x.edu");
  EXPECT_EQ(safe_name("a\nb"), "a%0Ab");
}

}  // namespace
}  // namespace rigor::grader
