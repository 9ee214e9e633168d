#include <cmath>
#include <numeric>
#include <rigor/base/interrupt.hpp>
#include <rigor/linalg/carried.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/studies/drift.hpp>
#include <rigor/studies/least_squares.hpp>

namespace rigor::studies {
namespace {

using V = Vec3<double>;

// Two-sided 95 % of Student's t, by degrees of freedom; above 30 within a hundredth of the normal's.
double student_t(int freedom) {
  constexpr double t[] = {12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228, 2.201, 2.179, 2.160, 2.145, 2.131,
                          2.120,  2.110, 2.101, 2.093, 2.086, 2.080, 2.074, 2.069, 2.064, 2.060, 2.056, 2.052, 2.048, 2.045, 2.042};
  return freedom <= 30 ? t[freedom - 1] : 1.96 + 2.4 / freedom;
}

}  // namespace

Slope slope_of(const std::vector<double>& y) {
  const int n = int(y.size());
  if (n < 3) return {std::nan(""), std::nan("")};
  std::vector<double> x(y.size());
  std::iota(x.begin(), x.end(), 1.0);
  const Line line = least_squares(x, y);
  return {line.slope, student_t(n - 2) * line.standard_error};
}

Drift drift_of(const Problem& problem, const Method& method, double h, long steps, bool compensated) {
  State<double> start = problem.start;
  start.p_WB = zero3<double>();
  start.v_WB = V(0.3, -0.2, 0.1);
  Motion m = motion_of(problem.body, start);
  const V L0 = m.L_W;
  const double E0 = L0.dot(m.state.w_WB) / 2, size = norm<double>(L0), speed = norm<double>(start.v_WB);
  Drift d{&method, h, 0, 0, 0, 0, 0, true};
  double last = 1, sum = 0, squares = 0, stretch_sum = 0;
  const long stretch = std::max(1L, steps / 40);
  std::vector<double> means;
  Carried<double> way[3];
  for (; d.steps < steps && interrupted() == 0; ++d.steps) {
    if (compensated) m.state.p_WB = zero3<double>();
    m = method.step(problem.body, m, {}, h);
    const double energy = m.L_W.dot(m.state.w_WB) / 2 / E0, change = energy - last, skew = orthonormality_defect<double>(m.state.R_WB);
    d.finite = !left_the_numbers(energy) && std::isfinite(skew);
    if (!d.finite) break;
    last = energy;
    sum += change, squares += change * change;
    stretch_sum += energy - 1;
    d.energy = std::fmax(d.energy, std::fabs(energy - 1));
    d.momentum = std::fmax(d.momentum, norm<double>(V(m.L_W - L0)) / size);
    d.orthonormality = std::fmax(d.orthonormality, skew);
    const long double t = static_cast<long double>(h) * (d.steps + 1);
    double off = 0;
    for (int i = 0; i < 3; ++i) {
      if (compensated) way[i] += m.state.p_WB[i];
      const long double x = compensated ? static_cast<long double>(way[i].sum) + way[i].carry : static_cast<long double>(m.state.p_WB[i]);
      off = std::fmax(off, double(std::fabs(x - start.v_WB[i] * t)));
    }
    d.position = std::fmax(d.position, off / (speed * double(t)));
    if ((d.steps + 1) % stretch == 0) means.push_back(stretch_sum / double(stretch)), stretch_sum = 0;
  }
  const double n = double(std::max(1L, d.steps)), mean = sum / n;
  d.energy_jitter = std::sqrt(std::fmax(0, squares / n - mean * mean));
  const Slope slope = slope_of(means);
  d.rate = {slope.value / (double(stretch) * h), slope.half_width / (double(stretch) * h)};
  return d;
}

double stable_angle(const Problem& problem, const Method& method) {
  const double spin = norm<double>(problem.start.w_WB);
  const auto stable = [&](int quarter) {
    const Drift d = drift_of(problem, method, std::exp2(quarter / 4.0) / spin, 10000);
    return d.finite && d.energy <= 0.1;
  };
  int low = -40, high = 24;  // quarters of a power of two
  if (!stable(low)) return 0;
  if (stable(high)) return std::exp2(high / 4.0);
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    (stable(middle) ? low : high) = middle;
  }
  return std::exp2(low / 4.0);
}

Row drift(const Cell& cell) {
  Row row{cell, {}, "", ""};
  const Drift d = drift_of(**open_problem(cell.problem), *find_method(cell.method), cell.x, cell.steps, cell.compensated);
  if (!d.finite) row.failed = "left the numbers after " + std::to_string(d.steps) + " steps";
  const std::pair<const char*, double> seen[] = {{"energy", d.energy},     {"energy_jitter", d.energy_jitter},   {"energy_rate", d.rate.value}, {"energy_rate_95", d.rate.half_width},
                                                 {"momentum", d.momentum}, {"orthonormality", d.orthonormality}, {"position", d.position}};
  for (const auto& [name, value] : seen) row.put(name, d.finite ? value : std::nan(""));
  return row;
}

}  // namespace rigor::studies
