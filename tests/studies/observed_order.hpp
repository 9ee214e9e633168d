#pragma once
#include <cmath>
#include <cstdio>
#include <rigor/studies/convergence.hpp>
#include <string>

namespace rigor::studies {

/// The order a method shows, fitted to a ladder of steps (each an eighth or a quarter finer than the one before) whose
/// window is found from the errors alone: below 1e-3 and above 300 times the smallest error, where finer steps no longer
/// made it smaller: there it is rounding. What lies outside is counted and printed, not used.
struct Observed {
  double order;
  int used, coarse, rounding;  ///< points in the window, above it, below it
};

template <class Error>
Observed observed_order(const std::string& name, const std::string& problem, int stated, long coarsest, long finest, Error error) {
  std::vector<std::pair<double, double>> points;  // log steps, error
  double floor = 1;
  int risen = 0;
  for (long steps = coarsest; steps <= finest && risen < 4; steps += std::max(1l, steps / (stated < 6 ? 4 : 8))) {
    const double e = error(steps);
    if (!std::isfinite(e)) continue;
    points.emplace_back(std::log(double(steps)), e);
    if (e < 1e-8 && e > 0.8 * floor) ++risen;
    floor = std::fmin(floor, e);
  }
  const double low = risen > 0 ? 300 * floor : 0;
  Observed o{NAN, 0, 0, 0};
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& [a, e] : points) {
    if (e >= 1e-3) ++o.coarse;
    else if (e <= low) ++o.rounding;
    else ++o.used, x += a, y += std::log(e), xx += a * a, xy += a * std::log(e);
  }
  const double n = o.used;
  if (o.used >= 3) o.order = -(n * xy - x * y) / (n * xx - x * x);
  std::printf("%-20s %-13s stated %2d, seen %5.2f from %2d points (%d too coarse, %d at rounding; smallest error %.1e)\n", name.c_str(), problem.c_str(), stated, o.order,
              o.used, o.coarse, o.rounding, floor);
  return o;
}

/// From a step that turns the body by one or two radians.
inline Observed observed_order(const Method& m, const Problem& p, int stated) {
  const long coarsest = stated == 1 ? 1000 : stated == 2 ? 100 : stated < 8 || p.until > 1 ? 8 : 2, finest = stated == 1 ? 60000 : 6000;
  return observed_order(std::string(m.name), p.name, stated, coarsest, finest, [&](long steps) {
    const Errors e = errors_of(p, integrate(p, m, steps));
    return e.attitude + e.position;
  });
}

/// Half a unit at order 8 and above, where few points lie between 1e-3 and rounding.
inline double order_slack(int stated) { return stated >= 8 ? 0.5 : 0.3; }

}  // namespace rigor::studies
