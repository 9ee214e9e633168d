#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <rigor/base/file.hpp>
#include <rigor/grader/formats.hpp>
#include <rigor/grader/judge.hpp>
#include <rigor/grader/misconceptions.hpp>

#include "tests/grader/schema.hpp"

namespace rigor::grader {
namespace {

Report failing_report() {
  Rubric rubric;
  rubric.cases = 16;
  const Habits habits = habits_with("force.torque-reversed");
  Report report;
  report.submission = "<ada> & \"bob\"";
  report.submission_path = "a b";
  judge(
      [&](const Call& call) -> Answer {
        if (call.request.function == std::uint32_t(Function::pair_response)) return Death{Death::Kind::crash, "stopped by <signal>: 11"};
        return model_answer(habits, call.constants, call.request);
      },
      std::array<FunctionStatus, student_functions>{}, rubric, {}, report);
  return report;
}

TEST(Junit, CountsWhatItLists) {
  const std::string xml = report_junit(failing_report());
  const auto count = [&](const std::string& tag) {
    int n = 0;
    for (std::size_t at = xml.find(tag); at != std::string::npos; at = xml.find(tag, at + 1)) ++n;
    return n;
  };
  EXPECT_EQ(count("<testcase "), int(checks().size()));
  EXPECT_EQ(count("<testcase "), count("</testcase>"));
  EXPECT_EQ(count("<failure "), 1);  // force.torque; the pair's crashes are errors
  EXPECT_GT(count("<error "), 3);
  EXPECT_EQ(xml.find("<signal>"), std::string::npos);
  EXPECT_EQ(xml.find("<ada>"), std::string::npos);
}

// What readers of JUnit's XML share: each element inside its parent, with its attributes and no others, closed.
TEST(Junit, IsWellFormedAndHasOnlyTheElementsReadersKnow) {
  const std::map<std::string, std::pair<std::string, std::string>> known{  // element: parents, attributes
      {"testsuites", {"", "name"}}, {"testsuite", {"testsuites", "name tests failures errors skipped"}}, {"testcase", {"testsuite", "classname name"}},
      {"failure", {"testcase", "message"}}, {"error", {"testcase", "message"}}, {"skipped", {"testcase", "message"}}, {"system-out", {"testcase", ""}}};
  const std::string xml = report_junit(failing_report());
  ASSERT_EQ(xml.rfind("<?xml version=\"1.0\" encoding=\"UTF-8\"?>", 0), 0u);
  std::vector<std::string> open{""};
  const std::regex element("<(/?)([a-z-]+)((?: [a-z]+=\"[^\"<]*\")*)>"), attribute(" ([a-z]+)=");
  for (std::size_t at = xml.find('<', 1); at != std::string::npos; at = xml.find('<', at + 1)) {
    std::smatch match;
    ASSERT_TRUE(std::regex_search(xml.begin() + long(at), xml.end(), match, element, std::regex_constants::match_continuous)) << xml.substr(at, 80);
    const std::string tag = match[2], attributes = match[3];
    ASSERT_EQ(known.count(tag), 1u) << tag;
    if (match[1].length() > 0) {
      ASSERT_EQ(open.back(), tag);
      open.pop_back();
      continue;
    }
    ASSERT_EQ(open.back(), known.at(tag).first) << tag;
    std::string names;
    for (std::sregex_iterator it(attributes.begin(), attributes.end(), attribute), end; it != end; ++it) names += (names.empty() ? "" : " ") + (*it)[1].str();
    ASSERT_EQ(names, known.at(tag).second);
    open.push_back(tag);
  }
  EXPECT_EQ(open.size(), 1u);
  // an '&' begins one of XML's own entities
  EXPECT_FALSE(std::regex_search(xml, std::regex("&(?!(amp|lt|gt|quot|#39);)")));
}

nlohmann::json file(const std::string& path) { return nlohmann::json::parse(*read_file(std::string(RIGOR_SOURCE_DIR) + "/" + path)); }

TEST(Json, KeepsToItsSchema) {
  const auto schema = file("docs/schema/report.schema.json");
  auto json = nlohmann::json::parse(report_json(failing_report()));
  EXPECT_EQ(breaks(schema, json), "");
  json["checks"][3]["verdict"] = "passed";
  EXPECT_EQ(breaks(schema, json).substr(0, 19), "$.checks[3].verdict");  // the validator can fail
}

TEST(Gradescope, KeepsToItsSchema) {
  const auto schema = file("tests/grader/gradescope.schema.json");
  EXPECT_EQ(breaks(schema, nlohmann::json::parse(report_gradescope(failing_report()))), "");
  EXPECT_EQ(breaks(schema, nlohmann::json::parse(gradescope_failure("the grader did not finish"))), "");
}

// The rules of Gradescope's results.json: scores within max_score, known status and visibility.
TEST(Gradescope, KeepsToItsContract) {
  const auto json = nlohmann::json::parse(report_gradescope(failing_report()));
  double sum = 0;
  for (const auto& test : json["tests"]) {
    const std::string status = test["status"];
    EXPECT_TRUE(status == "passed" || status == "failed");
    EXPECT_EQ(test["visibility"], "visible");
    if (!test.contains("score")) continue;
    EXPECT_LE(test["score"].get<double>(), test["max_score"].get<double>());
    sum += test["score"].get<double>();
  }
  EXPECT_EQ(sum, failing_report().score);
}

// A port of what Autolab does with the last two lines: each must be strict JSON; on the last one "word:" is rewritten to
// "\"word\":" wherever it stands, also inside strings, so nothing of the kind may be there but keys.
TEST(Autolab, SurvivesItsParser) {
  const std::string text = report_autolab(failing_report());
  const std::size_t middle = text.find('\n');
  const std::string feedback = text.substr(0, middle), scores = text.substr(middle + 1, text.size() - middle - 2);
  EXPECT_EQ(scores.find('\n'), std::string::npos);
  const std::string rewritten = std::regex_replace(scores, std::regex(R"((\w+):)"), "\"$1\":");
  const auto parsed = nlohmann::json::parse(rewritten, nullptr, false);
  ASSERT_FALSE(parsed.is_discarded()) << rewritten;
  double sum = 0;
  for (const auto& [part, points] : parsed["scores"].items()) sum += points.get<double>();
  EXPECT_EQ(sum, failing_report().score);
  const auto told = nlohmann::json::parse(feedback);
  EXPECT_EQ(told["_presentation"], "semantic");
  for (const auto& stage : told["stages"]) EXPECT_TRUE(told.contains(stage.get<std::string>())) << stage;
  EXPECT_FALSE(nlohmann::json::parse(autolab_failure("no: files", Rubric{}.group_names()).substr(0, autolab_failure("no: files", Rubric{}.group_names()).find('\n')))["Build"]["compiles"]["passed"].get<bool>());
}

// Of Autolab's other traps: status 0, the problems of the yml and an old image are tried by the exported lab
// (tests/cli/export_test.cpp, tests/cli/older-root), forging the last line by tests/submissions/hostile/leaves-a-child.
TEST(AutolabTraps, LastLineHasOnlyTameNamesAndNumbers) {
  const std::regex allowed(R"(\{"scores":\{("[A-Za-z0-9 _-]+":-?[0-9][0-9.e+-]*,?)+\},"scoreboard":\[-?[0-9][0-9.e+-]*\]\})");
  for (const std::string& text : {report_autolab(failing_report()), autolab_failure("word: {\"scores\"} no\nfiles", Rubric{}.group_names())}) {
    ASSERT_EQ(std::count(text.begin(), text.end(), '\n'), 2);
    const std::string last = text.substr(text.find('\n') + 1, text.size() - text.find('\n') - 2);
    EXPECT_TRUE(std::regex_match(last, allowed)) << last;
  }
}

TEST(AutolabTraps, HintsHaveNothingItsParserWouldRewrite) {
  const std::string text = report_autolab(failing_report());
  const auto told = nlohmann::json::parse(text.substr(0, text.find('\n')));
  int hints = 0;
  for (const auto& stage : told["stages"])
    for (const auto& [name, item] : told[stage.get<std::string>()].items()) {
      EXPECT_TRUE(item["passed"].is_boolean());
      if (!item.contains("hint")) continue;
      ++hints;
      EXPECT_TRUE(std::regex_match(item["hint"].get<std::string>(), std::regex("[A-Za-z0-9 _-]+"))) << item;
    }
  EXPECT_GT(hints, 4);
}

TEST(AutolabTraps, OutputStaysFarBelowWhereItIsCut) {
  Report report = failing_report();  // 1000 KiB; what a submission prints is kept to 4 KiB, words to less
  report.output = std::string(4096, 'x');
  for (CheckResult& r : report.results) r.words = std::string(2000, 'y');
  EXPECT_LT(report_text(report, false).size() + report_autolab(report).size(), 250u << 10);
}

TEST(AutolabTraps, FailureHasTheSameProblemsAsAGrade) {
  const auto problems = [](const std::string& text) {
    std::vector<std::string> names;
    const auto report = nlohmann::ordered_json::parse(text.substr(text.find('\n') + 1));
    for (const auto& [name, points] : report.at("scores").items()) names.push_back(name);
    return names;
  };
  EXPECT_EQ(problems(report_autolab(failing_report())), problems(autolab_failure("x", Rubric{}.group_names())));
}

}  // namespace
}  // namespace rigor::grader
