#pragma once
#include <rigor/linalg/types.hpp>

namespace rigor {

/// Derivative of a body's rotation matrix.
///
///     Ṙ_WB = [ω_WB]ₓ R_WB,   column by column ω × column
///
/// shapes    (3), (3×3) → (3×3)
/// units     rad/s, 1 → 1/s
/// frames    ω in WORLD axes (with body axes the product is R [ω_B]ₓ; the assignment does not say which)
/// scalars   Field: exact over ℚ
/// rounding  each entry within γ₂ of the two products' absolute sum
/// id        rotation.rate
/// source    assignment, Part 1; derivation in proofs/rotation.md
template <Field T>
Mat3<T> rotation_rate(const Vec3<T>& w_WB, const Mat3<T>& R_WB) {
  Mat3<T> rate;
  for (int k = 0; k < 3; ++k) rate.col(k) = cross<T>(w_WB, R_WB.col(k));
  return rate;
}

}  // namespace rigor
