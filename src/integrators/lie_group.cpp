#include <cmath>
#include <rigor/integrators/lie_group.hpp>
#include <rigor/integrators/turning.hpp>
#include <rigor/linalg/rotation.hpp>

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

}  // namespace

Motion step_implicit_midpoint(const Cuboid<double>& body, const Motion& now, const Load& load, double h) { return kicked_step(implicit_midpoint, body, now, load, h); }
Motion step_buss_augmented(const Cuboid<double>& body, const Motion& now, const Load& load, double h) { return kicked_step(buss_augmented, body, now, load, h); }
Motion step_rkmk4(const Cuboid<double>& body, const Motion& now, const Load& load, double h) { return kicked_step(rkmk4, body, now, load, h); }
Motion step_commutator_free4(const Cuboid<double>& body, const Motion& now, const Load& load, double h) { return kicked_step(commutator_free4, body, now, load, h); }

}  // namespace rigor
