#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>
#include <rigor/base/interrupt.hpp>
#include <rigor/grader/audit.hpp>
#include <rigor/grader/misconceptions.hpp>
#include <set>
#include <thread>

namespace rigor::grader {
namespace {

Report judged(const Student& student, const Auditee& auditee, std::uint64_t seed, int cases, const Selection& selection) {
  Rubric rubric;
  rubric.seed = seed;
  rubric.cases = cases;
  Report report;
  judge(student, auditee.functions, rubric, selection, report);
  return report;
}

bool claims(const Check& check, const std::string& id) {
  return std::find(check.claims.begin(), check.claims.end(), id) != check.claims.end();
}

void take(AuditRow& row, const Report& report, bool first, std::vector<int>& shown) {
  std::set<std::string> names;
  bool failed = false;
  for (const CheckResult& r : report.results) {
    if (r.verdict == Verdict::pass && claims(*r.check, row.id)) {
      row.failed = false;
      if (std::find(row.missed.begin(), row.missed.end(), r.check->id) == row.missed.end()) row.missed.push_back(r.check->id);
    }
    if (r.verdict == Verdict::pass) continue;
    failed = true;
    if (first) row.checks.push_back(r.check->id);
    if (r.counterexample) shown.push_back(r.counterexample->number + 1);
    for (const Diagnosis& d : r.diagnosis)
      if (d.id != "relation") names.insert(d.id);
  }
  row.failed = row.failed && failed;
  if (names != std::set<std::string>{row.shown_as}) row.named_right = false;
  if (names.empty()) names.insert("");
  for (const std::string& name : names) ++row.names[name];
}

AuditRow row_of(const Auditee& auditee, const AuditOptions& options, const Selection& selection) {
  AuditRow row;
  row.id = row.shown_as = auditee.id;
  if (const Misconception* m = find_misconception(auditee.id)) {
    row.text = m->text;
    if (!m->same_as.empty()) row.shown_as = m->same_as;
  }
  const Student student = auditee.enter();
  std::vector<int> shown;
  for (int seed = 1; seed <= options.seeds && interrupted() == 0; ++seed)
    take(row, judged(student, auditee, std::uint64_t(seed), options.cases, selection), seed == 1, shown);
  if (!shown.empty()) {
    std::sort(shown.begin(), shown.end());
    row.median_cases = shown[shown.size() / 2];
    row.worst_cases = shown.back();
  }
  return row;
}

AuditReading reading_of(const Auditee& auditee, const AuditOptions& options, const Selection& selection) {
  AuditReading reading{auditee.id, 100, ""};
  const Student student = auditee.enter();
  for (int seed = 1; seed <= options.seeds && interrupted() == 0; ++seed) {
    const Report report = judged(student, auditee, std::uint64_t(seed), options.cases, selection);
    reading.lowest = std::min(reading.lowest, report.score);
    for (const CheckResult& r : report.results)
      if (r.verdict != Verdict::pass && reading.failed.empty()) reading.failed = r.check->id;
  }
  return reading;
}

}  // namespace

bool AuditRow::named_wrong() const {
  return std::any_of(names.begin(), names.end(), [&](const auto& name) { return !name.first.empty() && name.first != shown_as; });
}

int Audit::failed() const {
  return int(std::count_if(misconceptions.begin(), misconceptions.end(), [](const AuditRow& r) { return r.failed; }));
}
int Audit::named_right() const {
  return int(std::count_if(misconceptions.begin(), misconceptions.end(), [](const AuditRow& r) { return r.named_right; }));
}
int Audit::named_wrong() const {
  return int(std::count_if(misconceptions.begin(), misconceptions.end(), [](const AuditRow& r) { return r.named_wrong(); }));
}
int Audit::right_full_marks() const {
  return int(std::count_if(variants.begin(), variants.end(), [](const AuditReading& r) { return r.lowest == 100; }));
}
bool Audit::holds() const {
  const int all = int(misconceptions.size());
  return failed() == all && named_right() * 100 >= 95 * all && named_wrong() == 0 && right_full_marks() == int(variants.size());
}

Audit audit(const std::vector<Auditee>& wrong, const std::vector<Auditee>& right, const AuditOptions& options) {
  const auto begun = std::chrono::steady_clock::now();
  Selection graded;  // advice gives and takes no points
  for (const Check& check : checks())
    if (check.points > 0) graded.only.push_back(check.id);
  std::vector<std::optional<AuditRow>> rows(wrong.size());
  std::vector<std::optional<AuditReading>> readings(right.size());
  std::atomic<std::size_t> next{0};
  int done = 0;
  std::mutex mutex;
  const std::size_t all = wrong.size() + right.size();
  {
    std::vector<std::jthread> threads;
    for (int k = 0; k < options.jobs; ++k)
      threads.emplace_back([&] {
        for (std::size_t i = next++; i < all && interrupted() == 0; i = next++) {
          if (i < wrong.size()) rows[i] = row_of(wrong[i], options, graded);
          else readings[i - wrong.size()] = reading_of(right[i - wrong.size()], options, graded);
          if (interrupted() != 0) {  // it has not seen every seed
            if (i < wrong.size()) rows[i].reset();
            else readings[i - wrong.size()].reset();
            return;
          }
          const std::lock_guard lock(mutex);
          options.progress(++done, int(all));
        }
      });
  }
  Audit result;
  result.seeds = options.seeds;
  result.cases = options.cases;
  for (auto& row : rows)
    if (row) result.misconceptions.push_back(std::move(*row));
  for (auto& reading : readings)
    if (reading) result.variants.push_back(std::move(*reading));
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  return result;
}

}  // namespace rigor::grader
