#include <cmath>
#include <rigor/integrators/flat_state.hpp>
#include <rigor/integrators/quaternion.hpp>
#include <rigor/integrators/runge_kutta.hpp>

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

Motion fly_rk4(const Cuboid<double>& body, const Motion& now, double h, long steps) {
  const State<double>& s = now.state;
  const Vec3<double>& I = body.inertia();
  const Vec3<double> c = body.inverse_inertia().cwiseProduct(Vec3<double>(I[1] - I[2], I[2] - I[0], I[0] - I[1]));
  // q' = q (0, ω_B)/2 is linear: the attitude is counted from the start, its length does not matter
  const auto rate_of = [&c](const Spinning& x) {
    const Vec3<double> &w = x.w_B, half = w / 2;
    const Vec4<double>& q = x.q;
    return Spinning{{-(q[1] * half[0] + q[2] * half[1] + q[3] * half[2]), q[0] * half[0] + q[2] * half[2] - q[3] * half[1], q[0] * half[1] + q[3] * half[0] - q[1] * half[2],
                     q[0] * half[2] + q[1] * half[1] - q[2] * half[0]},
                    {c[0] * w[1] * w[2], c[1] * w[2] * w[0], c[2] * w[0] * w[1]}};
  };
  Spinning x{{1, 0, 0, 0}, apply_transposed<double>(s.R_WB, s.w_WB)};
  for (long step = 0; step < steps; ++step) {
    const Spinning k1 = rate_of(x), k2 = rate_of(x.plus(h / 2, k1)), k3 = rate_of(x.plus(h / 2, k2)), k4 = rate_of(x.plus(h, k3));
    x.q += h / 6 * (k1.q + 2 * (k2.q + k3.q) + k4.q);
    x.w_B += h / 6 * (k1.w_B + 2 * (k2.w_B + k3.w_B) + k4.w_B);
    if (is_time_to_normalise(step)) x.q = normalised(x.q);
  }
  State<double> end = s;
  end.p_WB += double(steps) * h * s.v_WB;
  end.R_WB = s.R_WB * rotation_of<double>(x.q);
  end.w_WB = apply<double>(end.R_WB, x.w_B);
  return motion_of(body, end);
}

Motion step_rk4_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h) {
  const auto rate = [&](double at, const FlatState& y) { return flat_rate(body, load, at, y); };
  const FlatState y = flat_of(now.state), k1 = rate(t, y), k2 = rate(t + h / 2, y + h / 2 * k1), k3 = rate(t + h / 2, y + h / 2 * k2), k4 = rate(t + h, y + h * k3);
  return motion_of(body, state_of(FlatState(y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4))));
}

}  // namespace rigor
