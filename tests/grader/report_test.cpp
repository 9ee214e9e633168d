#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <random>
#include <regex>
#include <rigor/grader/formats.hpp>
#include <rigor/grader/judge.hpp>
#include <rigor/grader/misconceptions.hpp>
#include <rigor/report/formula.hpp>
#include <sstream>

namespace rigor::grader {
namespace {

// A report with one of everything; what a student can choose in it is `said`.
Report report_saying(const std::string& said) {
  static const Report judged = [] {
    Rubric rubric;
    rubric.cases = 8;
    Report report;
    const Habits habits = habits_with("force.torque-reversed+pair.first-only+plane.no-inertia-term");
    std::array<FunctionStatus, student_functions> functions{};
    functions[0] = {FunctionStatus::Kind::not_compiled, "x"};
    judge(
        [&](const Call& call) -> Answer {
          if (call.request.function == std::uint32_t(Function::friction_tangent)) return Death{Death::Kind::crash, "x"};
          return model_answer(habits, call.constants, call.request);
        },
        functions, rubric, {}, report);
    return report;
  }();
  Report report = judged;
  report.submission = report.submission_path = report.output = said;
  report.notes = {said};
  for (CheckResult& r : report.results) {
    if (!r.words.empty()) r.words = said;
    if (!r.notes.empty()) r.notes = {said};
    if (r.counterexample && !r.counterexample->death.empty()) r.counterexample->death = said;
  }
  return report;
}

// Every tag of a page, in order.
std::string tags(const std::string& html) {
  std::string all;
  for (std::size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at + 1)) all += html.substr(at, html.find('>', at) + 1 - at);
  return all;
}

std::vector<std::string> sayings() {
  std::vector<std::string> list{"<script>hurt()</script>", "\" onload=\"hurt()", "' onload='hurt()", "</pre><img src=x onerror=hurt()>", "&lt;b&gt;", "]]>", "--><b>", "\x1b[31mred\x1b[0m",
                                "\x1b]0;title\x07", "\xc2\x9b" "31m", "\x9b" "31m", "a\nb\n\n  pass             force.torque", "a\rb", std::string("nul\0nul", 7), "\xE2\x80\xAE" "txt", "\xC0\xBC" "script>",
                                "\xEF\xBF\xBF", "{\"scores\": {}}", "word: word", "$(rm -rf ~) `id` 'x'", "%s%n", "=1+1"};
  const std::vector<std::string> pieces{"<", ">", "\"", "'", "&", "\n", "\x1b[", "\r", "/", "script", " ", "=", "-->", "]]>", "\xC2\x9B", "\xE2\x80", "\x80", ":", "{", "}", "\\", "#", ";"};
  std::mt19937 random(20260414);
  for (int k = 0; k < 300; ++k) {
    std::string text = "x";
    for (int i = int(random() % 30); i >= 0; --i) text += random() % 4 == 0 ? std::string(1, char(random() % 255 + 1)) : pieces[random() % pieces.size()];
    list.push_back(text);
  }
  return list;
}

TEST(Html, HasTheSameTagsWhateverAStudentWrites) {
  const std::string wanted = tags(report_html(report_saying("word")));
  ASSERT_GT(wanted.size(), 20000u);
  for (const std::string& said : sayings()) {
    const std::string html = report_html(report_saying(said));
    ASSERT_EQ(tags(html), wanted) << said;
    for (const char c : html) ASSERT_TRUE(static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t') << said;
  }
}

TEST(Text, HasNoControlCharacterAndNoLineOfAStudentsAtTheMargin) {
  for (const std::string& said : sayings()) {
    const std::string text = report_text(report_saying(said), false);
    for (const char c : text) ASSERT_TRUE((static_cast<unsigned char>(c) >= 0x20 && c != 0x7F) || c == '\n' || c == '\t') << said;
    for (const char* c1 : {"\xC2\x9B", "\xE2\x80\xAE"}) ASSERT_EQ(text.find(c1), std::string::npos) << said;
    ASSERT_EQ(text.find("\n  pass             force.torque"), std::string::npos) << "a verdict forged by a name or by output";
  }
}

TEST(Formats, AreWellFormedWhateverAStudentWrites) {
  const auto elements = [](const Report& report) {  // but for the one attribute that is the submission's name
    return std::regex_replace(tags(report_junit(report)), std::regex("<testsuites name=\"[^\"<>]*\">"), "<testsuites>");
  };
  const std::string wanted = elements(report_saying("word"));
  for (const std::string& said : sayings()) {
    const Report report = report_saying(said);
    ASSERT_EQ(elements(report), wanted) << said;
    ASSERT_FALSE(nlohmann::json::parse(report_gradescope(report), nullptr, false).is_discarded()) << said;
    ASSERT_FALSE(nlohmann::json::parse(report_json(report), nullptr, false).is_discarded()) << said;
    const std::string autolab = report_autolab(report);
    ASSERT_EQ(std::count(autolab.begin(), autolab.end(), '\n'), 2) << said;
  }
}

TEST(Replay, IsOneLineThatAShellReadsBack) {
  for (const std::string path : {"plain/path", "with blank", "quote's", "two\nlines", "$HOME`id`", "tab\there's \\ more"}) {
    Report report = report_saying("x");
    report.submission_path = path;
    const std::string command = replay_command(report, report.results.back());
    ASSERT_EQ(command.find('\n'), std::string::npos);
    setenv("RIGOR_COMMAND", command.c_str(), 1);
    std::FILE* pipe = popen("bash -c 'rigor() { printf %s \"$2\"; }; eval \"$RIGOR_COMMAND\"'", "r");
    ASSERT_NE(pipe, nullptr);
    std::string back;
    for (int c; (c = std::fgetc(pipe)) != EOF;) back += char(c);
    pclose(pipe);
    EXPECT_EQ(back, path) << command;
  }
}

Report report_of(const Student& student, const std::vector<std::string>& only, const Rubric& rubric = {}) {
  Report report;
  report.submission = "ada", report.submission_path = "ada", report.seed = rubric.seed, report.tool = "rigor";
  Rubric few = rubric;
  few.cases = 6;
  judge(student, {}, few, {only, -1}, report);
  return report;
}
Answer reversed(const Call& call) { return model_answer(habits_with("force.torque-reversed"), call.constants, call.request); }

// Where the graded seed, a hidden check and a command may be seen.
TEST(Readers, StudentsSeeNeitherTheGradedSeedNorHiddenChecks) {
  const auto rubric = parse_rubric("seed = 91827364\n[visibility]\n\"force.torque\" = \"hidden\"", "mine.toml");
  ASSERT_TRUE(rubric);
  Report report = report_of(reversed, {"force.torque", "force.sum", "moi.body"}, *rubric);
  report.rubric_path = rubric->path;
  for (const std::string& text : {report_gradescope(report), report_autolab(report)}) {
    EXPECT_EQ(text.find("91827364"), text.npos);
    EXPECT_EQ(text.find("replay"), text.npos);
  }
  EXPECT_EQ(report_autolab(report).find("force torque"), std::string::npos);
  for (auto* write : {+[](const Report& r) { return report_text(r, false); }, +[](const Report& r) { return report_html(r); }, +[](const Report& r) { return report_junit(r); }}) {
    report.reader = Reader::platform;
    EXPECT_EQ(write(report).find("91827364"), std::string::npos);
    EXPECT_EQ(write(report).find("force.torque"), std::string::npos);
    EXPECT_EQ(write(report).find("rigor grade"), std::string::npos);
    EXPECT_NE(write(report).find("force.sum"), std::string::npos);
    report.reader = Reader::instructor;
    EXPECT_NE(write(report).find("91827364"), std::string::npos);
    const std::string whole = std::regex_replace(write(report), std::regex(R"( \\\n +)"), " ");  // the text breaks long commands
    EXPECT_NE(whole.find("rigor grade ada --rubric mine.toml --check force.torque --case 0 --seed 91827364"), std::string::npos);
  }
  EXPECT_NE(report_text(report, false).find("hidden from students (hidden)"), std::string::npos);
  report.reader = Reader::platform;
  EXPECT_NE(report_text(report, false).find("1 check worth 4 is not shown here; the total counts it"), std::string::npos) << report_text(report, false);
  for (CheckResult& r : report.results) r.visibility = "visible";
  EXPECT_EQ(report_text(report, false).find("replay:"), std::string::npos) << "students of a platform have no command";
  report.reader = Reader::practice;
  EXPECT_NE(report_text(report, false).find("replay: ./practice --check force.torque --case 0\n"), std::string::npos) << report_text(report, false);
}

TEST(Text, KeepsTheLinesOfChecksWithin80Columns) {
  Report report = report_of(reversed, {});
  for (CheckResult& r : report.results) r.cases = r.answered = 100000, r.worst_ratio = 1.234e-10, r.max_points = std::min(r.max_points, 99.0), r.verdict = Verdict::not_implemented, r.words = "", r.counterexample.reset();
  std::istringstream lines(report_text(report, false));
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80u) << line;
}

// Long names of what is wrong, and commands with a path of a rubric: a command goes on in the next line.
TEST(Text, KeepsCasesAndCommandsWithin80Columns) {
  Report report = report_of([](const Call& call) -> Answer { return model_answer(habits_with("friction.reversed+pair.no-spin"), call.constants, call.request); }, {});
  report.submission_path = "submissions/spring/ada-lovelace";
  report.rubric_path = "courses/rigid-bodies/rubric-of-the-course.toml";
  const std::string text = report_text(report, false);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80u) << line;
  EXPECT_NE(text.find("      replay: rigor grade submissions/spring/ada-lovelace \\\n          --rubric courses/rigid-bodies/rubric-of-the-course.toml \\\n          --check plane.friction-limit --case 0 --seed"), std::string::npos) << text;
}

