#pragma once
#include <rigor/formulas/rotation_rate.hpp>

namespace rigor {

/// One explicit step of the rotation matrix, before any repair: it leaves the rotations at once.
///
///     R' = R + h [ω]ₓ R
///
/// Its defect is known: R'ᵀR' = Rᵀ(1 − h²[ω]ₓ²)R, so R' stretches by √(1+h²ω²) across ω, by 1 along it, turns
/// by atan(hω), and has determinant 1 + h²ω² (case K-07).
///
/// shapes    scalar, (3), (3×3) → (3×3)
/// units     s, rad/s
/// frames    ω in world axes
/// scalars   Field: exact over ℚ
/// rounding  each entry within γ₄ of (|R| + h|[ω]ₓ||R|)
/// id        rotation.naive_step
/// source    assignment, Part 1 (R_{t+1} = R_t + Δt Ṙ); see reference/errata.md, erratum naive-rotation
template <Field T>
Mat3<T> naive_rotation_step(const T& h, const Vec3<T>& w_WB, const Mat3<T>& R_WB) {
  const Mat3<T> rate = rotation_rate<T>(w_WB, R_WB);
  Mat3<T> next;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) next(i, j) = R_WB(i, j) + h * rate(i, j);
  return next;
}

}  // namespace rigor
