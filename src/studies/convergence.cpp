#include <algorithm>
#include <cmath>
#include <limits>
#include <rigor/base/interrupt.hpp>
#include <rigor/studies/convergence.hpp>
#include <rigor/studies/least_squares.hpp>
#include <rigor/studies/timing.hpp>

namespace rigor::studies {
State<double> integrate(const Problem& problem, const Method& method, long steps) {
  const double h = problem.until / double(steps);
  const LoadAt load = [&](double t, const State<double>& s) { return problem.load_at(t, s); };
  Motion m = motion_of(problem.body, problem.start);
  if (!problem.load && method.fly != nullptr) return method.fly(problem.body, m, h, steps).state;
  for (long k = 0; k < steps; ++k) m = advance(method, problem.body, m, load, double(k) * h, h);
  return m.state;
}

Ladder converge(const Problem& problem, const Method& method, long coarsest, int rungs, int repeats) {
  Ladder ladder{&method, &problem, {}, std::numeric_limits<double>::quiet_NaN(), 0};
  long steps = coarsest;
  for (int rung = 0; rung < rungs && interrupted() == 0; ++rung, steps *= 2) {
    std::vector<double> times;
    State<double> end;
    for (int k = 0; k < repeats; ++k) {
      const double start = cpu_seconds();
      end = integrate(problem, method, steps);
      times.push_back(cpu_seconds() - start);
    }
    std::nth_element(times.begin(), times.begin() + long(times.size()) / 2, times.end());
    ladder.runs.push_back({steps, problem.until / double(steps), errors_of(problem, end), times[times.size() / 2]});
  }
  ladder.order = fitted_order(ladder.runs, ladder.used);
  return ladder;
}

std::vector<Place> places(const std::vector<double>& h, const std::vector<double>& error, double margin, bool smooth) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const double e : error)
    if (e >= 0) smallest = std::fmin(smallest, e);
  bool rounding = smallest < 1e-12;
  for (std::size_t i = 1; i < error.size(); ++i) rounding = rounding || (error[i] < 1e-8 && std::log(error[i - 1] / error[i]) < 0.5 * std::log(h[i - 1] / h[i]));
  const double floor = rounding ? margin * std::fmax(smallest, 0x1p-53) : 0;
  std::vector<Place> all;
  bool there = false;
  for (const double e : error) {
    there = there || e <= floor;
    all.push_back(std::isnan(e) ? Place::failed : there ? Place::at_floor : e < 0.1 ? Place::used : Place::too_coarse);
  }
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i] == Place::used) used.push_back(i);
  const auto order = [&](std::size_t k) { return std::log(error[used[k - 1]] / error[used[k]]) / std::log(h[used[k - 1]] / h[used[k]]); };  // from run k - 1 to k
  std::size_t settled = used.size();  // the runs from here on agree on the order
  while (settled > 1 && std::fabs(order(settled - 1) - order(used.size() - 1)) <= 0.3) --settled;
  if (smooth && settled > 0 && used.size() - settled >= 2)
    for (std::size_t k = 0; k + 1 < settled; ++k) all[used[k]] = Place::too_coarse;
  return all;
}
Fit fit_order(const std::vector<double>& h, const std::vector<double>& error, bool smooth) {
  Fit fit{std::numeric_limits<double>::quiet_NaN(), 0, 0, 0, 0};
  const std::vector<Place> place = places(h, error, 300, smooth);
  std::vector<double> x, y;
  for (std::size_t i = 0; i < h.size(); ++i) {
    ++(place[i] == Place::used ? fit.used : place[i] == Place::at_floor ? fit.at_floor : place[i] == Place::failed ? fit.failed : fit.too_coarse);
    if (place[i] == Place::used) x.push_back(std::log2(h[i])), y.push_back(std::log2(error[i]));
  }
  if (fit.used < 3) return fit;
  const Line line = least_squares(x, y);
  if (!smooth || line.standard_error <= 0.3) fit.order = line.slope;
  return fit;
}
double fitted_order(const std::vector<Run>& runs, int& used) {
  std::vector<double> h, error;
  for (const Run& r : runs) h.push_back(r.h), error.push_back(r.error.attitude);
  const Fit fit = fit_order(h, error);
  used = fit.used;
  return fit.order;
}

Gci grid_convergence(double f1, double f2, double f3, double r) {
  Gci g;
  g.order = std::log((f3 - f2) / (f2 - f1)) / std::log(r);
  const double gain = std::pow(r, g.order) - 1;
  g.extrapolated = f1 + (f1 - f2) / gain;
  g.fine = 1.25 * std::fabs((f1 - f2) / f1) / gain;
  g.coarse = 1.25 * std::fabs((f2 - f3) / f2) / gain;
  g.asymptotic = g.coarse / (std::pow(r, g.order) * g.fine);
  return g;
}

}  // namespace rigor::studies
