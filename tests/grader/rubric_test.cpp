// What an instructor writes into a rubric, and what becomes of it in a report.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <rigor/grader/formats.hpp>
#include <rigor/grader/judge.hpp>
#include <rigor/grader/misconceptions.hpp>
#include <set>
#include <regex>
#include <sstream>

namespace rigor::grader {
namespace {

Report judged(const std::string& habits, const std::string& rubric_text) {
  const auto rubric = parse_rubric("cases = 12\n" + rubric_text, "r");
  EXPECT_TRUE(rubric) << rubric.fault().text();
  const Habits h = habits_with(habits);
  Report report;
  judge([h](const Call& call) -> Answer { return model_answer(h, call.constants, call.request); }, std::array<FunctionStatus, student_functions>{}, *rubric, {}, report);
  return report;
}
const CheckResult& result(const Report& report, const std::string& id) {
  return *std::find_if(report.results.begin(), report.results.end(), [&](const CheckResult& r) { return r.check->id == id; });
}

TEST(Rubric, TheDefaultTextReadsBackAsTheDefault) {
  const auto rubric = parse_rubric(default_rubric_text(), "default");
  ASSERT_TRUE(rubric) << rubric.fault().text();
  EXPECT_EQ(rubric->seed, Rubric{}.seed);
  EXPECT_EQ(rubric->cases, Rubric{}.cases);
  for (const Check& check : checks()) EXPECT_EQ(rubric->points_of(check), check.points) << check.id;
}

TEST(Rubric, SaysWhatIsWrongAndWhere) {
  const std::vector<std::pair<std::string, std::string>> bad{
      {"casez = 3", "r:1: casez: is no key of a rubric; did you mean 'cases'?"},
      {"cases = 0", "r:1: cases: is 0, must be in [1, 100000]"},
      {"cases = \"many\"", "r:1: cases: must be a number"},
      {"tolerance = nan", "r:1: tolerance: is nan, must be in [0.01, 1000]"},
      {"tolerance = -inf", "r:1: tolerance: is -inf, must be in [0.01, 1000]"},
      {"[points]\n\"moi.body\" = -1", "r:2: points.\"moi.body\": is -1, must be in [0, 1e+06]"},
      {"[points]\n\"moi.bodi\" = 1", "r:2: points.\"moi.bodi\": there is no check 'moi.bodi'; did you mean 'moi.body'?"},
      {"accept = [\"plane.printed\"]", "r:1: accept: there is no misconception 'plane.printed'"},
      {"accept = 3", "r:1: accept: must be a list of misconception ids"},
      {"[limits]\ncall_seconds = 0", "r:2: limits.call_seconds: is 0, must be in [0.01, 600]"},
      {"points = 3", "r:1: points: must be a table: a line for each check"},
      {"cases = ", "r:1:"},
      {"seed = 5\nseed = 6", "r:2:"},
      {"seed = 5\npractice_seed = 5", "r:2: practice_seed: is the seed of the graded cases, must be another"},
      {"[limits]\nstack_mb = 8", "r:2: limits.stack_mb: is no key of a rubric"},
      {"[groups]\nA = []", "r:2: groups.\"A\": must be a list of at least one check id"},
      {"[groups]\n\"A:B\" = [\"moi.body\"]", "r:2: groups.\"A:B\": must be of letters, digits, blanks, _ and -"},
      {"[groups]\nA = [\"moi.body\"]\nB = [\"moi.body\"]", "r:3: groups.\"B\": 'moi.body' is in 'A' already"},
      {"[groups]\nA = [\"moi.bodi\"]", "r:2: groups.\"A\": there is no check 'moi.bodi'; did you mean 'moi.body'?"},
      {"[visibility]\n\"moi.body\" = \"secret\"", "r:2: visibility.\"moi.body\": must be \"visible\", \"hidden\""},
      {"[visibility]\nmoi = \"hidden\"", "r:2: visibility.\"moi\": there is no check 'moi'"},
      {"[tolerances]\n\"moi.body\" = 0", "r:2: tolerances.\"moi.body\": is 0, must be in [0.01, 1000]"},
      {"[case_counts]\n\"moi.body\" = 0", "r:2: case_counts.\"moi.body\": is 0, must be in [1, 100000]"},
      {"refuse = [\"rows\"]", "r:1: refuse: must be readings a check can tell: friction-literal"},
      {"practice = [\"moi.bdy\"]", "r:1: practice: there is no check 'moi.bdy'; did you mean 'moi.body'?"},
      {"practice = []", "r:1: practice: must be a list of at least one check id"},
      {"tolerances = 2", "r:1: tolerances: must be a table: a line for each check"},
  };
  for (const auto& [text, message] : bad) {
    const auto rubric = parse_rubric(text, "r");
    ASSERT_FALSE(rubric) << text;
    EXPECT_EQ(rubric.fault().text().substr(0, message.size()), message);
  }
}

// What the comments of the default rubric give as an example is taken: "id" = value in the table it stands in, and lists.
TEST(Rubric, EveryCommentedExampleIsAccepted) {
  std::istringstream lines(default_rubric_text());
  const std::regex table("^\\[([a-z_]+)\\]"), entry("(\"[a-z.-]+\" = (?:\"[a-z_]+\"|[0-9.]+))"), list("^([a-z]+) = \\[\\].*for example (\\[.*\\])");
  int tried = 0;
  std::string in;
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (std::regex_search(line, match, table)) in = match[1];
    const std::size_t comment = line.find("# ");
    const std::string said = comment == line.npos ? "" : line.substr(comment);
    std::string text;
    if (std::regex_search(line, match, list)) text = match[1].str() + " = " + match[2].str();
    else if (std::regex_search(said, match, entry)) text = "[" + in + "]\n" + match[1].str();
    if (text.empty()) continue;
    ++tried;
    const auto rubric = parse_rubric(text, "r");
    EXPECT_TRUE(rubric) << text << ": " << (rubric ? "" : rubric.fault().text());
  }
  EXPECT_EQ(tried, 5) << "accept, refuse, tolerances, case_counts, visibility";
}

// The kit's rubric has what students practise on, and names nothing they are not to see.
TEST(Rubric, ForPracticeNamesNoHiddenCheck) {
  const auto read = parse_rubric("# plane.energy is the trick\nseed = 91\npractice_seed = 5\ntitle = \"a \\\"b\\\"\"\ncases = 7\n[limits]\ncall_seconds = 2\n[groups]\n\"Energy\" = [\"plane.energy\"]\n\"Sums\" = [\"force.sum\"]\n"
                                 "[points]\n\"plane.energy\" = 3\n\"force.sum\" = 2.5\n[tolerances]\n\"plane.energy\" = 2\n\"force.sum\" = 3\n[visibility]\n\"plane.energy\" = \"hidden\"\n", "r");
  ASSERT_TRUE(read);
  const std::string text = practice_rubric_text(*read);
  for (const char* secret : {"plane.energy", "91", "trick", "Energy", "hidden"}) EXPECT_EQ(text.find(secret), std::string::npos) << secret << '\n' << text;
  const auto kit = parse_rubric(text, "kit");
  ASSERT_TRUE(kit) << text;
  EXPECT_EQ(kit->title, "a \"b\"");
  EXPECT_EQ(kit->seed, 5u);
  EXPECT_EQ(kit->cases, 7);
  EXPECT_EQ(kit->limits.call_s, 2);
  for (const Check& check : checks()) {
    EXPECT_EQ(kit->practises(check), check.id != "plane.energy") << check.id;
    if (check.id == "plane.energy") continue;
    EXPECT_EQ(kit->points_of(check), read->points_of(check)) << check.id;
    EXPECT_EQ(kit->tolerance_of(check), read->tolerance_of(check)) << check.id;
    EXPECT_EQ(kit->group_of(check), read->group_of(check)) << check.id;
  }
}

TEST(Rubric, AReadingThatCountsAnywayIsNotAcceptedInVain) {
  const auto rubric = parse_rubric("accept = [\"friction-literal\"]", "r");
  ASSERT_FALSE(rubric);
  EXPECT_EQ(rubric.fault().text(), "r:1: accept: 'friction-literal' is a reading that counts as right without it; refuse = [...] takes one away");
}

TEST(Rubric, WarnsOfThePublicSeedAndOfPointsThatAreNotAHundred) {
  EXPECT_EQ(warnings(Rubric{}, false).size(), 0u);
  ASSERT_EQ(warnings(Rubric{}, true).size(), 1u);
  EXPECT_NE(warnings(Rubric{}, true)[0].find("the public default"), std::string::npos);
  const auto rubric = parse_rubric("seed = 77\n[points]\n\"moi.body\" = 24", "r");
  EXPECT_EQ(warnings(*rubric, true), std::vector<std::string>{"r: the points add up to 120, not 100"});
}

// Every key of the default is one the reader takes, and has a comment beside it.
TEST(Rubric, TheDefaultTextExplainsEveryLine) {
  std::istringstream lines(default_rubric_text());
  bool in_groups = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("[")) in_groups = line.starts_with("[groups]");
    if (line.empty() || line.starts_with("#") || (in_groups && line.starts_with("\""))) continue;
    EXPECT_NE(line.find("  # "), line.npos) << line;
  }
}

