#include <algorithm>
#include <cmath>
#include <rigor/base/promise.hpp>
#include <rigor/studies/flight.hpp>
#include <rigor/studies/pages.hpp>

namespace rigor::studies {

StudyPage study_page(const std::string& kind, const std::vector<Row>& rows, const std::string& command, std::size_t cells) {
  struct Kind {
    const char* name;
    StudyPage (*make)(const std::vector<Row>&);
  };
  constexpr Kind kinds[] = {{"convergence", convergence_page}, {"work-precision", work_page}, {"drift", drift_page}, {"stability", stability_page}, {"contact", contact_page}};
  for (const Kind& k : kinds)
    if (kind == k.name) {
      StudyPage page = k.make(rows);
      page.command = command;
      if (rows.size() < cells) page.unfinished = std::to_string(rows.size()) + " of " + std::to_string(cells) + " cells; interrupted";
      Section gone{"Failures", {}, {}, {}, {}, {}};
      Table failures{"runs that failed: they are rows without numbers above", {"problem", "method", "steps", "tolerance", "why"}, {}, 5};
      for (const Row& row : rows) {
        const std::vector<std::string> line{row.cell.problem, row.cell.method, std::to_string(row.cell.steps), digits(row.cell.tolerance), row.failed};
        const bool said = !failures.rows.empty() && failures.rows.back() == line;  // drift: of both sums
        if (!row.failed.empty() && !said) failures.rows.push_back(line);
      }
      if (!failures.rows.empty()) {
        gone.tables.push_back(failures);
        page.sections.push_back(gone);
      }
      return page;
    }
  promise(false, "a study is of one of the kinds");
  return {};
}

namespace {
template <class Name>
std::vector<Group> grouped(const std::vector<const Row*>& rows, Name name) {
  std::vector<Group> groups;
  for (const Row* row : rows) {
    const std::string key = name(*row);
    auto it = std::find_if(groups.begin(), groups.end(), [&](const Group& g) { return g.name == key; });
    if (it == groups.end()) it = groups.insert(groups.end(), Group{key, {}});
    it->rows.push_back(row);
  }
  return groups;
}
}  // namespace

std::vector<Group> by_problem(const std::vector<Row>& rows) {
  std::vector<const Row*> all;
  for (const Row& row : rows) all.push_back(&row);
  return grouped(all, [](const Row& r) { return r.cell.problem; });
}
std::vector<Group> by_method(const std::vector<const Row*>& rows) {
  return grouped(rows, [](const Row& r) { return r.cell.method; });
}

Section problem_section(const Cell& cell) {
  const Problem& problem = **open_problem(cell.problem, cell.until);
  if (cell.study == "drift" || cell.study == "stability") return {cell.problem, {problem.says + "."}, laws(problem), givens(problem), {}, {}};  // to no end of its own
  return {cell.problem, {problem.says + ", T = " + digits(problem.until) + " s.", "Reference: " + problem.reference + "."}, laws(problem), givens(problem), {}, {}};
}

void set_aside(report::Plot& plot, const std::vector<std::string>& kept) {
  static const std::vector<std::string> families{"sheet", "explicit-euler", "euler-exponential", "rk4", "dormand-prince", "implicit-midpoint", "split3", "split2", "split2-kahan-li8", "moser-veselov8", "taylor16", "exact"};
  if (plot.series.size() <= 16) return;
  const auto in = [](const std::vector<std::string>& names, const std::string& name) { return std::find(names.begin(), names.end(), name) != names.end(); };
  for (report::Series& s : plot.series) s.aside = !in(kept, s.name) && !in(families, s.name) && !s.name.starts_with("submission");
}

const Row* cheapest(const std::vector<const Row*>& rows, double error) {
  const Row* best = nullptr;
  for (const Row* row : rows)
    if (row->at("attitude") <= error && (best == nullptr || row->at("cpu_median") < best->at("cpu_median"))) best = row;
  return best;
}
bool of_a_peer(const Row& row) { return row.cell.method.find('/') != std::string::npos; }

}  // namespace rigor::studies
