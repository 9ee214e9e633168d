#include <cmath>
#include <rigor/integrators/composition.hpp>
#include <rigor/integrators/lie_group.hpp>
#include <rigor/integrators/turning.hpp>
#include <rigor/linalg/rotation.hpp>
#include <utility>

namespace rigor {
namespace {

using V = Vec3<double>;
using M = Mat3<double>;

V spin(const Cuboid<double>& body, const V& L_B) { return L_B.cwiseProduct(body.inverse_inertia()); }
/// L as it is seen in a body turned on by exp(u).
V seen_after(const V& u, const V& L_B) { return apply_transposed<double>(exp_so3<double>(u), L_B); }
Turning turned(const Turning& now, const M& E) { return {now.R_WB * E, apply_transposed<double>(E, now.L_B)}; }

Turning implicit_midpoint(const Cuboid<double>& body, const Turning& now, double h) {
  const auto mapped = [&](const V& m) { return V(now.L_B + h / 2 * cross<double>(m, spin(body, m))); };
  V m = mapped(now.L_B);
  const double enough = 4 * 0x1p-53 * norm<double>(now.L_B);
  for (int k = 0; k < 50; ++k) {  // contracts by about |ω|h/2 each time
    const V next = mapped(m);
    const double change = norm<double>(V(next - m));
    m = next;
    if (change <= enough) break;
  }
  const V half = h / 2 * spin(body, m);
  return turned(now, rotation_of<double>(Vec4<double>(1, half[0], half[1], half[2])));
}

Turning buss_augmented(const Cuboid<double>& body, const Turning& now, double h) {
  const V w = spin(body, now.L_B), w1 = spin(body, V(cross<double>(now.L_B, w)));
  return turned(now, exp_so3<double>(V(h * w + h * h / 2 * w1 - h * h * h / 12 * cross<double>(w1, w))));
}

/// The inverse of the exponential's derivative, to the order that four stages need: u' = dexp⁻¹ a.
V inverse_dexp(const V& u, const V& a) {
  const V c = cross<double>(u, a);
  return a + 0.5 * c + 1.0 / 12 * cross<double>(u, c);
}

Turning rkmk4(const Cuboid<double>& body, const Turning& now, double h) {
  const auto rate = [&](const V& u) { return inverse_dexp(u, V(h * spin(body, seen_after(u, now.L_B)))); };
  const V k1 = h * spin(body, now.L_B), k2 = rate(V(k1 / 2)), k3 = rate(V(k2 / 2)), k4 = rate(k3);
  return turned(now, exp_so3<double>(V((k1 + 2 * k2 + 2 * k3 + k4) / 6)));
}

Turning commutator_free4(const Cuboid<double>& body, const Turning& now, double h) {
  const V a1 = h * spin(body, now.L_B), L2 = seen_after(V(a1 / 2), now.L_B), a2 = h * spin(body, L2);
  const V a3 = h * spin(body, seen_after(V(a2 / 2), now.L_B)), a4 = h * spin(body, seen_after(V(a3 - a1 / 2), L2));
  return turned(now, exp_so3<double>(V((3 * a1 + 2 * (a2 + a3) - a4) / 12)) * exp_so3<double>(V((2 * (a2 + a3) + 3 * a4 - a1) / 12)));
}

/// A stage under a load: the attitude on the group, everything else in a vector space.
struct Stage {
  M R_WB;
  V L_W, p_WB, v_WB;
};
struct Rate {  // times h
  V turn_B, L_W, p_WB, v_WB;
};
State<double> state_of(const Cuboid<double>& body, const Stage& x) {
  State<double> s;
  s.p_WB = x.p_WB, s.R_WB = x.R_WB, s.v_WB = x.v_WB;
  s.w_WB = apply<double>(x.R_WB, spin(body, V(apply_transposed<double>(x.R_WB, x.L_W))));
  return s;
}
Rate rate_of(const Cuboid<double>& body, const LoadAt& load, double t, double h, const Stage& x) {
  const Load at = load(t, state_of(body, x));
  return {h * spin(body, V(apply_transposed<double>(x.R_WB, x.L_W))), h * at.tau_W, h * x.v_WB, h * body.inverse_mass() * at.f_W};
}
Stage moved(const Stage& x, const M& R_WB, double part, const Rate& k) {
  return {R_WB, V(x.L_W + part * k.L_W), V(x.p_WB + part * k.p_WB), V(x.v_WB + part * k.v_WB)};
}
// Kutta's weights for what is in a vector space; the attitude is the caller's.
Motion kutta(const Cuboid<double>& body, Stage x, const M& R_WB, const Rate& k1, const Rate& k2, const Rate& k3, const Rate& k4) {
  for (const auto& [k, part] : {std::pair(&k1, 6.0), std::pair(&k2, 3.0), std::pair(&k3, 3.0), std::pair(&k4, 6.0)}) x = moved(x, R_WB, 1 / part, *k);
  return {state_of(body, x), x.L_W};
}

}  // namespace

Motion step_rkmk4_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h) {
  const Stage x{now.state.R_WB, now.L_W, now.state.p_WB, now.state.v_WB};
  const auto after = [&](const V& u, double part, const Rate& k) { return moved(x, x.R_WB * exp_so3<double>(u), part, k); };
  const auto in_algebra = [](const V& u, Rate k) {
    k.turn_B = inverse_dexp(u, k.turn_B);
    return k;
  };
  const Rate k1 = rate_of(body, load, t, h, x);
  const V u2 = k1.turn_B / 2;
  const Rate k2 = in_algebra(u2, rate_of(body, load, t + h / 2, h, after(u2, 0.5, k1)));
  const V u3 = k2.turn_B / 2;
  const Rate k3 = in_algebra(u3, rate_of(body, load, t + h / 2, h, after(u3, 0.5, k2)));
  const Rate k4 = in_algebra(k3.turn_B, rate_of(body, load, t + h, h, after(k3.turn_B, 1, k3)));
  const V u = (k1.turn_B + 2 * k2.turn_B + 2 * k3.turn_B + k4.turn_B) / 6;
  return kutta(body, x, x.R_WB * exp_so3<double>(u), k1, k2, k3, k4);
}

