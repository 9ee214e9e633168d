#include <cmath>
#include <rigor/integrators/flat_state.hpp>
#include <rigor/integrators/runge_kutta.hpp>
#include <rigor/linalg/rotation.hpp>

namespace rigor {
namespace {

// q' = q (0, ω_B)/2, ω_B' = I⁻¹ (τ_B − ω × Iω), the torque held in world axes
struct Spinning {
  Vec4<double> q;
  Vec3<double> w_B;

  Spinning plus(double h, const Spinning& rate) const { return {Vec4<double>(q + h * rate.q), Vec3<double>(w_B + h * rate.w_B)}; }
};
Spinning rate_of(const Cuboid<double>& body, const Spinning& x, const Vec3<double>& tau_W) {
  const Vec3<double>& w = x.w_B;
  const Vec4<double>& q = x.q;
  Spinning rate;
  rate.q << -0.5 * (q[1] * w[0] + q[2] * w[1] + q[3] * w[2]), 0.5 * (q[0] * w[0] + q[2] * w[2] - q[3] * w[1]),
      0.5 * (q[0] * w[1] + q[3] * w[0] - q[1] * w[2]), 0.5 * (q[0] * w[2] + q[1] * w[1] - q[2] * w[0]);
  const Vec3<double> I = body.inertia(), tau_B = apply_transposed<double>(rotation_of<double>(q), tau_W);
  const Vec3<double> L(I[0] * w[0], I[1] * w[1], I[2] * w[2]), turn = cross<double>(w, L);
  for (int i = 0; i < 3; ++i) rate.w_B[i] = body.inverse_inertia()[i] * (tau_B[i] - turn[i]);
  return rate;
}

}  // namespace

Motion step_rk4(const Cuboid<double>& body, const Motion& now, const Load& load, double h) {
  const State<double>& s = now.state;
  const Spinning x{quaternion_of<double>(s.R_WB), apply_transposed<double>(s.R_WB, s.w_WB)};
  const Spinning k1 = rate_of(body, x, load.tau_W), k2 = rate_of(body, x.plus(h / 2, k1), load.tau_W);
  const Spinning k3 = rate_of(body, x.plus(h / 2, k2), load.tau_W), k4 = rate_of(body, x.plus(h, k3), load.tau_W);
  Spinning y = x.plus(h / 6, k1).plus(h / 3, k2).plus(h / 3, k3).plus(h / 6, k4);
  y.q /= std::sqrt(y.q.dot(y.q));
  const Vec3<double> a = body.inverse_mass() * load.f_W;  // constant force: the parabola, exactly
  State<double> next;
  next.v_WB = s.v_WB + h * a;
  next.p_WB = s.p_WB + h * (s.v_WB + h / 2 * a);
  next.R_WB = rotation_of<double>(y.q);
  next.w_WB = apply<double>(next.R_WB, y.w_B);
  return motion_of(body, next);
}

Motion step_rk4_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h) {
  const auto rate = [&](double at, const FlatState& y) { return flat_rate(body, load, at, y); };
  const FlatState y = flat_of(now.state), k1 = rate(t, y), k2 = rate(t + h / 2, y + h / 2 * k1), k3 = rate(t + h / 2, y + h / 2 * k2), k4 = rate(t + h, y + h * k3);
  return motion_of(body, state_of(FlatState(y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4))));
}

}  // namespace rigor
