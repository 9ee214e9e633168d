#pragma once
#include <rigor/linalg/types.hpp>

namespace rigor {

/// Torque about the centre of mass of a force that acts at a point of the body.
///
///     τ = p_BC_W × f_BC_W
///
/// shapes    (3), (3) → (3)
/// units     m, N → N·m
/// frames    everything in world axes; p_BC_W = contact − centre of mass, NOT the world position of C
/// scalars   Field: exact over ℚ
/// rounding  component i within γ₂ (|p_j f_k| + |p_k f_j|)
/// id        force.torque
/// source    assignment, Part 1 (τ_i = r_i × F_i); derivation in proofs/force.md
template <Field T>
Vec3<T> torque_of_force(const Vec3<T>& p_BC_W, const Vec3<T>& f_BC_W) {
  return cross<T>(p_BC_W, f_BC_W);
}

}  // namespace rigor
