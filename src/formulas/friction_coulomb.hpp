#pragma once
#include <rigor/linalg/types.hpp>

namespace rigor {

/// What became of an impact with friction.
enum class FrictionOutcome {
  stuck,                ///< no slip at the end; the impulse lies within the cone of μ_s
  slid,                 ///< slips on; the impulse lies on the cone of μ_d
  slip_stopped_inside,  ///< sliding throughout would have reversed the slip: Newton's e is unsafe here (FR-10, FR-12)
  jammed,               ///< no sliding solution (denominator ≤ 0, FR-14): the frictionless impulse is returned
};

template <Field T>
struct FrictionImpact {
  Vec3<T> j_W;
  FrictionOutcome outcome;
};

/// The impulse j with K j = −b, by Cramer's rule.
///
/// no id     linear algebra; K is symmetric positive definite, so det K > 0
template <Field T>
Vec3<T> impulse_cancelling(const Mat3<T>& K, const Vec3<T>& b) {
  const Vec3<T> x = K.col(0), y = K.col(1), z = K.col(2), yz = cross<T>(y, z);
  const T det = dot<T>(x, yz);
  return Vec3<T>(-dot<T>(b, yz) / det, -dot<T>(b, cross<T>(z, x)) / det, -dot<T>(b, cross<T>(x, y)) / det);
}

/// Impulse at one contact with Coulomb friction and Newton's restitution, normal and tangent coupled through K.
///
///     stick trial:  K j = −[v_t + (1+e) v_n n];   accepted if |j_t| ≤ μ_s j_n
///     else slide:   j = j_n (n − μ_d t),  j_n = −(1+e) v_n / (n·K n − μ_d n·K t)
///
/// Either way v_n' = −e v_n. The cone test is on the total impulse, itself an approximation (FR-12).
///
/// shapes    (3×3), (3), (3), (3), scalars → impulse on B and what happened
/// units     1/kg, m/s, 1, 1, 1, 1 → N·s
/// frames    world axes; n from A to B, v_r = v_B − v_A; t = friction_tangent, the zero vector without slip
/// scalars   Field: exact over ℚ
/// domain    v_r·n < 0, K positive definite, 0 ≤ e ≤ 1, 0 ≤ μ_d ≤ μ_s
/// rounding  stuck: within 8 u κ(K) |j|; sliding: within 8 u c |j|, c = (1 + μ_d)|K n|/denominator + |v_r|/|v_n|. A quarter
///           of that was seen (tests/rounding); a case on the border of the cone may take either branch
/// id        friction.coulomb
/// source    reference/errata.md, erratum friction-law; derivation in proofs/friction.md
template <Field T>
FrictionImpact<T> coulomb_impulse(const Mat3<T>& K, const Vec3<T>& v_r, const Vec3<T>& n, const Vec3<T>& t,
                                  const T& e, const T& mu_s, const T& mu_d) {
  const T v_n = dot<T>(v_r, n);
  const Vec3<T> Kn = apply<T>(K, n);
  const T frictionless = -(T(1) + e) * v_n / dot<T>(n, Kn);
  if (mu_s == T(0)) return {Vec3<T>(frictionless * n[0], frictionless * n[1], frictionless * n[2]), FrictionOutcome::slid};

  Vec3<T> change;  // v_t + (1+e) v_n n = v_r + e v_n n
  for (int i = 0; i < 3; ++i) change[i] = v_r[i] + e * v_n * n[i];
  const Vec3<T> stick = impulse_cancelling<T>(K, change);
  const T along = dot<T>(stick, n);
  const Vec3<T> across(stick[0] - along * n[0], stick[1] - along * n[1], stick[2] - along * n[2]);
  if (along >= T(0) && dot<T>(across, across) <= mu_s * mu_s * along * along) return {stick, FrictionOutcome::stuck};

  const T denominator = dot<T>(n, Kn) - mu_d * dot<T>(t, Kn);
  if (!(denominator > T(0)))
    return {Vec3<T>(frictionless * n[0], frictionless * n[1], frictionless * n[2]), FrictionOutcome::jammed};
  const T j_n = -(T(1) + e) * v_n / denominator;
  Vec3<T> slide;
  for (int i = 0; i < 3; ++i) slide[i] = j_n * (n[i] - mu_d * t[i]);
  const T slip_after = dot<T>(v_r, t) + dot<T>(t, apply<T>(K, slide));
  return {slide, slip_after < T(0) ? FrictionOutcome::slip_stopped_inside : FrictionOutcome::slid};
}

}  // namespace rigor
