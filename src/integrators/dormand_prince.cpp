#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <rigor/integrators/dormand_prince.hpp>
#include <rigor/integrators/flat_state.hpp>
#include <string>

namespace rigor {
namespace {

constexpr std::array<double, 7> c{0, 1 / 5., 3 / 10., 4 / 5., 8 / 9., 1, 1};
constexpr std::array<std::array<double, 6>, 7> a{{{},
                                                  {1 / 5.},
                                                  {3 / 40., 9 / 40.},
                                                  {44 / 45., -56 / 15., 32 / 9.},
                                                  {19372 / 6561., -25360 / 2187., 64448 / 6561., -212 / 729.},
                                                  {9017 / 3168., -355 / 33., 46732 / 5247., 49 / 176., -5103 / 18656.},
                                                  {35 / 384., 0, 500 / 1113., 125 / 192., -2187 / 6784., 11 / 84.}}};
// weights of order 5 less those of order 4
constexpr std::array<double, 7> e{71 / 57600., 0, -71 / 16695., 71 / 1920., -17253 / 339200., 22 / 525., -1 / 40.};

struct Step {
  std::array<FlatState, 7> k;
  FlatState end;

  /// From y at t, with k[0] the rate there; the last stage is the end, and its rate the next step's first.
  template <class Rate>
  void take(const Rate& rate, double t, const FlatState& y, double h, std::size_t stages) {
    for (std::size_t i = 1; i < 7; ++i) {
      end = y;
      for (std::size_t j = 0; j < i; ++j) end += h * a[i][j] * k[j];
      if (i < stages) k[i] = rate(t + c[i] * h, end);
    }
  }
  /// The estimated error in parts of what the tolerance allows.
  double error(const FlatState& y, double h, double tolerance) const {
    FlatState off = FlatState::Zero();
    for (std::size_t i = 0; i < 7; ++i) off += h * e[i] * k[i];
    double worst = 0;
    for (int i = 0; i < 13; ++i) {
      const double part = std::fabs(off[i]) / (tolerance * (1 + std::max(std::fabs(y[i]), std::fabs(end[i]))));
      if (std::isnan(part)) return part;
      worst = std::max(worst, part);
    }
    return worst;
  }
};

}  // namespace

Motion step_dormand_prince_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h) {
  const auto rate = [&](double at, const FlatState& y) { return flat_rate(body, load, at, y); };
  const FlatState y = flat_of(now.state);
  Step step;
  step.k[0] = rate(t, y);
  step.take(rate, t, y, h, 6);
  return motion_of(body, state_of(step.end));
}
Motion step_dormand_prince(const Cuboid<double>& body, const Motion& now, const Load& load, double h) {
  return step_dormand_prince_under(body, now, [&](double, const State<double>&) { return load; }, 0, h);
}

Outcome<Flown> fly_dormand_prince(const Cuboid<double>& body, const State<double>& start, const LoadAt& load, double t0, double t1, double tolerance) {
  if (!(tolerance >= 1e-14 && tolerance <= 1e-1)) {
    char written[32];
    std::snprintf(written, sizeof written, "%g", tolerance);
    return Fault{Fault::Kind::out_of_range, "tolerance", std::string("is ") + written + ", must be in [1e-14, 1e-1]: below it the estimate is rounding"};
  }
  if (!std::isfinite(t0) || !std::isfinite(t1)) return Fault{Fault::Kind::not_finite, "time", "from " + std::to_string(t0) + " to " + std::to_string(t1)};
  Flown flown{start};
  if (t0 == t1) return flown;
  const auto rate = [&](double t, const FlatState& y) {
    ++flown.evaluations;
    return flat_rate(body, load, t, y);
  };
  FlatState y = flat_of(start);
  Step step;
  step.k[0] = rate(t0, y);
  const double span = t1 - t0;
  // first guess: a step that changes y by a hundredth of its size
  double t = t0, h = std::copysign(std::min(std::fabs(span), 0.01 * (1 + y.norm()) / (1 + step.k[0].norm())), span);
  bool last = false;
  while (!last) {
    last = std::fabs(t1 - t) <= std::fabs(h) * (1 + 1e-12);
    if (last) h = t1 - t;
    step.take(rate, t, y, h, 7);
    const double error = step.error(y, h, tolerance);
    if (error <= 1) {
      ++flown.steps;
      t = last ? t1 : t + h;
      y = step.end;
      step.k[0] = step.k[6];
    } else {
      ++flown.rejected;
      last = false;
    }
    h *= std::isfinite(error) ? std::clamp(0.9 * std::pow(error, -0.2), 0.2, 5.0) : 0.2;
    if (!last && std::fabs(h) <= 0x1p-50 * std::max(std::fabs(t), 1e-3 * std::fabs(span)))
      return Fault{Fault::Kind::unsupported, "step", "went down to rounding at t = " + std::to_string(t) + " s: the load jumps there or is no number"};
  }
  flown.end = state_of(y);
  return flown;
}

}  // namespace rigor
