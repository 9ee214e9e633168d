#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <rigor/grader/formats.hpp>
#include <rigor/grader/judge.hpp>
#include <rigor/grader/misconceptions.hpp>

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
  EXPECT_FALSE(nlohmann::json::parse(autolab_failure("no: files").substr(0, autolab_failure("no: files").find('\n')))["Build"]["compiles"]["passed"].get<bool>());
}

}  // namespace
}  // namespace rigor::grader
