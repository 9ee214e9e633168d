#pragma once
#include <rigor/formulas/world_inertia.hpp>

namespace rigor {

/// The inverse inertia in world axes: the principal inverses turned, no matrix is inverted.
///
///     (I_B_W)⁻¹ = R_WB · diag(1/I_B) · R_WBᵀ
///
/// shapes    R_WB (3×3), inverse_I_B (3) → (3×3), symmetric to the bit
/// units     1/(kg·m²)
/// frames    inverse_I_B along the edges of B; result in world axes: this one goes with world r × n
///           (the assignment's text says "body coordinates"; see reference/errata.md, erratum world-inverse)
/// scalars   Field: exact over ℚ
/// domain    R_WB orthonormal with determinant +1; zero entries mean a body that cannot turn
/// rounding  each entry within γ₅ Σₖ |R_ik R_jk / I_k|, given inverse_I_B
/// id        inertia.world_inverse
/// source    assignment, Part 1; derivation in proofs/inertia.md
template <Field T>
Mat3<T> world_inverse_inertia(const Mat3<T>& R_WB, const Vec3<T>& inverse_I_B) {
  return world_inertia<T>(R_WB, inverse_I_B);
}

}  // namespace rigor
