#pragma once
#include <rigor/formulas/torque_of_force.hpp>

namespace rigor {

/// Net force and net torque about the centre of mass, world axes.
template <Field T>
struct Wrench {
  Vec3<T> f_W = zero3<T>();
  Vec3<T> tau_W = zero3<T>();
};

/// The accumulators after one more force.
///
///     F ← F + f,   τ ← τ + p_BC_W × f
///
/// shapes    Wrench, (3), (3) → Wrench
/// units     N and N·m
/// frames    world axes, torque about the centre of mass of B
/// scalars   Field: exact over ℚ
/// rounding  N forces: |error of F| ≤ γ_{N−1} Σ|f|, of τ ≤ γ_{N+1} Σ(|p||f|), component by component
/// id        force.sum
/// source    assignment, Part 1 (F = ΣF_i, τ = Σ r_i × F_i); derivation in proofs/force.md
template <Field T>
Wrench<T> add_force(const Wrench<T>& sum, const Vec3<T>& p_BC_W, const Vec3<T>& f_BC_W) {
  const Vec3<T> tau = torque_of_force<T>(p_BC_W, f_BC_W);
  return {Vec3<T>(sum.f_W[0] + f_BC_W[0], sum.f_W[1] + f_BC_W[1], sum.f_W[2] + f_BC_W[2]),
          Vec3<T>(sum.tau_W[0] + tau[0], sum.tau_W[1] + tau[1], sum.tau_W[2] + tau[2])};
}

}  // namespace rigor
