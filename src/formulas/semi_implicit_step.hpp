#pragma once
#include <rigor/formulas/gram_schmidt.hpp>
#include <rigor/formulas/naive_rotation_step.hpp>
#include <rigor/formulas/state.hpp>

namespace rigor {

/// One step of semi-implicit (symplectic) Euler: velocities first, then the pose with the NEW velocities.
///
///     v' = v + h v̇,  ω' = ω + h ω̇,  p' = p + h v',  R' = GramSchmidt(R + h [ω']ₓ R)
///
/// Order 1. In free fall the position is exactly g t h/2 beyond the parabola (case D-02), whatever h.
///
/// shapes    scalar, State, (3), (3) → State
/// units     s, m/s², rad/s²
/// frames    world axes
/// scalars   Rooted (Gram-Schmidt)
/// domain    h > 0; (1 + h[ω']ₓ)R is never singular, its determinant is 1 + h²ω'²
/// rounding  p', v', ω' within γ₂ of the absolute sums of their terms; R' as gram_schmidt
/// id        step.semi_implicit
/// source    assignment, Part 1 ("e.g. symplectic Euler"); derivation in proofs/step.md
template <Rooted T>
State<T> semi_implicit_step(const T& h, const State<T>& s, const Vec3<T>& a_WB, const Vec3<T>& alpha_WB) {
  State<T> next;
  for (int i = 0; i < 3; ++i) {
    next.v_WB[i] = s.v_WB[i] + h * a_WB[i];
    next.w_WB[i] = s.w_WB[i] + h * alpha_WB[i];
    next.p_WB[i] = s.p_WB[i] + h * next.v_WB[i];
  }
  next.R_WB = gram_schmidt<T>(naive_rotation_step<T>(h, next.w_WB, s.R_WB));
  return next;
}

}  // namespace rigor