// "fail" beside a law would read as if the law had been kept, or tried.
TEST(Reports, SayOfALawThatFailsThatItMustHold) {
  const Report report = report_of([](const Call& call) -> Answer {
    Reply idle{};
    idle.A = call.request.A, idle.B = call.request.B;
    return idle;
  }, {"pair.linear-momentum"});
  for (const std::string& text : {report_text(report, false), report_html(report), report_junit(report), report_gradescope(report)})
    EXPECT_NE(text.find("must hold: the impulse keeps the total linear momentum"), std::string::npos) << text;
  EXPECT_NE(report_text(report, false).find("something happens to the normal"), std::string::npos);
}

TEST(Text, SaysNoErrorWhereNothingWasAnswered) {
  const Report dead = report_of([](const Call&) -> Answer { return Death{Death::Kind::timeout, "took longer"}; }, {"force.sum"});
  EXPECT_NE(report_text(dead, false).find(" 2 cases\n"), std::string::npos) << report_text(dead, false);
  EXPECT_NE(report_html(dead).find("2 cases; none got an answer"), std::string::npos);
  const Report nan = report_of([](const Call& call) -> Answer {
    Reply r = model_answer({}, call.constants, call.request);
    r.A.net_force[0] = NAN;
    return r;
  }, {"force.sum"});
  EXPECT_NE(report_text(nan, false).find("no finite number"), std::string::npos);
  EXPECT_EQ(report_text(nan, false).find("error inf"), std::string::npos);
}

