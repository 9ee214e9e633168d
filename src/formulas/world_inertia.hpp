#pragma once
#include <rigor/linalg/types.hpp>

namespace rigor {

/// A principal tensor turned into world axes.
///
///     I_B_W = R_WB · diag(I_B) · R_WBᵀ,   entry (i,j) = Σₖ R_ik I_k R_jk
///
/// shapes    R_WB (3×3), I_B (3) → (3×3), symmetric to the bit
/// units     kg·m² → kg·m²
/// frames    I_B along the edges of B; result in world axes, about the centre of mass
/// scalars   Field: exact over ℚ
/// domain    R_WB orthonormal with determinant +1
/// rounding  each entry within γ₅ Σₖ |R_ik I_k R_jk|
/// id        inertia.world
/// source    assignment, Part 1 ("world-space inertia tensor"); derivation in proofs/inertia.md
template <Field T>
Mat3<T> world_inertia(const Mat3<T>& R_WB, const Vec3<T>& I_B) {
  Mat3<T> I_B_W;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) {
      const T sum = R_WB(i, 0) * I_B[0] * R_WB(j, 0) + R_WB(i, 1) * I_B[1] * R_WB(j, 1) +
                    R_WB(i, 2) * I_B[2] * R_WB(j, 2);
      I_B_W(i, j) = sum;
      I_B_W(j, i) = sum;
    }
  return I_B_W;
}

}  // namespace rigor
