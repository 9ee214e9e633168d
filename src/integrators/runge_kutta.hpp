#pragma once
#include <rigor/integrators/method.hpp>

namespace rigor {

/// The classical four-stage method on (p, v, q, ω_B), the quaternion normalised once a step. Order 4.
Motion step_rk4(const Cuboid<double>& body, const Motion& now, const Load& load, double h);
/// The same with the load taken at the four stages, for any load. Order 4.
Motion step_rk4_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h);

/// Without load, many steps at a time.
Motion fly_rk4(const Cuboid<double>& body, const Motion& now, double h, long steps);

}  // namespace rigor
