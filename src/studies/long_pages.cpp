// The pages of drift, stability and contact.
#include <algorithm>
#include <cmath>
#include <rigor/studies/contact.hpp>
#include <rigor/studies/convergence.hpp>
#include <rigor/studies/drift.hpp>
#include <rigor/studies/pages.hpp>

namespace rigor::studies {
namespace {

// Order of the errors of halved steps, coarse to fine, its interval of 95 %, and the runs by their place: the window is that of the convergence
// study, but for where an order settles, since errors through impacts are not smooth in the step.
std::vector<std::string> order_line(const report::Series& errors) {
  const Fit fit = fit_order(errors.x, errors.y, false);
  const std::vector<Place> place = places(errors.x, errors.y, 300, false);
  std::vector<double> logs;
  std::size_t first = 0, last = 0;
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (place[i] != Place::used) continue;
    if (logs.empty()) first = i;
    last = i;
    logs.push_back(std::log2(errors.y[i]));
  }
  const bool equally_spaced = !logs.empty() && last - first + 1 == logs.size();
  std::vector<std::string> line{errors.name, brief(fit.order, "%.2f"), equally_spaced ? brief(slope_of(logs).half_width, "%.2f") : "-"};
  for (const int n : {fit.used, fit.too_coarse, fit.at_floor, fit.failed}) line.push_back(std::to_string(n));
  return line;
}

}  // namespace

StudyPage drift_page(const std::vector<Row>& rows) {
  StudyPage page{"Drift", "What a long free flight loses: the problem's body without load, at a constant step.", {}, ""};
  for (const Group& problem : by_problem(rows)) {
    Section s = problem_section(problem.rows[0]->cell);
    s.text.push_back("The centre goes straight on at (0.3, -0.2, 0.1) m/s. The rate is the slope of the energy over forty equal stretches, with its interval of 95 %: a rate whose interval holds 0 is no drift. "
                     "\"Carried\" sums the ways of the steps with the roundings carried along (Neumaier), \"plain\" as the method does. L is the method's own, in world axes: one that has it as its variable keeps it to the bit, "
                     "whatever its attitude and spin make of it.");
    const Cell& c = problem.rows[0]->cell;
    Table t{std::to_string(c.steps) + " steps of " + digits(c.x) + " s",
            {"method", "sum", "worst |E/E0 - 1|", "jitter", "rate of E, 1/s", "+-", "worst |L - L0|/|L0|", "worst |R'R - 1|", "position, of the way"}, {}, 2};
    for (const Row* row : problem.rows) {
      std::vector<std::string> line{row->cell.method, row->cell.compensated ? "carried" : "plain"};
      for (const char* name : {"energy", "energy_jitter", "energy_rate", "energy_rate_95", "momentum", "orthonormality", "position"}) line.push_back(brief(row->at(name)));
      t.rows.push_back(line);
    }
    s.tables = {t};
    page.sections.push_back(s);
  }
  return page;
}

StudyPage stability_page(const std::vector<Row>& rows) {
  StudyPage page{"Stability", "Where a method holds: + stable, o inaccurate, - unstable.", {}, ""};
  for (const Group& problem : by_problem(rows)) {
    const Map* map = find_map(problem.name);
    if (map == nullptr) {
      Section angles = problem_section(problem.rows[0]->cell);
      Table t{"largest step, as an angle, that 10000 steps survive with their energy within a tenth (0: none from 0.001 on)", {"method", "|w| h, rad"}, {}, 1};
      for (const Row* row : problem.rows) t.rows.push_back({row->cell.method, brief(row->at("angle"), "%.3g")});
      angles.tables = {t};
      page.sections.push_back(angles);
      continue;
    }
    Section s{problem.name + ": " + map->says, {}, {}, {}, {}, {}};
    const char* criterion = problem.name == "mass" ? "Unstable: a cube flies off or falls through the floor within 4 s. Inaccurate: an overlap above 1 cm."
                                                   : "10000 steps. Unstable: it leaves the numbers, or its energy leaves a tenth. Inaccurate: stable, but the attitude is off by more than 0.1 rad after one turn.";
    Table stable{"largest " + map->x + ", up to which every step of the map is stable, by " + map->y + "; -: not even the smallest. " + criterion, {"method"}, {}, 1};
    for (const double y : map->ys) stable.header.push_back(digits(y));
    Table accurate = stable;
    accurate.caption = "the same, neither unstable nor inaccurate";
    std::vector<Table> grids;
    for (const Group& method : by_method(problem.rows)) {
      Table grid{method.name + ": + stable, o inaccurate, - unstable; down: " + map->y + "; across: " + map->x, {""}, {}, 1};
      for (const double x : map->xs) grid.header.push_back(brief(x, "%.3g"));
      for (Table* t : {&stable, &accurate}) t->rows.push_back({method.name});
      for (const double y : map->ys) {
        double stable_to = NAN, accurate_to = NAN;
        bool still_stable = true, still_accurate = true;
        grid.rows.push_back({digits(y)});
        for (const double x : map->xs) {
          std::string mark = "";
          for (const Row* row : method.rows)
            if (row->cell.x == x && row->cell.y == y) mark = row->at("verdict") == 0 ? "+" : row->at("verdict") == 1 ? "o" : "-";
          still_stable &= mark == "+" || mark == "o";
          still_accurate &= mark == "+";
          if (still_stable) stable_to = x;
          if (still_accurate) accurate_to = x;
          grid.rows.back().push_back(mark);
        }
        stable.rows.back().push_back(brief(stable_to, "%.3g"));
        accurate.rows.back().push_back(brief(accurate_to, "%.3g"));
      }
      grids.push_back(grid);
    }
    s.tables = {stable, accurate};
    s.tables.insert(s.tables.end(), grids.begin(), grids.end());
    page.sections.push_back(s);
  }
  return page;
}

