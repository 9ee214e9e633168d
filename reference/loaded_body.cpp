#include <cmath>
#include <reference/loaded_body.hpp>
#include <rigor/linalg/rotation.hpp>

namespace rigor::reference {

using P = Precise;
using J = Jet<P>;

Jets cross(const Jets& a, const Jets& b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }

Jets quaternion_rate(const Jets& q, const Jets& w) {
  const J half(P(0.5));
  return {half * (-(q[1] * w[0]) - q[2] * w[1] - q[3] * w[2]), half * (q[0] * w[0] + q[2] * w[2] - q[3] * w[1]), half * (q[0] * w[1] + q[3] * w[0] - q[1] * w[2]),
          half * (q[0] * w[2] + q[1] * w[1] - q[2] * w[0])};
}

Jets turned_back(const Jets& q, const Jets& x) {
  const Jets v{q[1], q[2], q[3]}, once = cross(v, x), twice = cross(v, once);
  Jets out;
  for (std::size_t i = 0; i < 3; ++i) out.push_back(x[i] + J(P(2)) * (twice[i] - q[0] * once[i]));
  return out;
}

Attitude<P> taylor_loaded_body(const LoadedBody& body, double t, int order, double step) {
  const auto constants = [](const auto& x) { return Jets{J(P(x[0])), J(P(x[1])), J(P(x[2]))}; };
  const Mat3<P> R0 = body.at_start.R_WB.cast<P>();
  const Vec3<double>& I = body.at_start.I_B;
  const Vec3<P> push_at_start = R0.transpose() * body.push_W.cast<P>();
  const Jets inertia = constants(I), inverse{J(P(1) / P(I[0])), J(P(1) / P(I[1])), J(P(1) / P(I[2]))}, arm = constants(body.arm_B), tau = constants(body.tau_B), up = constants(R0.row(2)),
             push = constants(push_at_start);
  const bool is_pushed = body.push_W != zero3<double>();
  const auto law = [&](const J& now, const Jets& y) {
    const Jets w{y[0], y[1], y[2]}, q{y[3], y[4], y[5], y[6]};
    Jets L;
    for (std::size_t i = 0; i < 3; ++i) L.push_back(inertia[i] * w[i]);
    const Jets gyroscopic = cross(L, w), weight = cross(arm, turned_back(q, up));
    Jets rate;
    for (std::size_t i = 0; i < 3; ++i) rate.push_back(gyroscopic[i] + tau[i] - weight[i]);
    if (is_pushed) {
      const J strength = cos(J(P(body.rate)) * now);
      const Jets seen = turned_back(q, push);
      for (std::size_t i = 0; i < 3; ++i) rate[i] = rate[i] + strength * seen[i];
    }
    for (std::size_t i = 0; i < 3; ++i) rate[i] = rate[i] * inverse[i];
    const Jets turn = quaternion_rate(q, w);
    rate.insert(rate.end(), turn.begin(), turn.end());
    return rate;
  };
  const Vec3<double>& w0 = body.at_start.w_B;
  const std::vector<P> y = taylor<P>(law, {P(w0[0]), P(w0[1]), P(w0[2]), P(1), P(0), P(0), P(0)}, P(0), P(t), order, int(std::ceil(std::fabs(t) / step)));
  return {Mat3<P>(R0 * rotation_of<P>(Vec4<P>(y[3], y[4], y[5], y[6]))), Vec3<P>(y[0], y[1], y[2])};
}

}  // namespace rigor::reference
