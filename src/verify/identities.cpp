#include <rigor/base/interrupt.hpp>
#include <rigor/formulas/angular_acceleration.hpp>
#include <rigor/formulas/force_sum.hpp>
#include <rigor/formulas/friction_coulomb.hpp>
#include <rigor/formulas/friction_sheet.hpp>
#include <rigor/formulas/friction_stronge_planar.hpp>
#include <rigor/formulas/friction_tangent.hpp>
#include <rigor/formulas/kinetic_energy.hpp>
#include <rigor/formulas/linear_acceleration.hpp>
#include <rigor/formulas/momentum.hpp>
#include <rigor/formulas/normal_effective_mass.hpp>
#include <rigor/formulas/normal_impulse.hpp>
#include <rigor/formulas/point_velocity.hpp>
#include <rigor/formulas/positional_correction.hpp>
#include <rigor/formulas/semi_implicit_step.hpp>
#include <rigor/scalar/rational.hpp>
#include <rigor/verify/inputs.hpp>
#include <rigor/verify/verify.hpp>

namespace rigor::verify {
namespace {

using Q = Rational;
using V = Vec3<Q>;
using M3 = Mat3<Q>;
using Exact = Inputs<Q>;

V times(const Q& s, const V& v) { return V(s * v[0], s * v[1], s * v[2]); }
V plus(const V& a, const V& b) { return V(a[0] + b[0], a[1] + b[1], a[2] + b[2]); }
V minus(const V& a, const V& b) { return V(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }
bool same(const V& a, const V& b) { return a[0] == b[0] && a[1] == b[1] && a[2] == b[2]; }
Q det(const M3& A) { return dot<Q>(A.col(0), cross<Q>(A.col(1), A.col(2))); }

M3 product(const M3& A, const M3& B) {
  M3 C;
  for (int k = 0; k < 3; ++k) C.col(k) = apply<Q>(A, B.col(k));
  return C;
}
M3 transposed(const M3& A) {
  M3 B;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) B(i, j) = A(j, i);
  return B;
}
bool same(const M3& A, const M3& B) {
  for (int k = 0; k < 3; ++k)
    if (!same(V(A.col(k)), V(B.col(k)))) return false;
  return true;
}

M3 inertia_of(const ImpactBody<Q>& body) {  // the tensor whose inverse the body carries, by cofactors
  const M3& A = body.inverse_I_B_W;
  M3 adjoint;
  for (int k = 0; k < 3; ++k) {
    const V row = cross<Q>(A.col((k + 1) % 3), A.col((k + 2) % 3));
    for (int i = 0; i < 3; ++i) adjoint(k, i) = row[i] / det(A);
  }
  return adjoint;
}
Q energy(const Exact& in, const PairVelocity<Q>& u) {
  return kinetic_energy<Q>(in.m, inertia_of(in.A), u.A.v_WB, u.A.w_WB) +
         kinetic_energy<Q>(in.m_B, inertia_of(in.B), u.B.v_WB, u.B.w_WB);
}
// About the contact point, where the arms of both bodies end.
V momentum_about_contact(const Exact& in, const PairVelocity<Q>& u) {
  const V here = zero3<Q>();
  return plus(angular_momentum<Q>(in.m, inertia_of(in.A), times(Q(-1), in.A.p_BC_W), u.A.v_WB, u.A.w_WB, here),
              angular_momentum<Q>(in.m_B, inertia_of(in.B), times(Q(-1), in.B.p_BC_W), u.B.v_WB, u.B.w_WB, here));
}
Q normal_speed(const Exact& in, const PairVelocity<Q>& u) { return dot<Q>(relative_velocity<Q>(in.A, in.B, u), in.n_W); }

PairVelocity<Q> after_normal(const Exact& in, Q (*law)(const Q&, const Q&, const Q&)) {
  const Q j = law(in.e, normal_speed(in, in.u), normal_inverse_mass<Q>(in.A, in.B, in.n_W));
  return apply_pair_impulse<Q>(in.A, in.B, in.u, times(j, in.n_W));
}

// Coulomb's law on a contact that approaches with slip along a rational tangent.
bool coulomb_holds(const Exact& in) {
  const V n = in.R_WB.col(0), t = in.R_WB.col(1), v = plus(times(-in.m, n), times(in.m_B, t));
  const M3 K = effective_inverse_mass<Q>(in.A, in.B);
  const Q mu_d = in.mu * Q(3, 4);
  const auto answer = coulomb_impulse<Q>(K, v, n, t, in.e, in.mu, mu_d);
  const V after = plus(v, apply<Q>(K, answer.j_W));
  const Q j_n = dot<Q>(answer.j_W, n);
  const V j_t = minus(answer.j_W, times(j_n, n));
  if (dot<Q>(after, n) != in.e * in.m || j_n < Q(0)) return false;
  if (answer.outcome == FrictionOutcome::stuck)
    return same(minus(after, times(dot<Q>(after, n), n)), zero3<Q>()) && dot<Q>(j_t, j_t) <= in.mu * in.mu * j_n * j_n;
  return answer.outcome == FrictionOutcome::jammed || in.mu == Q(0) || same(j_t, times(-mu_d * j_n, t));
}
// Routh's process ended by Poisson's rule (rational): inside the cone, never more energy, momentum of the normal exact.
bool planar_holds(const Exact& in) {
  const Q k_nn = Q(1) + in.m, k_tt = Q(1) + in.m_B, k_tn = (in.e - Q(1, 2)) * Q(9, 5);
  if (!(k_tn * k_tn < k_nn * k_tt)) return true;
  const Q v_n = -(Q(1) + in.h), v_t = in.s_B[0];
  const auto j = planar_impulse<Q>({k_nn, k_tt, k_tn, v_n, v_t, in.e, in.mu, in.mu * Q(3, 4)}, Restitution::poisson);
  const Q n_after = v_n + k_nn * j.j_n + k_tn * j.j_t, t_after = v_t + k_tn * j.j_n + k_tt * j.j_t;
  const Q work = (j.j_n * (v_n + n_after) + j.j_t * (v_t + t_after)) / Q(2);
  return abs(j.j_t) <= in.mu * j.j_n && work <= Q(0) && n_after >= Q(0) && (j.mode != PlanarMode::sticking || t_after == Q(0));
}

struct Row {
  const char *id, *says;
  bool (*holds)(const Exact&);
};

const Row rows[] = {
    {"contact.correction", "the deepest point ends on the plane, and nothing moves along it",
     [](const Exact& in) {
       const V shift = positional_correction<Q>(in.m, in.n_W);
       return dot<Q>(shift, in.n_W) == in.m && same(cross<Q>(shift, in.n_W), zero3<Q>()) &&
              same(positional_correction<Q>(-in.m, in.n_W), zero3<Q>());
     }},
    {"energy.impulse", "dT = j.(v_r + v_r')/2 for any impulse",
     [](const Exact& in) {
       const PairVelocity<Q> after = apply_pair_impulse<Q>(in.A, in.B, in.u, in.j_W);
       return energy(in, after) - energy(in, in.u) ==
              impulse_energy<Q>(in.j_W, relative_velocity<Q>(in.A, in.B, in.u), relative_velocity<Q>(in.A, in.B, after));
     }},
    {"energy.kinetic", "2T = m v.v + sum I_i w_i^2 in body axes",
     [](const Exact& in) {
       const V w_B = apply_transposed<Q>(in.R_WB, in.w_WB);
       Q twice = in.m * dot<Q>(in.v_WB, in.v_WB);
       for (int i = 0; i < 3; ++i) twice += in.I_B[i] * w_B[i] * w_B[i];
       return Q(2) * kinetic_energy<Q>(in.m, in.I_B_W, in.v_WB, in.w_WB) == twice;
     }},
    {"force.sum", "the order of forces does not matter, and a couple sums to zero force",
     [](const Exact& in) {
       const Wrench<Q> one = add_force<Q>(add_force<Q>({}, in.p_BC_W, in.f_W), in.B.p_BC_W, in.tau_W);
       const Wrench<Q> two = add_force<Q>(add_force<Q>({}, in.B.p_BC_W, in.tau_W), in.p_BC_W, in.f_W);
       const Wrench<Q> couple = add_force<Q>(add_force<Q>({}, in.p_BC_W, in.f_W), in.B.p_BC_W, times(Q(-1), in.f_W));
       return same(one.f_W, two.f_W) && same(one.tau_W, two.tau_W) && same(couple.f_W, zero3<Q>()) &&
              same(couple.tau_W, cross<Q>(minus(in.p_BC_W, in.B.p_BC_W), in.f_W));
     }},
    {"force.torque", "torque is normal to arm and force, and |t|^2 + (r.f)^2 = |r|^2 |f|^2",
     [](const Exact& in) {
       const V t = torque_of_force<Q>(in.p_BC_W, in.f_W);
       const Q along = dot<Q>(in.p_BC_W, in.f_W);
       return dot<Q>(t, in.p_BC_W) == Q(0) && dot<Q>(t, in.f_W) == Q(0) &&
              dot<Q>(t, t) + along * along == dot<Q>(in.p_BC_W, in.p_BC_W) * dot<Q>(in.f_W, in.f_W);
     }},
    {"friction.coulomb", "v_n' = -e v_n; stuck: no slip, inside the cone; slid: on the cone, against the slip", coulomb_holds},
    {"friction.sheet", "stops the slip of a point mass exactly, or is mu_d j_r",
     [](const Exact& in) {
       const Q j = sheet_friction_impulse<Q>(in.m, in.e, in.mu, in.m_B, in.h);
       return in.h - j / in.m == Q(0) ? j <= in.e * in.m_B : j == in.mu * in.m_B;
     }},
    {"friction.sheet_literal", "zero without slip, mu_d j_r with any",
     [](const Exact& in) {
       return sheet_literal_friction_impulse<Q>(in.mu, in.m, Q(0)) == Q(0) && sheet_literal_friction_impulse<Q>(in.mu, in.m, in.h) == in.mu * in.m;
     }},
    {"friction.stronge_planar", "with Poisson's ending: inside the cone, energy never rises, no slip where it sticks", planar_holds},
    {"friction.tangent", "the slip's direction; the force's where there is no slip; else zero",
     [](const Exact& in) {
       const V n = in.R_WB.col(0), t = in.R_WB.col(1), s = in.R_WB.col(2);
       const V slip = plus(times(-in.mu - in.e, n), times(in.m, t)), force = plus(times(in.h, n), times(in.m_B, s));
       return same(friction_tangent<Q>(slip, force, n), t) && same(friction_tangent<Q>(times(in.m, n), force, n), s) &&
              same(friction_tangent<Q>(times(in.m, n), times(in.h, n), n), zero3<Q>());
     }},
    {"impulse.apply", "the contact's velocity changes by K j",
     [](const Exact& in) {
       const Velocity<Q> after = apply_impulse<Q>(in.A, in.u.A, in.j_W);
       const V change = minus(point_velocity<Q>(after.v_WB, after.w_WB, in.A.p_BC_W),
                              point_velocity<Q>(in.u.A.v_WB, in.u.A.w_WB, in.A.p_BC_W));
       return same(change, apply<Q>(effective_inverse_mass<Q>(in.A, {}), in.j_W));
     }},
    {"impulse.apply_pair", "linear and angular momentum are kept by any impulse",
     [](const Exact& in) {
       const PairVelocity<Q> after = apply_pair_impulse<Q>(in.A, in.B, in.u, in.j_W);
       const auto P = [&](const PairVelocity<Q>& u) { return plus(times(in.m, u.A.v_WB), times(in.m_B, u.B.v_WB)); };
       return same(P(after), P(in.u)) && same(momentum_about_contact(in, after), momentum_about_contact(in, in.u));
     }},
    {"impulse.effective_mass", "v_r' = v_r + K j, K symmetric and positive definite (Sylvester)",
     [](const Exact& in) {
       const M3 K = effective_inverse_mass<Q>(in.A, in.B);
       const V after = relative_velocity<Q>(in.A, in.B, apply_pair_impulse<Q>(in.A, in.B, in.u, in.j_W));
       return same(after, plus(relative_velocity<Q>(in.A, in.B, in.u), apply<Q>(K, in.j_W))) &&
              same(K, transposed(K)) && K(0, 0) > Q(0) && K(0, 0) * K(1, 1) > K(0, 1) * K(1, 0) && det(K) > Q(0);
     }},
    {"impulse.normal", "v_n' = -e v_n, and dT = -(1 - e^2) v_n^2/(2 k_nn)",
     [](const Exact& in) {
       const PairVelocity<Q> after = after_normal(in, normal_impulse<Q>);
       const Q v_n = normal_speed(in, in.u), k = normal_inverse_mass<Q>(in.A, in.B, in.n_W);
       return normal_speed(in, after) == -in.e * v_n &&
              energy(in, after) - energy(in, in.u) == -(Q(1) - in.e * in.e) * v_n * v_n / (Q(2) * k);
     }},
    {"impulse.normal_effective_mass", "k_nn = n.K n >= 1/m_A + 1/m_B",
     [](const Exact& in) {
       const Q k = normal_inverse_mass<Q>(in.A, in.B, in.n_W);
       return k == dot<Q>(in.n_W, apply<Q>(effective_inverse_mass<Q>(in.A, in.B), in.n_W)) &&
              k >= in.A.inverse_mass + in.B.inverse_mass;
     }},
    {"impulse.normal_printed", "the printed form leaves v_n' = +e v_n",
     [](const Exact& in) { return normal_speed(in, after_normal(in, normal_impulse_printed<Q>)) == in.e * normal_speed(in, in.u); }},
    {"impulse.relative_velocity", "the difference of the two contact points' velocities",
     [](const Exact& in) {
       return same(relative_velocity<Q>(in.A, in.B, in.u), minus(point_velocity<Q>(in.u.B.v_WB, in.u.B.w_WB, in.B.p_BC_W),
                                                                 point_velocity<Q>(in.u.A.v_WB, in.u.A.w_WB, in.A.p_BC_W)));
     }},
    {"inertia.cuboid", "eight half-size boxes, shifted by the parallel-axis theorem, add up to it",
     [](const Exact& in) {
       const V half = times(Q(1, 2), in.s_B), small = cuboid_inertia<Q>(in.m / Q(8), half);
       const V whole = cuboid_inertia<Q>(in.m, in.s_B);
       for (int i = 0; i < 3; ++i) {
         const Q a = half[(i + 1) % 3] / Q(2), b = half[(i + 2) % 3] / Q(2);
         if (whole[i] != Q(8) * (small[i] + in.m / Q(8) * (a * a + b * b))) return false;
       }
       return true;
     }},
    {"inertia.cuboid_inverse", "I I^-1 = 1",
     [](const Exact& in) {
       for (int i = 0; i < 3; ++i)
         if (in.I_B[i] * cuboid_inverse_inertia<Q>(in.I_B)[i] != Q(1)) return false;
       return true;
     }},
    {"inertia.world", "the edges are its eigenvectors: I_W R = R diag(I_B)",
     [](const Exact& in) {
       const M3 I = world_inertia<Q>(in.R_WB, in.I_B);
       for (int k = 0; k < 3; ++k)
         if (!same(apply<Q>(I, in.R_WB.col(k)), times(in.I_B[k], in.R_WB.col(k)))) return false;
       return true;
     }},
    {"inertia.world_inverse", "world tensor times world inverse = 1",
     [](const Exact& in) {
       return same(product(world_inertia<Q>(in.R_WB, in.I_B), world_inverse_inertia<Q>(in.R_WB, in.inverse_I_B)), identity3<Q>());
     }},
    {"momentum.angular", "moving the reference point by d changes it by -d x P",
     [](const Exact& in) {
       const V P = linear_momentum<Q>(in.m, in.v_WB), d = minus(in.p_WO, in.f_W);
       const V here = angular_momentum<Q>(in.m, in.I_B_W, in.p_WB, in.v_WB, in.w_WB, in.p_WO);
       const V there = angular_momentum<Q>(in.m, in.I_B_W, in.p_WB, in.v_WB, in.w_WB, in.f_W);
       return same(minus(here, there), times(Q(-1), cross<Q>(d, P)));
     }},
    {"momentum.linear", "2T of the centre = P.v",
     [](const Exact& in) {
       return dot<Q>(linear_momentum<Q>(in.m, in.v_WB), in.v_WB) ==
              Q(2) * kinetic_energy<Q>(in.m, in.I_B_W, in.v_WB, zero3<Q>());
     }},
    {"motion.euler", "I w' + w x (I w) = t, and without torque w.(I w') = 0",
     [](const Exact& in) {
       const V rate = angular_acceleration<Q>(in.I_B_W, in.inverse_I_B_W, in.w_WB, in.tau_W);
       const V free = angular_acceleration<Q>(in.I_B_W, in.inverse_I_B_W, in.w_WB, zero3<Q>());
       return same(plus(apply<Q>(in.I_B_W, rate), cross<Q>(in.w_WB, apply<Q>(in.I_B_W, in.w_WB))), in.tau_W) &&
              dot<Q>(in.w_WB, apply<Q>(in.I_B_W, free)) == Q(0);
     }},
    {"motion.linear", "m a = f",
     [](const Exact& in) { return same(times(in.m, linear_acceleration<Q>(in.A.inverse_mass, in.f_W)), in.f_W); }},
    {"motion.point_velocity", "no stretch: (v_C - v_D).(C - D) = 0 for any two points",
     [](const Exact& in) {
       const V c = point_velocity<Q>(in.v_WB, in.w_WB, in.p_BC_W), d = point_velocity<Q>(in.v_WB, in.w_WB, in.f_W);
       return dot<Q>(minus(c, d), minus(in.p_BC_W, in.f_W)) == Q(0);
     }},
    {"rotation.gram_schmidt", "Q U with U upper triangular, positive diagonal, gives Q back",
     [](const Exact& in) {
       M3 U = zero33<Q>();
       for (int i = 0; i < 3; ++i) U(i, i) = in.s_B[i];
       U(0, 1) = in.v_WB[0], U(0, 2) = in.v_WB[1], U(1, 2) = in.v_WB[2];
       return same(gram_schmidt<Q>(product(in.R_WB, U)), in.R_WB);
     }},
    {"rotation.naive_step", "R'^T R' = 1 - h^2 R^T [w]^2 R and det R' = 1 + h^2 w.w",
     [](const Exact& in) {
       const M3 next = naive_rotation_step<Q>(in.h, in.w_WB, in.R_WB), W = skew<Q>(in.w_WB);
       const M3 square = product(transposed(in.R_WB), product(product(W, W), in.R_WB)), gram = product(transposed(next), next);
       for (int i = 0; i < 3; ++i)
         for (int j = 0; j < 3; ++j)
           if (gram(i, j) != Q(i == j ? 1 : 0) - in.h * in.h * square(i, j)) return false;
       return det(next) == Q(1) + in.h * in.h * dot<Q>(in.w_WB, in.w_WB);
     }},
    {"rotation.rate", "R' = [w]x R, and R^T R' is skew",
     [](const Exact& in) {
       const M3 rate = rotation_rate<Q>(in.w_WB, in.R_WB), B = product(transposed(in.R_WB), rate);
       for (int i = 0; i < 3; ++i)
         for (int j = 0; j < 3; ++j)
           if (B(i, j) != -B(j, i)) return false;
       return same(rate, product(skew<Q>(in.w_WB), in.R_WB));
     }},
    {"step.semi_implicit", "in free fall n steps lead the parabola by exactly g t h/2",
     [](const Exact& in) {
       State<Q> s;
       s.p_WB = in.p_WB;
       s.v_WB = in.v_WB;
       const V g(Q(0), Q(-49, 5), Q(0));
       const int n = 7;
       for (int i = 0; i < n; ++i) s = semi_implicit_step<Q>(in.h, s, g, zero3<Q>());
       const Q t = Q(n) * in.h;
       const V parabola = plus(plus(in.p_WB, times(t, in.v_WB)), times(t * t / Q(2), g));
       return same(minus(s.p_WB, parabola), times(t * in.h / Q(2), g)) && same(s.R_WB, identity3<Q>());
     }},
};

}  // namespace

std::vector<Identity> identities(const std::string& only, long cases, std::uint64_t seed) {
  std::vector<Identity> results;
  for (const Row& row : rows) {
    if (!only.empty() && only != row.id) continue;
    Identity result{row.id, row.says, 0, 0};
    Random random(seed);
    for (long c = 0; c < cases && interrupted() == 0; ++c) {
      ++result.cases;
      if (row.holds(draw<Q>(random))) ++result.held;
    }
    results.push_back(result);
  }
  return results;
}

}  // namespace rigor::verify
