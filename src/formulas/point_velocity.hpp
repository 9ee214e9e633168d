#pragma once
#include <rigor/linalg/types.hpp>

namespace rigor {

/// Velocity of the material point C of a rigid body.
///
///     v_WC = v_WB + ω_WB × p_BC_W
///
/// shapes    (3), (3), (3) → (3)
/// units     m/s, rad/s, m → m/s
/// frames    world axes; p_BC_W = C − centre of mass
/// scalars   Field: exact over ℚ
/// rounding  component i within γ₃ (|v_i| + |ω_j p_k| + |ω_k p_j|)
/// id        motion.point_velocity
/// source    assignment, Part 2 (v_r); derivation in proofs/motion.md
template <Field T>
Vec3<T> point_velocity(const Vec3<T>& v_WB, const Vec3<T>& w_WB, const Vec3<T>& p_BC_W) {
  const Vec3<T> turn = cross<T>(w_WB, p_BC_W);
  return Vec3<T>(v_WB[0] + turn[0], v_WB[1] + turn[1], v_WB[2] + turn[2]);
}

}  // namespace rigor
