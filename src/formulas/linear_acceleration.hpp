#pragma once
#include <rigor/linalg/types.hpp>

namespace rigor {

/// Newton's second law for the centre of mass.
///
///     v̇_WB = (1/m) f_B_W
///
/// shapes    scalar, (3) → (3)
/// units     1/kg, N → m/s²
/// frames    world axes
/// scalars   Field: exact over ℚ
/// domain    inverse_mass ≥ 0; 0 means immovable
/// rounding  each component within u, given inverse_mass
/// id        motion.linear
/// source    assignment, Part 1; derivation in proofs/motion.md
template <Field T>
Vec3<T> linear_acceleration(const T& inverse_mass, const Vec3<T>& f_B_W) {
  return Vec3<T>(inverse_mass * f_B_W[0], inverse_mass * f_B_W[1], inverse_mass * f_B_W[2]);
}

}  // namespace rigor
