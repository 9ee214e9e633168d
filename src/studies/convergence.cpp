#include <algorithm>
#include <cmath>
#include <limits>
#include <rigor/base/interrupt.hpp>
#include <rigor/studies/convergence.hpp>
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

Fit fit_order(const std::vector<double>& h, const std::vector<double>& error) {
  double floor = std::numeric_limits<double>::infinity();
  for (const double e : error)
    if (e > 0) floor = std::fmin(floor, e);
  // above rounding (300 times what the ladder reached, where it reached rounding) and below the pre-asymptotic range
  const double low = floor < 1e-12 ? 300 * floor : 0, high = 1e-1;
  Fit fit{std::numeric_limits<double>::quiet_NaN(), 0, 0, 0};
  double x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < h.size(); ++i) {
    if (!(error[i] > low && error[i] < high)) {
      ++(error[i] <= low ? fit.at_floor : fit.too_coarse);
      continue;
    }
    const double a = std::log2(h[i]), b = std::log2(error[i]);
    ++fit.used, x += a, y += b, xx += a * a, xy += a * b;
  }
  const double n = fit.used;
  if (fit.used >= 3) fit.order = (n * xy - x * y) / (n * xx - x * x);
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
