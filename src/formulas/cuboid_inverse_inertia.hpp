#pragma once
#include <rigor/linalg/types.hpp>

namespace rigor {

/// Inverse of the central inertia of a homogeneous cuboid: the reciprocals of its principal moments.
///
///     I_B⁻¹ = (1/I₁, 1/I₂, 1/I₃)
///
/// shapes    (3) → (3), both diagonals
/// units     kg·m² → 1/(kg·m²)
/// frames    B at the centre of mass, axes along the edges
/// scalars   Field: exact over ℚ
/// domain    I_B > 0
/// rounding  each within u of 1/I (one quotient)
/// id        inertia.cuboid_inverse
/// source    assignment, Part 1; derivation in proofs/inertia.md
template <Field T>
Vec3<T> cuboid_inverse_inertia(const Vec3<T>& I_B) {
  return Vec3<T>(T(1) / I_B[0], T(1) / I_B[1], T(1) / I_B[2]);
}

}  // namespace rigor
