#pragma once
#include <rigor/formulas/effective_mass.hpp>

namespace rigor {

/// k_nn = n·K n, the denominator of the normal impulse, as the assignment writes it.
///
///     k_nn = 1/m_A + 1/m_B + [(I_A⁻¹(r_A × n)) × r_A + (I_B⁻¹(r_B × n)) × r_B] · n
///
/// shapes    two ImpactBody, (3) → scalar
/// units     1/kg
/// frames    world axes; n is a unit vector, its sign does not matter
/// scalars   Field: exact over ℚ
/// domain    not both bodies immovable; then k_nn ≥ 1/m_A + 1/m_B > 0
/// rounding  within γ₁₂ of the absolute sum of its terms
/// id        impulse.normal_effective_mass
/// source    assignment, Part 2 (the denominator); derivation in proofs/impulse.md
template <Field T>
T normal_inverse_mass(const ImpactBody<T>& A, const ImpactBody<T>& B, const Vec3<T>& n_W) {
  const Vec3<T> a = cross<T>(apply<T>(A.inverse_I_B_W, cross<T>(A.p_BC_W, n_W)), A.p_BC_W);
  const Vec3<T> b = cross<T>(apply<T>(B.inverse_I_B_W, cross<T>(B.p_BC_W, n_W)), B.p_BC_W);
  return A.inverse_mass + B.inverse_mass + dot<T>(Vec3<T>(a[0] + b[0], a[1] + b[1], a[2] + b[2]), n_W);
}

}  // namespace rigor
