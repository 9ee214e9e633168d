#pragma once
#include <rigor/linalg/types.hpp>

namespace rigor {

/// What one body brings to an impact: 1/m, its inverse inertia in WORLD axes at the impact pose, and its arm
/// p_BC_W = contact − centre of mass in world axes. An immovable body has zeros, exactly.
template <Field T>
struct ImpactBody {
  T inverse_mass = T(0);
  Mat3<T> inverse_I_B_W = zero33<T>();
  Vec3<T> p_BC_W = zero3<T>();
};

/// The matrix that turns an impulse at the contact into a change of relative velocity there.
///
///     v_r' = v_r + K j,   K = (1/m_A + 1/m_B) 1 − [r_A]ₓ I_A⁻¹ [r_A]ₓ − [r_B]ₓ I_B⁻¹ [r_B]ₓ
///
/// shapes    two ImpactBody → (3×3), symmetric up to rounding
/// units     1/kg
/// frames    world axes; +j on B, −j on A, v_r = v_B − v_A at the contact
/// scalars   Field: exact over ℚ
/// domain    not both bodies immovable; then K is symmetric positive definite
/// rounding  each entry within γ₈ of the absolute sum of its products
/// id        impulse.effective_mass
/// source    reference/errata.md 6.1; derivation in proofs/impulse.md
template <Field T>
Mat3<T> effective_inverse_mass(const ImpactBody<T>& A, const ImpactBody<T>& B) {
  Mat3<T> K;
  for (int k = 0; k < 3; ++k) {  // column k: the change of v_r by a unit impulse along axis k
    Vec3<T> e = zero3<T>();
    e[k] = T(1);
    const Vec3<T> a = cross<T>(apply<T>(A.inverse_I_B_W, cross<T>(A.p_BC_W, e)), A.p_BC_W);
    const Vec3<T> b = cross<T>(apply<T>(B.inverse_I_B_W, cross<T>(B.p_BC_W, e)), B.p_BC_W);
    for (int i = 0; i < 3; ++i) K(i, k) = (A.inverse_mass + B.inverse_mass) * e[i] + (a[i] + b[i]);
  }
  return K;
}

}  // namespace rigor
