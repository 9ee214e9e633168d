#pragma once
#include <rigor/linalg/types.hpp>

namespace rigor {

/// Linear momentum P = m v.
///
/// shapes    scalar, (3) → (3)
/// units     kg, m/s → N·s
/// frames    world axes
/// scalars   Field: exact over ℚ
/// rounding  each component within u
/// id        momentum.linear
/// source    definition; proofs/momentum.md
template <Field T>
Vec3<T> linear_momentum(const T& m, const Vec3<T>& v_WB) {
  return Vec3<T>(m * v_WB[0], m * v_WB[1], m * v_WB[2]);
}

/// Angular momentum about a fixed point of the world.
///
///     L = (p_WB − p_WO) × m v + I ω
///
/// shapes    scalar, (3×3), (3), (3), (3), (3) → (3)
/// units     kg·m²/s
/// frames    world axes; O is the point it is about
/// scalars   Field: exact over ℚ
/// rounding  within γ₅ of the absolute sum of its terms
/// id        momentum.angular
/// source    König's theorem; derivation in proofs/momentum.md
template <Field T>
Vec3<T> angular_momentum(const T& m, const Mat3<T>& I_B_W, const Vec3<T>& p_WB, const Vec3<T>& v_WB,
                         const Vec3<T>& w_WB, const Vec3<T>& p_WO) {
  const Vec3<T> arm(p_WB[0] - p_WO[0], p_WB[1] - p_WO[1], p_WB[2] - p_WO[2]);
  const Vec3<T> orbit = cross<T>(arm, linear_momentum<T>(m, v_WB));
  const Vec3<T> spin = apply<T>(I_B_W, w_WB);
  return Vec3<T>(orbit[0] + spin[0], orbit[1] + spin[1], orbit[2] + spin[2]);
}

}  // namespace rigor
