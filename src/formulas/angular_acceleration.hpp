#pragma once
#include <rigor/linalg/types.hpp>

namespace rigor {

/// Euler's equation in world axes.
///
///     ω̇ = I⁻¹ (τ − ω × (I ω))
///
/// shapes    (3×3), (3×3), (3), (3) → (3)
/// units     kg·m², 1/(kg·m²), rad/s, N·m → rad/s²
/// frames    world axes throughout, inertia about the centre of mass
/// scalars   Field: exact over ℚ
/// domain    inverse_I_B_W is the inverse of I_B_W (or 0 for a body that cannot turn)
/// rounding  ≤ γ₉ |I⁻¹| (|τ| + |ω||I||ω|), component by component
/// id        motion.euler
/// source    assignment, Part 1; derivation in proofs/motion.md, from dL/dt = τ
template <Field T>
Vec3<T> angular_acceleration(const Mat3<T>& I_B_W, const Mat3<T>& inverse_I_B_W, const Vec3<T>& w_WB,
                             const Vec3<T>& tau_B_W) {
  const Vec3<T> gyroscopic = cross<T>(w_WB, apply<T>(I_B_W, w_WB));
  return apply<T>(inverse_I_B_W, Vec3<T>(tau_B_W[0] - gyroscopic[0], tau_B_W[1] - gyroscopic[1],
                                         tau_B_W[2] - gyroscopic[2]));
}

}  // namespace rigor
