#pragma once
#include <rigor/formulas/effective_mass.hpp>
#include <rigor/formulas/state.hpp>

namespace rigor {

/// Velocities of one body after an impulse at its contact point.
///
///     v' = v + j/m,   ω' = ω + I⁻¹ (r × j)
///
/// shapes    ImpactBody, Velocity, (3) → Velocity
/// units     N·s
/// frames    world axes; j_BC_W acts ON this body
/// scalars   Field: exact over ℚ
/// rounding  v' within γ₂(|v| + |j|/m), ω' within γ₆(|ω| + |I⁻¹||r||j|), component by component
/// id        impulse.apply
/// source    assignment, Part 2; derivation in proofs/impulse.md
template <Field T>
Velocity<T> apply_impulse(const ImpactBody<T>& B, const Velocity<T>& before, const Vec3<T>& j_BC_W) {
  const Vec3<T> turn = apply<T>(B.inverse_I_B_W, cross<T>(B.p_BC_W, j_BC_W));
  Velocity<T> after;
  for (int i = 0; i < 3; ++i) {
    after.v_WB[i] = before.v_WB[i] + B.inverse_mass * j_BC_W[i];
    after.w_WB[i] = before.w_WB[i] + turn[i];
  }
  return after;
}

}  // namespace rigor
