#include <cmath>
#include <rigor/studies/convergence.hpp>
#include <rigor/studies/flight.hpp>
#include <rigor/studies/pages.hpp>

namespace rigor::studies {
namespace {

const std::pair<const char*, const char*> quantities[] = {{"attitude", "attitude"}, {"momentum", "L"}, {"energy", "energy"}, {"position", "position"}};

struct Steps {
  std::vector<double> h;
  std::vector<double> of(const Group& g, const char* name) const {
    std::vector<double> values;
    for (const Row* row : g.rows) values.push_back(row->at(name));
    return values;
  }
};
std::string order_text(double order) { return brief(order, "%.2f"); }

// The three finest runs before the rounding floor, coarse to fine; nothing when there are fewer.
std::vector<const Row*> three_of(const Group& g) {
  double floor = INFINITY;
  for (const Row* row : g.rows)
    if (row->at("attitude") > 0) floor = std::fmin(floor, row->at("attitude"));
  std::vector<const Row*> good;
  for (const Row* row : g.rows)
    if (row->at("attitude") < 0.1 && row->at("attitude") > (floor < 1e-12 ? 300 * floor : 0)) good.push_back(row);
  if (good.size() < 3) return {};
  return {good.end() - 3, good.end()};
}

}  // namespace

StudyPage convergence_page(const std::vector<Row>& rows) {
  StudyPage page{"Error against step", "Every method's error at the end of the problem over a ladder of steps, against a reference whose own error is stated.", {}, ""};
  for (const Group& problem : by_problem(rows)) {
    Section s = problem_section(problem.rows[0]->cell);
    const double until = (*open_problem(problem.name, problem.rows[0]->cell.until))->until;
    report::Plot plot{"Attitude error against step: " + problem.name, "step h, s", "attitude error at the end, rad", true, true, {}};
    Table fitted{"order, fitted over the asymptotic window (errors below 0.1, and above 300 times the smallest where that is rounding); points used, left out as too coarse, left out as at the floor; -: fewer than three points to fit",
                 {"method", "stated", "attitude", "L", "energy", "position", "used", "coarse", "floor"}, {}, 1};
    const std::vector<std::string> errors{"attitude, rad", "L", "energy", "position, m"};
    Table last{"errors at the finest step", {"method", "h, s"}, {}, 1};
    Table without{"ways without a step: errors by tolerance, or of the closed form", {"method", "tolerance"}, {}, 1};
    for (Table* t : {&last, &without}) t->header.insert(t->header.end(), errors.begin(), errors.end());
    Table pairs{"order from one step to its half (attitude)", {"method"}, {}, 1};
    Table gci{"three systematically refined results (ASME V&V 20): one entry of the attitude at the end, extrapolated (Richardson); the grid convergence index says how far off the finest is; near 1: asymptotic",
              {"method", "steps", "order", "finest", "extrapolated", "its true error", "GCI, finest", "true error, finest", "near 1"}, {}, 1};
    for (const Group& g : by_method(problem.rows)) {
      const auto errors_line = [](const Row& row, const std::string& setting) {
        std::vector<std::string> line{row.cell.method, setting};
        for (const auto& [name, heading] : quantities) line.push_back(brief(row.at(name)));
        return line;
      };
      if (g.rows[0]->cell.steps == 0) {  // no step to have an order in
        for (const Row* row : g.rows) without.rows.push_back(errors_line(*row, row->cell.tolerance > 0 ? brief(row->cell.tolerance, "%.0e") : "-"));
        continue;
      }
      Steps ladder;
      for (const Row* row : g.rows) ladder.h.push_back(until / double(row->cell.steps));
      report::Series series{g.name, ladder.h, ladder.of(g, "attitude")};
      plot.series.push_back(series);
      const Method* method = find_stepper(g.name);
      const bool free = (*open_problem(problem.name, problem.rows[0]->cell.until))->falls.has_value();
      const int stated = method == nullptr ? 0 : free ? method->order : method->forced_order;
      std::vector<std::string> line{g.name, stated > 0 ? std::to_string(stated) : "-"};
      for (const auto& [name, heading] : quantities) line.push_back(order_text(fit_order(ladder.h, ladder.of(g, name)).order));
      const Fit fit = fit_order(ladder.h, ladder.of(g, "attitude"));
      for (const int n : {fit.used, fit.too_coarse, fit.at_floor}) line.push_back(std::to_string(n));
      fitted.rows.push_back(line);
      last.rows.push_back(errors_line(*g.rows.back(), brief(ladder.h.back(), "%.3g")));
      line = {g.name};
      for (std::size_t i = 1; i < g.rows.size(); ++i) {
        if (pairs.header.size() < g.rows.size()) pairs.header.push_back(std::to_string(g.rows[i - 1]->cell.steps) + "-" + std::to_string(g.rows[i]->cell.steps));
        line.push_back(order_text(std::log(g.rows[i - 1]->at("attitude") / g.rows[i]->at("attitude")) / std::log(ladder.h[i - 1] / ladder.h[i])));
      }
      if (line.size() > 1) pairs.rows.push_back(line);
      if (const auto three = three_of(g); !three.empty()) {
        const double truth = (*open_problem(problem.name, g.rows[0]->cell.until))->end.R_WB(0, 1);
        const double f1 = three[2]->at("probe"), f2 = three[1]->at("probe"), f3 = three[0]->at("probe");
        const Gci r = grid_convergence(f1, f2, f3, double(three[2]->cell.steps) / double(three[1]->cell.steps));
        gci.rows.push_back({g.name, std::to_string(three[2]->cell.steps), order_text(r.order), brief(f1, "%.9f"), brief(r.extrapolated, "%.9f"), brief(std::fabs(r.extrapolated - truth)), brief(r.fine),
                            brief(std::fabs((f1 - truth) / f1)), brief(r.asymptotic, "%.3f")});
      }
    }
    for (auto& row : pairs.rows) row.resize(pairs.header.size(), "");
    if (!plot.series.empty()) s.plots = {plot};
    for (const Table& t : {fitted, last, without, pairs, gci})
      if (!t.rows.empty()) s.tables.push_back(t);
    page.sections.push_back(s);
  }
  return page;
}

}  // namespace rigor::studies
