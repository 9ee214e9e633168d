#pragma once
#include <rigor/formulas/apply_impulse.hpp>

namespace rigor {

template <Field T>
struct PairVelocity {
  Velocity<T> A, B;
};

/// Both bodies after an impulse between them: −j on A, +j on B, at one point in space.
///
///     v_A' = v_A − j/m_A,  ω_A' = ω_A − I_A⁻¹(r_A × j),   v_B' = v_B + j/m_B,  ω_B' = ω_B + I_B⁻¹(r_B × j)
///
/// Linear and angular momentum of the pair are kept for every j.
///
/// shapes    two ImpactBody, PairVelocity, (3) → PairVelocity
/// units     N·s
/// frames    world axes; both arms go to the same point
/// scalars   Field: exact over ℚ
/// rounding  as apply_impulse, each body
/// id        impulse.apply_pair
/// source    assignment, Part 2; derivation in proofs/impulse.md
template <Field T>
PairVelocity<T> apply_pair_impulse(const ImpactBody<T>& A, const ImpactBody<T>& B, const PairVelocity<T>& before,
                                   const Vec3<T>& j_BC_W) {
  const Vec3<T> opposite(-j_BC_W[0], -j_BC_W[1], -j_BC_W[2]);
  return {apply_impulse<T>(A, before.A, opposite), apply_impulse<T>(B, before.B, j_BC_W)};
}

/// v_r = v_B − v_A at the contact.
///
/// shapes    two ImpactBody, PairVelocity → (3)
/// units     m/s
/// frames    world axes
/// scalars   Field: exact over ℚ
/// rounding  component i within γ₄ of the absolute sum of its terms
/// id        impulse.relative_velocity
/// source    assignment, Part 2 (v_r = v_r2 − v_r1); derivation in proofs/impulse.md
template <Field T>
Vec3<T> relative_velocity(const ImpactBody<T>& A, const ImpactBody<T>& B, const PairVelocity<T>& u) {
  const Vec3<T> a = cross<T>(u.A.w_WB, A.p_BC_W), b = cross<T>(u.B.w_WB, B.p_BC_W);
  return Vec3<T>((u.B.v_WB[0] + b[0]) - (u.A.v_WB[0] + a[0]), (u.B.v_WB[1] + b[1]) - (u.A.v_WB[1] + a[1]),
                 (u.B.v_WB[2] + b[2]) - (u.A.v_WB[2] + a[2]));
}

}  // namespace rigor
