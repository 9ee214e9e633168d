#include <cmath>
#include <nlohmann/json.hpp>
#include <rigor/grader/report.hpp>

namespace rigor::grader {
namespace {

using Json = nlohmann::ordered_json;

// JSON has no word for what is not finite.
Json number(double x) {
  if (std::isnan(x)) return "nan";
  if (std::isinf(x)) return x > 0 ? "inf" : "-inf";
  return x;
}

Json counterexample(const Counterexample& e) {
  Json inputs = Json::object(), got = Json::object(), want = Json::object(), bound = Json::object();
  for (const auto& [what, value] : named_inputs(e)) inputs[what] = value;
  for (const Component& c : e.judgement.components) {
    const std::string key = c.name + " [" + c.unit + "]";
    got[key] = number(c.got);
    want[key] = number(c.want);
    bound[key] = number(c.bound);
  }
  Json json{{"case", e.number}, {"inputs", inputs}, {"got", got}, {"want", want}, {"bound", bound}};
  if (!e.death.empty()) json["death"] = e.death;
  return json;
}

}  // namespace

std::string report_json(const Report& report) {
  Json json{{"schema", "rigor.report/1"},
            {"tool", report.tool},
            {"tool_hash", report.tool_hash},
            {"rubric", report.rubric_title},
            {"rubric_hash", report.rubric_hash},
            {"submission", {{"name", report.submission}, {"path", report.submission_path}, {"hash", report.submission_hash}}},
            {"kit_hash", report.kit_hash},
            {"seed", report.seed},
            {"cases", report.cases},
            {"isolation", report.isolation},
            {"notes", report.notes},
            {"score", report.score},
            {"max_score", report.max_score}};
  json["checks"] = Json::array();
  for (const CheckResult& r : report.results) {
    Json check{{"id", r.check->id},
               {"group", r.group},
               {"visibility", r.visibility},
               {"function", student_function_name(r.check->function)},
               {"formula", r.check->formula},
               {"says", r.check->says},
               {"verdict", name(r.verdict)},
               {"points", r.points},
               {"max_points", r.max_points},
               {"cases", r.cases},
               {"worst_ratio", number(r.worst_ratio)},
               {"words", r.words},
               {"notes", r.notes}};
    check["counterexample"] = r.counterexample ? counterexample(*r.counterexample) : Json();
    check["replay"] = r.verdict == Verdict::pass || !r.counterexample ? Json() : Json(replay_command(report, r));
    check["diagnosis"] = Json::array();
    for (const Diagnosis& d : r.diagnosis)
      check["diagnosis"].push_back({{"id", d.id}, {"text", d.text}, {"agreements", d.agreements}, {"cases", d.cases}});
    json["checks"].push_back(check);
  }
  json["output"] = report.output;
  json["seconds"] = report.seconds;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace rigor::grader
