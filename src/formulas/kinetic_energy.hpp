#pragma once
#include <rigor/linalg/types.hpp>

namespace rigor {

/// Kinetic energy of a rigid body.
///
///     T = ½ m v·v + ½ ω·(I ω)
///
/// shapes    scalar, (3×3), (3), (3) → scalar
/// units     kg, kg·m², m/s, rad/s → J
/// frames    world axes, inertia about the centre of mass
/// scalars   Field: exact over ℚ
/// rounding  within γ₈ of the absolute sum of its terms
/// id        energy.kinetic
/// source    König's theorem; derivation in proofs/energy.md
template <Field T>
T kinetic_energy(const T& m, const Mat3<T>& I_B_W, const Vec3<T>& v_WB, const Vec3<T>& w_WB) {
  return (m * dot<T>(v_WB, v_WB) + dot<T>(w_WB, apply<T>(I_B_W, w_WB))) / T(2);
}

/// Kinetic energy that an impulse j at a contact adds, from the relative velocities before and after.
///
///     ΔT = j · (v_r + v_r')/2
///
/// Holds for every impulse and every K that is symmetric; it closes the energy account of any contact law.
///
/// shapes    (3), (3), (3) → scalar
/// units     N·s, m/s → J
/// frames    world axes; +j on B, −j on A, v_r = v_B − v_A
/// scalars   Field: exact over ℚ
/// rounding  within γ₅ |j|·(|v_r| + |v_r'|)
/// id        energy.impulse
/// source    Thomson and Tait; derivation in proofs/energy.md
template <Field T>
T impulse_energy(const Vec3<T>& j_W, const Vec3<T>& v_r_before, const Vec3<T>& v_r_after) {
  return dot<T>(j_W, Vec3<T>(v_r_before[0] + v_r_after[0], v_r_before[1] + v_r_after[1],
                             v_r_before[2] + v_r_after[2])) / T(2);
}

}  // namespace rigor
