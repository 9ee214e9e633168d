#pragma once
#include <rigor/integrators/method.hpp>

namespace rigor {

/// R stays a product of rotations in all of these; L in world axes is the state and is kept to the bit without torque.

/// Implicit mid-point on the angular momentum, Cayley's map for the attitude; fixed-point iteration to rounding. Order 2,
/// symmetric; keeps the energy to rounding too.
Motion step_implicit_midpoint(const Cuboid<double>& body, const Motion& now, const Load& load, double h);

/// Buss' augmented second-order method: one rotation by h ω + h²/2 ω̇ + h³/12 ω̇ × ω, world axes. Order 2.
Motion step_buss_augmented(const Cuboid<double>& body, const Motion& now, const Load& load, double h);

/// Runge, Kutta and Munthe-Kaas: the classical four stages in the Lie algebra, one exponential of their sum. Order 4.
Motion step_rkmk4(const Cuboid<double>& body, const Motion& now, const Load& load, double h);

/// Commutator-free, four stages, two exponentials. Order 4.
Motion step_commutator_free4(const Cuboid<double>& body, const Motion& now, const Load& load, double h);

/// Under a load that changes. The first two between half kicks, order 2; the others with the load at their four stages, for
/// any load, order 4.
Motion step_implicit_midpoint_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h);
Motion step_buss_augmented_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h);
Motion step_rkmk4_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h);
Motion step_commutator_free4_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h);

/// Without load, many steps at a time.
Motion fly_implicit_midpoint(const Cuboid<double>& body, const Motion& now, double h, long steps);
Motion fly_buss_augmented(const Cuboid<double>& body, const Motion& now, double h, long steps);
Motion fly_rkmk4(const Cuboid<double>& body, const Motion& now, double h, long steps);
Motion fly_commutator_free4(const Cuboid<double>& body, const Motion& now, double h, long steps);

}  // namespace rigor
