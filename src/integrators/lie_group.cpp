#include <rigor/integrators/composition.hpp>
#include <rigor/integrators/lie_group.hpp>
#include <rigor/integrators/quaternion.hpp>
#include <rigor/integrators/turning.hpp>
#include <utility>

namespace rigor {
namespace {

using V = Vec3<double>;
using M = Mat3<double>;

V spin(const Cuboid<double>& body, const V& L_B) { return L_B.cwiseProduct(body.inverse_inertia()); }
/// L as it is seen in a body turned on by exp(u).
V seen_after(const V& u, const V& L_B) { return turned_back(exp_quaternion(u), L_B); }

// The quaternion (1, h ω/2) of the mid-point's spin: Cayley's map. L' = L + h m × ω = 2m − L.
Vec4<double> implicit_midpoint(const Cuboid<double>& body, const V& L_B, double h, long steps) {
  const V half_turn = h / 2 * body.inverse_inertia();
  const double enough = 0x1p-100 * dot<double>(L_B, L_B);
  V L = L_B;
  Vec4<double> q(1, 0, 0, 0);
  for (long step = 0; step < steps; ++step) {
    const auto mapped = [&](const V& m) { return V(L + cross<double>(m, V(m.cwiseProduct(half_turn)))); };
    V m = mapped(L);
    for (int k = 0; k < 50; ++k) {  // contracts by about |ω|h/2 each time
      const V next = mapped(m), change = next - m;
      m = next;
      if (dot<double>(change, change) <= enough) break;
    }
    const V half = m.cwiseProduct(half_turn);
    const Vec4<double> turn(1, half[0], half[1], half[2]);
    q = product(q, turn);
    L = 2 * m - L;
    if (is_time_to_normalise(step)) q = normalised(q);
  }
  return q;
}

Vec4<double> buss_augmented(const Cuboid<double>& body, const V& L_B, double h, long steps) {
  return turn_by(L_B, steps, [&](const V& L) {
    const V w = spin(body, L), w1 = spin(body, V(cross<double>(L, w)));
    return exp_quaternion(V(h * w + h * h / 2 * w1 + h * h * h / 12 * cross<double>(w1, w)));
  });
}

/// The inverse of the exponential's derivative, to the order that four stages need: u' = dexp⁻¹ a.
V inverse_dexp(const V& u, const V& a) {
  const V c = cross<double>(u, a);
  return a + 0.5 * c + 1.0 / 12 * cross<double>(u, c);
}

Vec4<double> rkmk4(const Cuboid<double>& body, const V& L_B, double h, long steps) {
  const V h_spin = h * body.inverse_inertia();
  return turn_by(L_B, steps, [&](const V& L) {
    const auto rate = [&](const V& u) { return inverse_dexp(u, V(h_spin.cwiseProduct(seen_after(u, L)))); };
    const V k1 = h_spin.cwiseProduct(L), k2 = rate(V(k1 / 2)), k3 = rate(V(k2 / 2)), k4 = rate(k3);
    return exp_quaternion(V((k1 + 2 * (k2 + k3) + k4) * (1 / 6.)));
  });
}

Vec4<double> commutator_free4(const Cuboid<double>& body, const V& L_B, double h, long steps) {
  const V h_spin = h * body.inverse_inertia();
  return turn_by(L_B, steps, [&](const V& L) {
    const V a1 = h_spin.cwiseProduct(L), L2 = seen_after(V(a1 / 2), L), a2 = h_spin.cwiseProduct(L2);
    const V a3 = h_spin.cwiseProduct(seen_after(V(a2 / 2), L)), a4 = h_spin.cwiseProduct(seen_after(V(a3 - a1 / 2), L2)), middle = 2 * (a2 + a3);
    return product(exp_quaternion(V((3 * a1 + middle - a4) * (1 / 12.))), exp_quaternion(V((middle + 3 * a4 - a1) * (1 / 12.))));
  });
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
Motion fly_implicit_midpoint(const Cuboid<double>& body, const Motion& now, double h, long steps) { return free_flight(implicit_midpoint, body, now, h, steps); }
Motion fly_buss_augmented(const Cuboid<double>& body, const Motion& now, double h, long steps) { return free_flight(buss_augmented, body, now, h, steps); }
Motion fly_rkmk4(const Cuboid<double>& body, const Motion& now, double h, long steps) { return free_flight(rkmk4, body, now, h, steps); }
Motion fly_commutator_free4(const Cuboid<double>& body, const Motion& now, double h, long steps) { return free_flight(commutator_free4, body, now, h, steps); }

}  // namespace rigor
