#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <rigor/base/interrupt.hpp>
#include <rigor/grader/audit.hpp>
#include <rigor/grader/judge.hpp>
#include <rigor/grader/misconceptions.hpp>
#include <set>

namespace rigor::grader {
namespace {

Report judged(const std::string& ids, std::uint64_t seed, int cases) {
  const Habits habits = habits_with(ids);
  Rubric rubric;
  rubric.seed = seed;
  rubric.cases = cases;
  Report report;
  judge([&](const Call& call) -> Answer { return model_answer(habits, call.constants, call.request); },
        std::array<FunctionStatus, student_functions>{}, rubric, {}, report);
  return report;
}

void take(AuditRow& row, const Report& report, bool first, std::vector<int>& shown) {
  std::set<std::string> names;
  bool failed = false;
  for (const CheckResult& r : report.results) {
    if (r.verdict == Verdict::pass || r.max_points == 0) continue;
    failed = true;
    if (first) row.checks.push_back(r.check->id);
    if (r.counterexample) shown.push_back(r.counterexample->number + 1);
    for (const Diagnosis& d : r.diagnosis)
      if (d.id != "relation") names.insert(d.id);
  }
  row.failed = row.failed && failed;
  if (names != std::set<std::string>{row.id}) row.named_right = false;
  for (const std::string& name : names)
    if (name != row.id) row.named_wrong = name;
}

}  // namespace

int Audit::failed() const {
  return int(std::count_if(misconceptions.begin(), misconceptions.end(), [](const AuditRow& r) { return r.failed; }));
}
int Audit::named_right() const {
  return int(std::count_if(misconceptions.begin(), misconceptions.end(), [](const AuditRow& r) { return r.named_right; }));
}
int Audit::named_wrong() const {
  return int(std::count_if(misconceptions.begin(), misconceptions.end(), [](const AuditRow& r) { return !r.named_wrong.empty(); }));
}
int Audit::right_full_marks() const {
  return int(std::count_if(variants.begin(), variants.end(), [](const auto& v) { return v.second == 100; }));
}
bool Audit::holds() const {
  const int all = int(misconceptions.size());
  return failed() == all && named_right() * 100 >= 95 * all && named_wrong() == 0 && right_full_marks() == int(variants.size());
}

Audit audit(int seeds, int cases) {
  Audit result;
  result.seeds = seeds;
  result.cases = cases;
  for (const Misconception& m : misconceptions()) {
    if (interrupted() != 0) return result;
    AuditRow row;
    row.id = m.id;
    row.text = m.text;
    std::vector<int> shown;
    for (int seed = 1; seed <= seeds; ++seed) take(row, judged(m.id, std::uint64_t(seed), cases), seed == 1, shown);
    if (!shown.empty()) {
      std::sort(shown.begin(), shown.end());
      row.median_cases = shown[shown.size() / 2];
      row.worst_cases = shown.back();
    }
    result.misconceptions.push_back(row);
  }
  for (const Misconception& v : variants()) {
    double lowest = 100;
    for (int seed = 1; seed <= seeds && interrupted() == 0; ++seed) lowest = std::min(lowest, judged(v.id, std::uint64_t(seed), cases).score);
    result.variants.push_back({v.id, lowest});
  }
  return result;
}

std::string audit_text(const Audit& audit) {
  std::string out = "misconception                    fails  named  cases needed (median, worst)  checks\n";
  char line[256];
  for (const AuditRow& r : audit.misconceptions) {
    std::string checks;
    for (const std::string& id : r.checks) checks += (checks.empty() ? "" : " ") + id;
    std::snprintf(line, sizeof line, "%-32s %-6s %-6s %4.0f %4d   %s\n", r.id.c_str(), r.failed ? "yes" : "NO",
                  r.named_right ? "yes" : r.named_wrong.empty() ? "-" : "WRONG", r.median_cases, r.worst_cases, checks.c_str());
    out += line;
  }
  out += "\nlegitimate readings (must get 100)\n";
  for (const auto& [id, score] : audit.variants) {
    std::snprintf(line, sizeof line, "%-32s %g\n", id.c_str(), score);
    out += line;
  }
  std::snprintf(line, sizeof line, "\n%zu misconceptions: %d fail, %d named right, %d named wrong; %d of %zu readings with full marks; %d seeds, %d cases a check\n",
                audit.misconceptions.size(), audit.failed(), audit.named_right(), audit.named_wrong(), audit.right_full_marks(), audit.variants.size(), audit.seeds, audit.cases);
  return out + line;
}

std::string audit_json(const Audit& audit) {
  nlohmann::ordered_json json{{"misconceptions", audit.misconceptions.size()}, {"failed", audit.failed()}, {"named_right", audit.named_right()},
                              {"named_wrong", audit.named_wrong()}, {"right_variants", audit.variants.size()}, {"right_full_marks", audit.right_full_marks()},
                              {"seeds", audit.seeds}, {"cases", audit.cases}, {"table", nlohmann::ordered_json::array()}};
  for (const AuditRow& r : audit.misconceptions)
    json["table"].push_back({{"id", r.id}, {"failed", r.failed}, {"named_right", r.named_right}, {"named_wrong", r.named_wrong}, {"checks", r.checks},
                             {"median_cases", r.median_cases}, {"worst_cases", r.worst_cases}});
  return json.dump(2) + "\n";
}

}  // namespace rigor::grader
