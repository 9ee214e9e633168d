#pragma once
#include <rigor/integrators/method.hpp>
#include <rigor/linalg/rotation.hpp>

namespace rigor {

/// The assignment's step: semi-implicit Euler on (v, ω) with the gyroscopic term, Gram-Schmidt on R. Order 1.
Motion step_sheet(const Cuboid<double>& body, const Motion& now, const Load& load, double h);

/// Everything from the old state, Gram-Schmidt on R. Order 1; gains energy every step (case D-07).
Motion step_explicit_euler(const Cuboid<double>& body, const Motion& now, const Load& load, double h);

/// As the sheet's step, but R + h[ω]ₓR is left as it is: R leaves the rotations (case K-07). Kept to be studied.
Motion step_euler_naive(const Cuboid<double>& body, const Motion& now, const Load& load, double h);

/// As the sheet's step, but R' = exp(h[ω']ₓ) R. Order 1, R a rotation to rounding.
Motion step_euler_exponential(const Cuboid<double>& body, const Motion& now, const Load& load, double h);

/// As the sheet's step, but the attitude is a quaternion: q' = q + h/2 (0, ω') q, then made a unit one. Each step turns by
/// 2 atan(h|ω|/2) in place of h|ω|. Order 1.
Motion step_euler_quaternion(const Cuboid<double>& body, const Motion& now, const Load& load, double h);
/// The quaternion's step before it is made a unit one: longer by √(1 + (h|ω|/2)²) each time (case K-08).
Vec4<double> naive_quaternion_step(double h, const Vec3<double>& w_WB, const Vec4<double>& q_WB);

/// Momentum form: L' = L + h τ, ω' = I⁻¹ L' at the old attitude, R' = GramSchmidt(R + h[ω']ₓ R). Order 1; without
/// torque L stays the same to the bit (case D-08).
Motion step_euler_momentum(const Cuboid<double>& body, const Motion& now, const Load& load, double h);

/// The same with fewer operations: ω' = R I_B⁻¹ Rᵀ L', two columns of R + h[ω']ₓ R repaired, the third their cross product.
/// Order 1; a rotation, never a reflection; without torque L stays the same to the bit.
Motion step_euler_momentum_cross(const Cuboid<double>& body, const Motion& now, const Load& load, double h);

/// The same with R' = R exp(h [I_B⁻¹ RᵀL']ₓ): Euler's method on the group. Order 1; without torque L stays the same to the bit.
Motion step_euler_momentum_exponential(const Cuboid<double>& body, const Motion& now, const Load& load, double h);

/// Without load, many steps at a time: the spin forms to the bit as step after step, the momentum form to rounding (both of its
/// ways of repairing R fly by the cross product).
Motion fly_sheet(const Cuboid<double>& body, const Motion& now, double h, long steps);
Motion fly_explicit_euler(const Cuboid<double>& body, const Motion& now, double h, long steps);
Motion fly_euler_naive(const Cuboid<double>& body, const Motion& now, double h, long steps);
Motion fly_euler_exponential(const Cuboid<double>& body, const Motion& now, double h, long steps);
Motion fly_euler_quaternion(const Cuboid<double>& body, const Motion& now, double h, long steps);
Motion fly_euler_momentum_cross(const Cuboid<double>& body, const Motion& now, double h, long steps);
Motion fly_euler_momentum_exponential(const Cuboid<double>& body, const Motion& now, double h, long steps);

}  // namespace rigor
