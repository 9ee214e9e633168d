#include <cmath>
#include <rigor/integrators/composition.hpp>
#include <rigor/integrators/moser_veselov.hpp>
#include <rigor/integrators/preprocessed_moments.hpp>
#include <rigor/integrators/quaternion.hpp>
#include <rigor/integrators/turning.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;

template <int order>
Vec4<double> moser_veselov(const Cuboid<double>& body, const V& L_B, double h, long steps) {
  // in a unit near the largest moment: the series has products of nine of them. A power of two, so no bit changes
  const double unit = std::scalbn(1.0, std::ilogb(body.inertia().maxCoeff()));
  const V inverse_I = preprocessed_inverse_moments<double>(V(body.inertia() / unit), V(body.inverse_inertia() * unit), V(L_B / unit), h, order) / unit;
  const V I = inverse_I.cwiseInverse(), to_g = h / 2 * inverse_I;
  const V f((I[1] - I[2]) * inverse_I[0], (I[2] - I[0]) * inverse_I[1], (I[0] - I[1]) * inverse_I[2]);
  const double enough = dot<double>(L_B.cwiseProduct(to_g), L_B.cwiseProduct(to_g)) * 0x1p-104;
  V L = L_B, e = L.cwiseProduct(to_g);
  Vec4<double> q(1, 0, 0, 0);
  for (long step = 0; step < steps; ++step) {
    // the quaternion (1, e) of the step: e = g (1 + |e|²) + I⁻¹((I e) × e), by fixed point from the last step's; contracts by about |ω|h/2
    const V g = L.cwiseProduct(to_g);
    for (int k = 0; k < 60; ++k) {
      const double c = 1 + dot<double>(e, e);
      V next;
      next[0] = g[0] * c + f[0] * e[1] * e[2];
      next[1] = g[1] * c + f[1] * e[2] * next[0];
      next[2] = g[2] * c + f[2] * next[0] * next[1];
      const V change = next - e;
      e = next;
      if (dot<double>(change, change) <= enough) break;
    }
    const Vec4<double> turn(1, e[0], e[1], e[2]);
    q = product(q, turn);
    L = turned_back(turn, L, 2 / (1 + dot<double>(e, e)));
    if (is_time_to_normalise(step)) q = normalised(q);
  }
  return q;
}

}  // namespace

Motion step_moser_veselov(const Cuboid<double>& body, const Motion& now, const Load& load, double h) { return kicked_step(moser_veselov<2>, body, now, load, h); }
Motion step_moser_veselov4(const Cuboid<double>& body, const Motion& now, const Load& load, double h) { return kicked_step(moser_veselov<4>, body, now, load, h); }
Motion step_moser_veselov8(const Cuboid<double>& body, const Motion& now, const Load& load, double h) { return kicked_step(moser_veselov<8>, body, now, load, h); }
Motion step_moser_veselov_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h) { return composed_step(moser_veselov<2>, strang, body, now, load, t, h); }
Motion step_moser_veselov4_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h) { return composed_step(moser_veselov<4>, yoshida4, body, now, load, t, h); }
Motion step_moser_veselov8_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h) { return composed_step(moser_veselov<8>, kahan_li8, body, now, load, t, h); }
Motion fly_moser_veselov(const Cuboid<double>& body, const Motion& now, double h, long steps) { return free_flight(moser_veselov<2>, body, now, h, steps); }
Motion fly_moser_veselov4(const Cuboid<double>& body, const Motion& now, double h, long steps) { return free_flight(moser_veselov<4>, body, now, h, steps); }
Motion fly_moser_veselov8(const Cuboid<double>& body, const Motion& now, double h, long steps) { return free_flight(moser_veselov<8>, body, now, h, steps); }

}  // namespace rigor
