#pragma once
#include <rigor/bodies/cuboid.hpp>
#include <rigor/formulas/state.hpp>
#include <rigor/scalar/rational.hpp>

namespace rigor {

/// The separating-axis theorem over the rationals: no rounding, no square root, no axis left out. Returns the sign of
/// the largest gap: +1 apart, 0 touching, −1 overlapping.
///
/// On an axis L the gap has the sign of |t·L| − Σ hA_i |a_i·L| − Σ hB_j |b_j·L|, whatever the length of L, so nothing is
/// normalised; a zero cross product (parallel edges) separates nothing and is skipped.
inline int exact_sign_of_gap(const Cuboid<double>& A, const State<double>& a, const Cuboid<double>& B, const State<double>& b) {
  using Q = Rational;
  const auto exact = [](const Vec3<double>& v) { return Vec3<Q>(Q::exactly(v[0]), Q::exactly(v[1]), Q::exactly(v[2])); };
  Vec3<Q> edge_A[3], edge_B[3];
  for (int i = 0; i < 3; ++i) edge_A[i] = exact(a.R_WB.col(i)), edge_B[i] = exact(b.R_WB.col(i));
  const Vec3<Q> half_A = exact(Vec3<double>(A.size() / 2)), half_B = exact(Vec3<double>(B.size() / 2));
  const Vec3<Q> from = exact(a.p_WB), to = exact(b.p_WB), t(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
  int sign = -1;
  const auto offer = [&](const Vec3<Q>& L) {
    if (dot<Q>(L, L) == Q(0)) return;
    Q gap = abs(dot<Q>(t, L));
    for (int i = 0; i < 3; ++i) gap -= half_A[i] * abs(dot<Q>(edge_A[i], L)) + half_B[i] * abs(dot<Q>(edge_B[i], L));
    sign = std::max(sign, gap > Q(0) ? 1 : gap == Q(0) ? 0 : -1);
  };
  for (int i = 0; i < 3; ++i) {
    offer(edge_A[i]);
    offer(edge_B[i]);
    for (int j = 0; j < 3; ++j) offer(cross<Q>(edge_A[i], edge_B[j]));
  }
  return sign;
}

}  // namespace rigor