TEST(Rubric, GroupsOrderTheReportAndNameThePartsOfEveryPlatform) {
  const Report report = judged("force.torque-reversed", "[groups]\n\"Collision\" = [\"pair.impulse\", \"plane.impulse\"]\n\"A first part\" = [\"force.torque\"]");
  ASSERT_GE(report.results.size(), 3u);
  EXPECT_EQ(report.results[0].group, "Collision");
  EXPECT_EQ(report.results[1].group, "Collision");
  EXPECT_EQ(report.results[2].group, "A first part");
  EXPECT_EQ(report.results[3].group, "Inertia");
  std::set<std::string> seen;
  for (std::size_t i = 0; i < report.results.size(); ++i) {
    const bool begins = i == 0 || report.results[i].group != report.results[i - 1].group;
    EXPECT_TRUE(!begins || seen.insert(report.results[i].group).second) << "a heading twice: " << report.results[i].group;
  }
  const std::string autolab = report_autolab(report);
  const auto scores = nlohmann::json::parse(autolab.substr(autolab.find('\n') + 1))["scores"];
  EXPECT_EQ(scores["Collision"], 7);
  EXPECT_EQ(scores["A first part"], 0);
  EXPECT_EQ(nlohmann::json::parse(report_json(report))["checks"][0]["group"], "Collision");
}

