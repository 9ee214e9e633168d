#pragma once
#include <rigor/integrators/method.hpp>

namespace rigor {

/// Taylor series of order 16 of (ω_B, q): Euler's equations with a quaternion are quadratic, so the coefficients follow
/// from Cauchy products. Order 16 on a free body; the torque is given in two half kicks, order 2 where there is one.
Motion step_taylor16(const Cuboid<double>& body, const Motion& now, const Load& load, double h);

}  // namespace rigor
