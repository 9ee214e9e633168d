#pragma once
#include <rigor/integrators/method.hpp>

namespace rigor {

/// Taylor series of order 16 of (ω_B, q): Euler's equations with a quaternion are quadratic, so the coefficients follow
/// from Cauchy products. Order 16 on a free body; a held torque is given in two half kicks.
Motion step_taylor16(const Cuboid<double>& body, const Motion& now, const Load& load, double h);

/// As the free flow between kicks of the load, seventeen of each. Order 8.
Motion step_taylor16_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h);

/// Without load, many steps at a time.
Motion fly_taylor16(const Cuboid<double>& body, const Motion& now, double h, long steps);

}  // namespace rigor
