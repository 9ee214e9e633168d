#pragma once
#include <rigor/linalg/types.hpp>

namespace rigor {

/// Orthonormal columns by modified Gram-Schmidt; the first column keeps its direction.
///
///     u₁ = a₁/|a₁|,   u₂ = (a₂ − (u₁·a₂)u₁)/|…|,   u₃ = (a₃ − (u₁·a₃)u₁ − (u₂·…)u₂)/|…|
///
/// shapes    (3×3) → (3×3)
/// frames    none: columns stay columns
/// scalars   Rooted: exact over ℚ where the three norms are rational
/// domain    independent columns. The sign of the determinant is kept: a left-handed input gives a REFLECTION.
///           Check the determinant where the input is not known to be near a rotation.
/// rounding  max|QᵀQ − 1| ≤ 12 u κ(A) near a rotation (κ ≈ 1); 5 u κ(A) was seen (tests/rounding)
/// id        rotation.gram_schmidt
/// source    assignment, Part 1 (MatrixUtils::orthonormalize); derivation in proofs/rotation.md
template <Rooted T>
Mat3<T> gram_schmidt(const Mat3<T>& A) {
  const auto unit = [](const Vec3<T>& a) {
    const T length = norm<T>(a);
    return Vec3<T>(a[0] / length, a[1] / length, a[2] / length);
  };
  const auto without = [](const Vec3<T>& a, const Vec3<T>& u) {
    const T along = dot<T>(u, a);
    return Vec3<T>(a[0] - along * u[0], a[1] - along * u[1], a[2] - along * u[2]);
  };
  const Vec3<T> u1 = unit(A.col(0));
  const Vec3<T> u2 = unit(without(A.col(1), u1));
  const Vec3<T> u3 = unit(without(without(A.col(2), u1), u2));
  Mat3<T> Q;
  Q.col(0) = u1;
  Q.col(1) = u2;
  Q.col(2) = u3;
  return Q;
}

}  // namespace rigor
