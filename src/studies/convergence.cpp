#include <time.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <rigor/base/interrupt.hpp>
#include <rigor/studies/convergence.hpp>

namespace rigor::studies {
namespace {

double cpu_now() {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

}  // namespace

State<double> integrate(const Problem& problem, const Method& method, long steps) {
  const double h = problem.until / double(steps);
  Motion m = motion_of(problem.body, problem.start);
  for (long k = 0; k < steps; ++k) m = method.step(problem.body, m, problem.load_at((double(k) + 0.5) * h, m.state), h);
  return m.state;
}

Ladder converge(const Problem& problem, const Method& method, long coarsest, int rungs, int repeats) {
  Ladder ladder{&method, &problem, {}, std::numeric_limits<double>::quiet_NaN(), 0};
  long steps = coarsest;
  for (int rung = 0; rung < rungs && interrupted() == 0; ++rung, steps *= 2) {
    std::vector<double> times;
    State<double> end;
    for (int k = 0; k < repeats; ++k) {
      const double start = cpu_now();
      end = integrate(problem, method, steps);
      times.push_back(cpu_now() - start);
    }
    std::nth_element(times.begin(), times.begin() + long(times.size()) / 2, times.end());
    ladder.runs.push_back({steps, problem.until / double(steps), errors_of(problem, end), times[times.size() / 2]});
  }
  ladder.order = fitted_order(ladder.runs, ladder.used);
  return ladder;
}

double fitted_order(const std::vector<Run>& runs, int& used) {
  double floor = std::numeric_limits<double>::infinity();
  for (const Run& r : runs)
    if (r.error.attitude > 0) floor = std::fmin(floor, r.error.attitude);
  // above rounding (300 times what the ladder reached, where it reached rounding) and below the pre-asymptotic range
  const double low = floor < 1e-12 ? 300 * floor : 0, high = 1e-1;
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const Run& r : runs) {
    if (!(r.error.attitude > low && r.error.attitude < high)) continue;
    const double a = std::log2(r.h), b = std::log2(r.error.attitude);
    n += 1, x += a, y += b, xx += a * a, xy += a * b;
  }
  used = int(n);
  return n < 3 ? std::numeric_limits<double>::quiet_NaN() : (n * xy - x * y) / (n * xx - x * x);
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
