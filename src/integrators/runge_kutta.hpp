#pragma once
#include <rigor/integrators/method.hpp>

namespace rigor {

/// The classical four-stage method on (p, v, q, ω_B), the quaternion normalised once a step. Order 4.
Motion step_rk4(const Cuboid<double>& body, const Motion& now, const Load& load, double h);

}  // namespace rigor
