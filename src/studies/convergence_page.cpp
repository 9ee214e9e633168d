#include <algorithm>
#include <cmath>
#include <rigor/studies/convergence.hpp>
#include <rigor/studies/flight.hpp>
#include <rigor/studies/pages.hpp>

namespace rigor::studies {
namespace {

const std::pair<const char*, const char*> quantities[] = {{"attitude", "attitude"}, {"momentum", "L"}, {"energy", "energy"}, {"position", "position"}};

std::vector<double> values_of(const Group& g, const char* name) {
  std::vector<double> values;
  for (const Row* row : g.rows) values.push_back(row->at(name));
  return values;
}
// Of steps whose attitude is off by a large angle no other error says anything either.
std::vector<double> asymptotic_values_of(const Group& g, const char* name) {
  std::vector<double> values = values_of(g, name);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (g.rows[i]->at("attitude") >= 0.1) values[i] = INFINITY;
  return values;
}
std::string order_text(double order) { return brief(order, "%.2f"); }
std::string order_text(const std::vector<double>& h, const std::vector<double>& error) {
  const Fit fit = fit_order(h, error);
  const bool exact = std::all_of(error.begin(), error.end(), [](double e) { return !(e > 0) || std::isinf(e); });
  return fit.used == 0 && fit.at_floor > 0 && !exact ? "floor" : order_text(fit.order);
}

// The three finest runs before the rounding floor, coarse to fine, each with as many more steps as the one before; nothing when there are fewer.
std::vector<const Row*> three_of(const Group& g, const std::vector<Place>& place) {
  std::vector<const Row*> good;
  for (std::size_t i = 0; i < place.size(); ++i)
    if (place[i] == Place::used) good.push_back(g.rows[i]);
  if (good.size() < 3) return {};
  good.erase(good.begin(), good.end() - 3);
  const long n[] = {good[0]->cell.steps, good[1]->cell.steps, good[2]->cell.steps};
  if (n[1] * n[1] != n[0] * n[2]) return {};
  return good;
}

}  // namespace

StudyPage convergence_page(const std::vector<Row>& rows) {
  StudyPage page{"Error against step", "Every method's error at the end of the problem over a ladder of steps, against a reference whose own error is stated.", {}, ""};
  for (const Group& problem : by_problem(rows)) {
    Section s = problem_section(problem.rows[0]->cell);
    s.text.push_back("Errors of L are those of R I R'w at the end, in world axes. A method that has L as its variable keeps that to the bit, and may yet be off here: the spin of "
                     "euler-momentum and euler-momentum-cross is that of the attitude one step before.");
    const Problem& opened = **open_problem(problem.name, problem.rows[0]->cell.until);
    const double until = opened.until;
    report::Plot plot{"Attitude error against step: " + problem.name, "step h, s", "attitude error at the end, rad", true, true, {}};
    Table fitted{"order, fitted over the asymptotic window: attitude within 0.1 rad, from where the order settles (0.3) to 300 times the smallest error where that is rounding; runs used, left out as too coarse, left out as at the floor; floor: all runs are at rounding, which has no order; -: fewer than three runs to fit, or runs on no line (standard error of the slope above 0.3)",
                 {"method", "stated", "attitude", "L", "energy", "position", "used", "coarse", "floor"}, {}, 1};
    const bool failures = std::any_of(problem.rows.begin(), problem.rows.end(), [](const Row* row) { return row->cell.steps > 0 && !row->failed.empty(); });
    if (failures) fitted.header.push_back("failed");
    const std::vector<std::string> errors{"attitude, rad", "L", "energy", "position, m"};
    Table last{"errors at the finest step; L and energy relative", {"method", "h, s"}, {}, 1};
    Table without{"ways without a step: errors by tolerance, or of the closed form; L and energy relative", {"method", "tolerance"}, {}, 1};
    for (Table* t : {&last, &without}) t->header.insert(t->header.end(), errors.begin(), errors.end());
    Table pairs{"order from one step to its half (attitude); floor: the finer one is within ten times of rounding", {"method"}, {}, 1};
    Table gci{"three systematically refined results (ASME V&V 20): one entry of the attitude at the end, extrapolated (Richardson), no unit; the grid convergence index says how far off the finest is; near 1: needed of results in the asymptotic range, not enough, for any two that are close give it; the order must be the method's, too",
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
      std::vector<double> h;
      for (const Row* row : g.rows) h.push_back(until / double(row->cell.steps));
      const std::vector<double> attitude = values_of(g, "attitude");
      plot.series.push_back({g.name, h, attitude});
      const Method* method = find_stepper(g.name);
      const int stated = method == nullptr ? 0 : opened.falls ? method->order : method->forced_order;
      std::vector<std::string> line{g.name, stated > 0 ? std::to_string(stated) : "-"};
      for (const auto& [name, heading] : quantities) line.push_back(order_text(h, asymptotic_values_of(g, name)));
      const Fit fit = fit_order(h, attitude);
      for (const int n : {fit.used, fit.too_coarse, fit.at_floor}) line.push_back(std::to_string(n));
      if (failures) line.push_back(std::to_string(fit.failed));
      fitted.rows.push_back(line);
      last.rows.push_back(errors_line(*g.rows.back(), brief(h.back(), "%.3g")));
      line = {g.name};
      const std::vector<Place> place = places(h, attitude, 10);
      for (std::size_t i = 1; i < g.rows.size(); ++i) {
        if (pairs.header.size() < g.rows.size()) pairs.header.push_back(std::to_string(g.rows[i - 1]->cell.steps) + "-" + std::to_string(g.rows[i]->cell.steps));
        line.push_back(place[i] == Place::at_floor ? "floor" : order_text(std::log(attitude[i - 1] / attitude[i]) / std::log(h[i - 1] / h[i])));
      }
      if (line.size() > 1) pairs.rows.push_back(line);
      if (const auto three = three_of(g, places(h, attitude)); !three.empty()) {
        const double truth = opened.end.R_WB(0, 1);
        const double f1 = three[2]->at("probe"), f2 = three[1]->at("probe"), f3 = three[0]->at("probe");
        const Gci r = grid_convergence(f1, f2, f3, double(three[2]->cell.steps) / double(three[1]->cell.steps));
        gci.rows.push_back({g.name, std::to_string(three[2]->cell.steps), order_text(r.order), brief(f1, "%.9f"), brief(r.extrapolated, "%.9f"), brief(std::fabs(r.extrapolated - truth)), brief(r.fine),
                            brief(std::fabs((f1 - truth) / f1)), brief(r.asymptotic, "%.3f")});
      }
    }
    for (auto& row : pairs.rows) row.resize(pairs.header.size(), "");
    set_aside(plot);
    if (!plot.series.empty()) s.plots = {plot};
    for (const Table& t : {fitted, last, without, pairs, gci})
      if (!t.rows.empty()) s.tables.push_back(t);
    page.sections.push_back(s);
  }
  return page;
}

}  // namespace rigor::studies
