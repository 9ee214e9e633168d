#include <rigor/integrators/flat_state.hpp>
#include <rigor/linalg/rotation.hpp>

namespace rigor {

FlatState flat_of(const State<double>& s) {
  FlatState y;
  y << s.p_WB, s.v_WB, quaternion_of<double>(s.R_WB), apply_transposed<double>(s.R_WB, s.w_WB);
  return y;
}

State<double> state_of(const FlatState& y) {
  State<double> s;
  s.p_WB = y.segment<3>(0);
  s.v_WB = y.segment<3>(3);
  s.R_WB = rotation_of<double>(Vec4<double>(y.segment<4>(6)));
  s.w_WB = apply<double>(s.R_WB, Vec3<double>(y.segment<3>(10)));
  return s;
}

FlatState flat_rate(const Cuboid<double>& body, const LoadAt& load, double t, const FlatState& y) {
  const State<double> s = state_of(y);
  const Load at = load(t, s);
  const Vec4<double> q = y.segment<4>(6);
  const Vec3<double> w = y.segment<3>(10), L = body.inertia().cwiseProduct(w), tau_B = apply_transposed<double>(s.R_WB, at.tau_W);
  FlatState rate;
  rate << s.v_WB, body.inverse_mass() * at.f_W, -0.5 * (q[1] * w[0] + q[2] * w[1] + q[3] * w[2]), 0.5 * (q[0] * w[0] + q[2] * w[2] - q[3] * w[1]),
      0.5 * (q[0] * w[1] + q[3] * w[0] - q[1] * w[2]), 0.5 * (q[0] * w[2] + q[1] * w[1] - q[2] * w[0]),
      body.inverse_inertia().cwiseProduct(Vec3<double>(tau_B - cross<double>(w, L)));
  return rate;
}

}  // namespace rigor
