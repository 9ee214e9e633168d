#pragma once
#include <rigor/linalg/types.hpp>

namespace rigor {

/// Direction along which friction acts: of the slip, else of the tangential force, else none.
///
///     t = v_t/|v_t|,  v_t = v_r − (v_r·n) n;   if v_t = 0: f_t/|f_t| likewise;   if f_t = 0: the zero vector
///
/// Zero is judged at rounding: |v_t| ≤ 16u |v_r| counts as no slip (the projection of a purely normal velocity
/// is not exactly 0 in floating point), the same for the force. Over ℚ the test is exact.
///
/// shapes    (3), (3), (3) → (3), a unit vector or zero
/// units     m/s, N, 1 → 1
/// frames    world axes; n is a unit vector
/// scalars   Rooted: exact over ℚ where the norm is rational
/// rounding  each component within γ₁₀ |v_r|/|v_t|
/// id        friction.tangent
/// source    assignment, Part 2, read with tangential guards: reference/errata.md, erratum tangent-guard
template <Rooted T>
Vec3<T> friction_tangent(const Vec3<T>& v_r_W, const Vec3<T>& f_W, const Vec3<T>& n_W) {
  for (const Vec3<T>* candidate : {&v_r_W, &f_W}) {
    const Vec3<T>& a = *candidate;
    const T along = dot<T>(a, n_W);
    const Vec3<T> t(a[0] - along * n_W[0], a[1] - along * n_W[1], a[2] - along * n_W[2]);
    const T relative = T(16) * T(Eigen::NumTraits<T>::epsilon()) / T(2);  // 16u; 0 over ℚ
    if (dot<T>(t, t) > relative * relative * dot<T>(a, a)) {
      const T length = norm<T>(t);
      return Vec3<T>(t[0] / length, t[1] / length, t[2] / length);
    }
  }
  return zero3<T>();
}

}  // namespace rigor