TEST(Rubric, VisibilityReachesGradescopeAndNothingElse) {
  const Report report = judged("", "[visibility]\n\"moi.body\" = \"after_due_date\"");
  const auto tests = nlohmann::json::parse(report_gradescope(report))["tests"];
  EXPECT_EQ(tests[0]["visibility"], "after_due_date");
  EXPECT_EQ(tests[1]["visibility"], "visible");
  EXPECT_EQ(report.score, 100);
}

// 1e-4 off is ten bounds: fails with the derived tolerance, passes with twenty times that for this check, and only this.
TEST(Rubric, AToleranceOfOneCheckIsItsOwn) {
  const auto off_by = [](const std::string& text) {
    const auto rubric = parse_rubric("cases = 12\n" + text, "r");
    Report report;
    judge([](const Call& call) -> Answer {
            Reply r = model_answer({}, call.constants, call.request);
            for (double& x : r.A.body_inertia) x *= 1 + 1e-4;
            for (double& x : r.A.body_inverse_inertia) x *= 1 + 1e-4;
            return r;
          }, std::array<FunctionStatus, student_functions>{}, *rubric, {{"moi.body", "moi.body-inverse"}, -1}, report);
    return std::pair{report.results[0].verdict, report.results[1].verdict};
  };
  EXPECT_EQ(off_by(""), (std::pair{Verdict::fail, Verdict::fail}));
  EXPECT_EQ(off_by("[tolerances]\n\"moi.body\" = 20"), (std::pair{Verdict::pass, Verdict::fail}));
}

TEST(Rubric, CaseCountsAreOfOneCheck) {
  const Report report = judged("", "[case_counts]\n\"moi.body\" = 3");
  EXPECT_EQ(result(report, "moi.body").cases, 3);
  EXPECT_EQ(result(report, "moi.world").cases, 12);
}

TEST(Rubric, RefusesAReadingThatCountsByDefault) {
  for (const std::string& id : refusable_readings()) {
    EXPECT_EQ(judged(id, "").score, 100) << id;
    const Report refused = judged(id, "refuse = [\"" + id + "\"]");
    EXPECT_LT(refused.score, 100) << id;
    EXPECT_EQ(judged("rows", "refuse = [\"" + id + "\"]").score, 100) << id;
  }
}

TEST(Rubric, AcceptsTheSecondNameOfAClassForTheFirst) {
  EXPECT_EQ(judged("pair.signs-reversed", "accept = [\"pair.relative-reversed\"]").score, 100);
}

TEST(Rubric, PracticeSeedIsNeverTheGradedOne) {
  EXPECT_NE(Rubric{}.seed, Rubric{}.practice_seed);
  const auto rubric = parse_rubric("seed = 1", "r");
  ASSERT_TRUE(rubric);
  EXPECT_NE(rubric->practice_seed, 1u);
}

// Whatever could change a grade or its report changes the hash by which a class is taken up again.
TEST(Rubric, HashChangesWithEveryKey) {
  std::set<std::string> hashes{Rubric{}.hash()};
  for (const char* text : {"seed = 2", "cases = 3", "tolerance = 2", "accept = [\"moi.third\"]", "refuse = [\"friction-literal\"]", "[limits]\ncall_seconds = 1", "[points]\n\"moi.body\" = 1",
                           "[groups]\nA = [\"moi.body\"]", "[tolerances]\n\"moi.body\" = 2", "[case_counts]\n\"moi.body\" = 2", "[visibility]\n\"moi.body\" = \"hidden\""})
    EXPECT_TRUE(hashes.insert(parse_rubric(text, "r")->hash()).second) << text;
}

}  // namespace
}  // namespace rigor::grader