StudyPage contact_page(const std::vector<Row>& rows) {
  StudyPage page{"Contact", "Impacts, sliding and stopping against closed forms: the assignment's stepper beside located mode, which finds every impact at its time.", {}, ""};
  for (const Group& problem : by_problem(rows)) {
    const ContactProblem* known = nullptr;
    for (const ContactProblem& p : contact_problems())
      if (p.name == problem.name) known = &p;
    Section s{problem.name, {known->says + (known->says.ends_with("?") ? "" : "."), "Answer: " + known->answer + "."}, {}, {}, {}, {}};
    const bool swept = known->sweep.size() > 1;
    report::Plot plot{(swept ? "Worst error against step: " : "Error against step: ") + problem.name, "step, s", (swept ? "worst error of the sweep, " : "error, ") + known->unit, true, true, {}};
    Table t{swept ? "worst error over the sweep, and of the energy ledger" : "error, and the energy ledger", {"method", "steps/s", (swept ? "worst error, " : "error, ") + known->unit}, {}, 1};
    if (swept) t.header.push_back("at " + known->x);
    t.header.insert(t.header.end(), {"steps' own, J", "impacts"});
    Table orders{"order of the error, fitted, with its interval of 95 %; runs used, left out as too coarse (0.1 and more), left out as at rounding, failed; -: fewer than three runs to fit. "
                 "Where in its step an impact falls is chance: errors scatter about their order, and half a step may see it no sooner",
                 {"method", "order", "+-", "used", "coarse", "floor", "failed"}, {}, 1};
    Table sweep{"error, " + known->unit + ", by " + known->x, {known->x}, {}, 1};
    std::vector<std::vector<double>> columns;
    for (const Group& method : by_method(problem.rows)) {
      report::Series series{method.name, {}, {}};
      std::vector<long> steps;
      for (const Row* row : method.rows)
        if (std::find(steps.begin(), steps.end(), row->cell.steps) == steps.end()) steps.push_back(row->cell.steps);
      for (const long n : steps) {
        double worst = 0, at = 0, ledger = std::nan(""), impacts = std::nan("");
        for (const Row* row : method.rows) {
          if (row->cell.steps != n) continue;
          if (!std::isnan(worst) && !(row->at("error") <= worst)) worst = row->at("error"), at = row->cell.x;  // one that failed is the worst
          ledger = std::fmax(ledger, row->at("own_J"));  // of two the number, where one is none
          impacts = std::fmax(impacts, row->at("impacts"));
        }
        t.rows.push_back({method.name, n > 0 ? std::to_string(n) : "-", brief(worst)});
        if (swept) t.rows.back().push_back(digits(at));
        t.rows.back().insert(t.rows.back().end(), {brief(ledger), brief(impacts, "%.0f")});
        if (n > 0) series.x.push_back(1 / double(n)), series.y.push_back(worst);
      }
      if (series.x.size() > 1) {
        orders.rows.push_back(order_line(series));
        plot.series.push_back(series);
      }
      if (swept) {
        sweep.header.push_back(method.name + (steps.back() > 0 ? ", " + std::to_string(steps.back()) + "/s" : ""));
        columns.emplace_back();
        for (const double x : known->sweep)
          for (const Row* row : method.rows)
            if (row->cell.x == x && row->cell.steps == steps.back()) columns.back().push_back(row->at("error"));
      }
    }
    s.plots = {plot};
    s.tables = {t};
    if (!orders.rows.empty()) s.tables.push_back(orders);
    if (!columns.empty()) {
      for (std::size_t i = 0; i < known->sweep.size(); ++i) {
        std::vector<std::string> line{digits(known->sweep[i])};
        for (const auto& column : columns) line.push_back(i < column.size() ? brief(column[i]) : "");
        sweep.rows.push_back(line);
      }
      s.tables.push_back(sweep);
    }
    page.sections.push_back(s);
  }
  return page;
}

}  // namespace rigor::studies
