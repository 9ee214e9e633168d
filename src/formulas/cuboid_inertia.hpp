#pragma once
#include <rigor/linalg/types.hpp>

namespace rigor {

/// Central inertia of a homogeneous cuboid: its three principal moments.
///
///     I_B = m/12 · (h² + d², w² + d², w² + h²),   (w, h, d) = s_B
///
/// shapes    m scalar, s_B (3) → (3), the diagonal; products of inertia are 0
/// units     kg, m → kg·m²
/// frames    B at the centre of mass, axes along the edges; s_B are FULL edge lengths
/// scalars   Field: exact over ℚ
/// domain    m > 0, s_B > 0: Cuboid::make guarantees it, not checked again
/// rounding  each moment within γ₄ (square, sum of positives, quotient, product), no under/overflow
/// id        inertia.cuboid
/// source    assignment, Part 1; derivation in proofs/inertia.md, by volume integral
template <Field T>
Vec3<T> cuboid_inertia(const T& m, const Vec3<T>& s_B) {
  const T &w = s_B[0], &h = s_B[1], &d = s_B[2];
  const T k = m / T(12);
  return Vec3<T>(k * (h * h + d * d), k * (w * w + d * d), k * (w * w + h * h));
}

}  // namespace rigor