TEST(Text, SaysACompilersErrorOnceAndCountsInTheSingular) {
  std::array<FunctionStatus, student_functions> functions{};
  functions[std::size_t(StudentFunction::update)] = {FunctionStatus::Kind::not_compiled, "Cuboid.cpp:9: expected ';'"};
  Report report;
  Rubric rubric;
  rubric.cases = 1;
  judge(reversed, functions, rubric, {}, report);
  for (const std::string& text : {report_text(report, false), report_html(report)}) {
    const std::size_t first = text.find("Cuboid.cpp:9");
    ASSERT_NE(first, text.npos);
    EXPECT_EQ(text.find("Cuboid.cpp:9", first + 1), text.npos);
    for (const char* wrong : {" 1 cases", " 1 points"}) EXPECT_EQ(text.find(wrong), text.npos) << wrong;
  }
}

TEST(Text, SaysInTheHeadWhatTheRubricsPointsAddUpTo) {
  const auto head = [](const char* rubric) {
    const std::string text = report_text(report_of(reversed, {"force.sum"}, *parse_rubric(rubric, "mine.toml")), false);
    return text.substr(0, text.find("\n\n"));
  };
  EXPECT_EQ(head("[points]\n\"force.sum\" = 6"), "ada: 6 of 6\nthe points of this rubric add up to 102, not 100");
  EXPECT_EQ(head(""), "ada: 4 of 4");
}

TEST(Text, SaysWhenTheSceneBlewUp) {
  const Report report = report_of([](const Call& call) -> Answer {
    Reply r = model_answer({}, call.constants, call.request);
    r.scene[3] = 0;
    for (auto& sample : r.trace) sample[0] = 0;
    r.trace[0][0] = 0.25, r.trace[0][1] = r.trace[0][2] = r.trace[0][3] = INFINITY;
    return r;
  }, {"scene.runs"});
  EXPECT_EQ(report.results[0].group, "Scene");
  EXPECT_NE(report_text(report, false).find("the scene blew up at t = 0.25 s"), std::string::npos);
  EXPECT_NE(report_html(report).find("The scene blew up at t = 0.25 s"), std::string::npos);
}

TEST(Html, ShowsTheFormulaOfEveryCheck) {
  for (const Check& check : checks()) EXPECT_NE(rigor::report::formula_text(check.formula), "") << check.id << ": " << check.formula;
}

TEST(Html, ShowsTheErrorOfUpdateBesideTheReference) {
  Rubric rubric;
  rubric.cases = 4;
  const auto ladder_of = [&](const std::string& habits) {
    Report report;
    judge([&](const Call& call) -> Answer { return model_answer(habits_with(habits), call.constants, call.request); }, {}, rubric, {{"update.convergence"}}, report);
    return *report.ladder;
  };
  // the assignment's scheme is of order 1 in position and rotation, exact in velocity and spin where the forces are constant
  const Ladder right = ladder_of("");
  for (std::size_t k = 0; k + 1 < right.steps.size(); ++k) {
    EXPECT_EQ(right.steps[k], 2 * right.steps[k + 1]);
    EXPECT_NEAR(right.errors[0][k] / right.errors[0][k + 1], 2, 0.05);
    EXPECT_NEAR(right.errors[3][k] / right.errors[3][k + 1], 2, 0.1);
    EXPECT_LT(right.errors[1][k], 1e-12);
    EXPECT_EQ(right.errors[3][k], right.reference[3][k]);
  }
  const Ladder stuck = ladder_of("update.rotation-stays");
  EXPECT_GT(stuck.errors[3].back(), 0.1);
  EXPECT_NEAR(stuck.errors[3][2] / stuck.errors[3][3], 1, 1e-9);
  EXPECT_EQ(stuck.reference[3], right.reference[3]);
}

}  // namespace
}  // namespace rigor::grader