Motion step_commutator_free4_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h) {
  const Stage x{now.state.R_WB, now.L_W, now.state.p_WB, now.state.v_WB};
  const Rate k1 = rate_of(body, load, t, h, x);
  const V& a1 = k1.turn_B;
  const M R2 = x.R_WB * exp_so3<double>(V(a1 / 2));
  const Rate k2 = rate_of(body, load, t + h / 2, h, moved(x, R2, 0.5, k1));
  const V& a2 = k2.turn_B;
  const Rate k3 = rate_of(body, load, t + h / 2, h, moved(x, x.R_WB * exp_so3<double>(V(a2 / 2)), 0.5, k2));
  const V& a3 = k3.turn_B;
  const Rate k4 = rate_of(body, load, t + h, h, moved(x, R2 * exp_so3<double>(V(a3 - a1 / 2)), 1, k3));
  const V& a4 = k4.turn_B;
  const M turn = exp_so3<double>(V((3 * a1 + 2 * (a2 + a3) - a4) / 12)) * exp_so3<double>(V((2 * (a2 + a3) + 3 * a4 - a1) / 12));
  return kutta(body, x, x.R_WB * turn, k1, k2, k3, k4);
}

Motion step_implicit_midpoint(const Cuboid<double>& body, const Motion& now, const Load& load, double h) { return kicked_step(implicit_midpoint, body, now, load, h); }
Motion step_buss_augmented(const Cuboid<double>& body, const Motion& now, const Load& load, double h) { return kicked_step(buss_augmented, body, now, load, h); }
Motion step_rkmk4(const Cuboid<double>& body, const Motion& now, const Load& load, double h) { return kicked_step(rkmk4, body, now, load, h); }
Motion step_commutator_free4(const Cuboid<double>& body, const Motion& now, const Load& load, double h) { return kicked_step(commutator_free4, body, now, load, h); }
Motion step_implicit_midpoint_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h) { return composed_step(implicit_midpoint, strang, body, now, load, t, h); }
Motion step_buss_augmented_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h) { return composed_step(buss_augmented, strang, body, now, load, t, h); }

}  // namespace rigor
