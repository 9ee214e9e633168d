#pragma once
#include <rigor/base/outcome.hpp>
#include <rigor/integrators/method.hpp>

namespace rigor {

/// Dormand and Prince 1980, the pair of orders 5 and 4, on (p, v, q, ω_B). Equal steps: six evaluations, order 5.
Motion step_dormand_prince(const Cuboid<double>& body, const Motion& now, const Load& load, double h);
Motion step_dormand_prince_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h);

/// What a flight with error control gave and cost.
struct Flown {
  State<double> end;
  long steps = 0, rejected = 0, evaluations = 0;
};

/// From t0 to t1 (either may be the later) with steps that keep the estimated error of each below `tolerance` times
/// (1 + |y|), component by component. That is an error per step: the flight's is larger, about 10 to 100 times.
/// Faults: out_of_range for a tolerance outside [1e-14, 1e-1]: below it the estimate is rounding; not_finite for a time
/// that is no number; unsupported, "step", when the solution cannot be followed: a load that is no number, or that jumps so
/// that the step goes down to rounding.
Outcome<Flown> fly_dormand_prince(const Cuboid<double>& body, const State<double>& start, const LoadAt& load, double t0, double t1, double tolerance);

}  // namespace rigor
