#include <cmath>
#include <map>
#include <string_view>
#include <nlohmann/json.hpp>
#include <rigor/grader/formats.hpp>
#include <rigor/report/html.hpp>

namespace rigor::grader {
namespace {

using Json = nlohmann::ordered_json;

std::string written(const Json& json, int indent = -1) { return json.dump(indent, ' ', false, Json::error_handler_t::replace); }

std::string ten_digits(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", x);
  return text;
}

// What is told of one check, as plain text; how to repeat it is added where the reader can.
std::string words(const CheckResult& r) {
  std::string text = said_of(r);
  if (!r.words.empty()) text += "\n" + r.words;
  for (const Diagnosis& d : r.diagnosis) text += "\nlikely: " + d.text + " (agrees on " + std::to_string(d.agreements) + " of " + counted(d.cases, "case") + ")";
  for (const std::string& note : r.notes) text += "\nnote: " + note;
  if (r.verdict == Verdict::pass || !r.counterexample) return text;
  text += "\nsmallest failing case:";
  for (const auto& [what, value] : named_inputs(*r.counterexample)) text += "\n  " + what + " = " + value;
  for (const Component& c : r.counterexample->judgement.components)
    if (!(std::abs(c.got - c.want) <= c.bound) || &c == worst(*r.counterexample)) text += "\n  " + c.name + " [" + c.unit + "]: got " + ten_digits(c.got) + ", want " + ten_digits(c.want);
  return text;
}
std::string replay(const Report& report, const CheckResult& r) {
  const std::string command = r.verdict == Verdict::pass || !r.counterexample ? "" : replay_command(report, r);
  return (command.empty() ? "" : "\nreplay: " + command) + (report.reader == Reader::instructor ? "\nseed " + std::to_string(report.seed) : "");
}

// Letters, digits, blanks, '_' and '-' only.
std::string tame(const std::string& name) {
  std::string out;
  for (const char c : name) out += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == ' ' || c == '_' || c == '-' ? c : ' ';
  return out;
}

std::vector<std::string> parts(const Report& report) {
  std::vector<std::string> names;
  for (const CheckResult& r : report.results)
    if (names.empty() || names.back() != r.group) names.push_back(r.group);
  return names;
}

}  // namespace

std::string report_junit(const Report& report) {
  using rigor::report::escape;
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"" + escape(report.submission) + "\">\n";
  for (const std::string& part : parts(report)) {
    int tests = 0, failures = 0, errors = 0, skipped = 0;
    std::string cases;
    for (const CheckResult& r : report.results) {
      if (r.group != part || !shown(report, r)) continue;
      ++tests;
      cases += "    <testcase classname=\"" + escape(part) + "\" name=\"" + escape(r.check->id) + "\">";
      const std::string text = escape(words(r) + replay(report, r)), message = " message=\"" + escape(name(r.verdict)) + "\">";
      switch (r.verdict) {
        case Verdict::pass: break;
        case Verdict::fail:
          if (r.max_points == 0) {  // advice is no failure
            cases += "<system-out>" + text + "</system-out>";
            break;
          }
          ++failures, cases += "<failure" + message + text + "</failure>";
          break;
        case Verdict::crash:
        case Verdict::timeout:
        case Verdict::memory: ++errors, cases += "<error" + message + text + "</error>"; break;
        default: ++skipped, cases += "<skipped" + message + text + "</skipped>";
      }
      cases += "</testcase>\n";
    }
    if (tests == 0) continue;
    out += "  <testsuite name=\"" + escape(part) + "\" tests=\"" + std::to_string(tests) + "\" failures=\"" + std::to_string(failures) + "\" errors=\"" +
           std::to_string(errors) + "\" skipped=\"" + std::to_string(skipped) + "\">\n" + cases + "  </testsuite>\n";
  }
  return out + "</testsuites>\n";
}

std::string report_gradescope(const Report& report) {
  Json json{{"execution_time", report.seconds}, {"stdout_visibility", "hidden"}, {"output", report.tool}, {"tests", Json::array()}};
  int k = 0;
  for (const CheckResult& r : report.results) {
    Json test{{"name", r.check->id + ": " + r.check->says}, {"number", std::to_string(++k)}};
    if (r.max_points > 0) test["score"] = r.points, test["max_score"] = r.max_points;
    test["status"] = r.verdict == Verdict::pass || r.max_points == 0 ? "passed" : "failed";
    test["output"] = words(r);
    test["output_format"] = "text";
    test["visibility"] = r.visibility;
    test["tags"] = {r.group};
    test["extra_data"] = {{"verdict", name(r.verdict)}};
    json["tests"].push_back(test);
  }
  return written(json, 2) + "\n";
}

std::string gradescope_failure(const std::string& why) {
  const Json test{{"name", "grading"}, {"score", 0}, {"max_score", 1}, {"status", "failed"}, {"output", why}, {"output_format", "text"}, {"visibility", "visible"}};
  return written(Json{{"score", 0}, {"stdout_visibility", "hidden"}, {"tests", Json::array({test})}}, 2) + "\n";
}

std::string report_autolab(const Report& report) {
  Json feedback{{"_presentation", "semantic"}, {"stages", Json::array({"Build"})}};
  bool compiles = true;
  for (const CheckResult& r : report.results) compiles = compiles && r.verdict != Verdict::not_compiled;
  feedback["Build"] = {{"compiles", {{"passed", compiles}}}};
  Json scores = Json::object();
  for (const std::string& part : parts(report)) {
    double sum = 0, most = 0;
    Json stage = Json::object();
    for (const CheckResult& r : report.results) {
      if (r.group != part || r.max_points == 0) continue;
      sum += r.points;
      most += r.max_points;
      if (std::string_view(r.visibility) != "visible") continue;
      Json item{{"passed", r.verdict == Verdict::pass}};
      if (r.verdict != Verdict::pass) item["hint"] = tame(r.diagnosis.empty() ? said_of(r) : r.diagnosis.front().text);
      stage[tame(r.check->id)] = item;
    }
    if (most == 0) continue;  // a part of advice is no problem of Autolab's
    if (!stage.empty()) {
      feedback["stages"].push_back(part);
      feedback[part] = stage;
    }
    scores[tame(part)] = sum;
  }
  return written(feedback) + "\n" + written(Json{{"scores", scores}, {"scoreboard", Json::array({report.score})}}) + "\n";
}

std::string autolab_failure(const std::string& why, const std::vector<std::string>& groups) {
  Json scores = Json::object();
  for (const std::string& part : groups) scores[tame(part)] = 0;
  const Json feedback{{"_presentation", "semantic"}, {"stages", Json::array({"Build"})}, {"Build", {{"compiles", {{"passed", false}, {"hint", tame(why)}}}}}};
  return written(feedback) + "\n" + written(Json{{"scores", scores}, {"scoreboard", Json::array({0})}}) + "\n";
}

}  // namespace rigor::grader
