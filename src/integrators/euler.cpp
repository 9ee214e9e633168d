#include <rigor/formulas/angular_acceleration.hpp>
#include <rigor/formulas/linear_acceleration.hpp>
#include <rigor/formulas/semi_implicit_step.hpp>
#include <rigor/formulas/world_inverse_inertia.hpp>
#include <rigor/integrators/euler.hpp>

namespace rigor {
namespace {

struct Rates {
  Vec3<double> a, alpha;
};
Rates rates(const Cuboid<double>& body, const State<double>& s, const Load& load) {
  const Mat3<double> I = world_inertia<double>(s.R_WB, body.inertia());
  const Mat3<double> inverse_I = world_inverse_inertia<double>(s.R_WB, body.inverse_inertia());
  return {linear_acceleration<double>(body.inverse_mass(), load.f_W), angular_acceleration<double>(I, inverse_I, s.w_WB, load.tau_W)};
}
Vec3<double> advanced(const Vec3<double>& x, double h, const Vec3<double>& rate) {
  return Vec3<double>(x[0] + h * rate[0], x[1] + h * rate[1], x[2] + h * rate[2]);
}
// Velocities and position of the sheet's step; the attitude is the caller's.
State<double> semi_implicit(const Cuboid<double>& body, const State<double>& s, const Load& load, double h) {
  const Rates r = rates(body, s, load);
  State<double> next = s;
  next.v_WB = advanced(s.v_WB, h, r.a);
  next.w_WB = advanced(s.w_WB, h, r.alpha);
  next.p_WB = advanced(s.p_WB, h, next.v_WB);
  return next;
}
// Spin of a body with angular momentum L, by way of the body axes.
Vec3<double> spin_of(const Cuboid<double>& body, const Mat3<double>& R_WB, const Vec3<double>& L_W) {
  return apply<double>(R_WB, Vec3<double>(apply_transposed<double>(R_WB, L_W).cwiseProduct(body.inverse_inertia())));
}
// Gram and Schmidt of R + h [w]x R with reciprocals, the third column as the product of the others.
void turn_by_cross(const Vec3<double>& w_W, double h, Mat3<double>& R_WB) {
  const auto unit = [](const Vec3<double>& a) { return Vec3<double>(1 / norm<double>(a) * a); };
  const Vec3<double> c0 = R_WB.col(0), c1 = R_WB.col(1), a1 = advanced(c1, h, cross<double>(w_W, c1));
  const Vec3<double> u0 = unit(advanced(c0, h, cross<double>(w_W, c0)));
  const Vec3<double> u1 = unit(advanced(a1, -dot<double>(u0, a1), u0));
  R_WB.col(0) = u0;
  R_WB.col(1) = u1;
  R_WB.col(2) = cross<double>(u0, u1);
}

}  // namespace

Motion step_sheet(const Cuboid<double>& body, const Motion& now, const Load& load, double h) {
  const Rates r = rates(body, now.state, load);
  return motion_of(body, semi_implicit_step<double>(h, now.state, r.a, r.alpha));
}

Motion step_explicit_euler(const Cuboid<double>& body, const Motion& now, const Load& load, double h) {
  const State<double>& s = now.state;
  const Rates r = rates(body, s, load);
  State<double> next;
  next.p_WB = advanced(s.p_WB, h, s.v_WB);
  next.R_WB = gram_schmidt<double>(naive_rotation_step<double>(h, s.w_WB, s.R_WB));
  next.v_WB = advanced(s.v_WB, h, r.a);
  next.w_WB = advanced(s.w_WB, h, r.alpha);
  return motion_of(body, next);
}

Motion step_euler_naive(const Cuboid<double>& body, const Motion& now, const Load& load, double h) {
  State<double> next = semi_implicit(body, now.state, load, h);
  next.R_WB = naive_rotation_step<double>(h, next.w_WB, now.state.R_WB);
  return motion_of(body, next);
}

Motion step_euler_exponential(const Cuboid<double>& body, const Motion& now, const Load& load, double h) {
  State<double> next = semi_implicit(body, now.state, load, h);
  const Mat3<double> turn = exp_so3<double>(Vec3<double>(h * next.w_WB));
  for (int k = 0; k < 3; ++k) next.R_WB.col(k) = apply<double>(turn, now.state.R_WB.col(k));
  return motion_of(body, next);
}

Vec4<double> naive_quaternion_step(double h, const Vec3<double>& w, const Vec4<double>& q) {
  const Vec4<double> rate(-(w[0] * q[1] + w[1] * q[2] + w[2] * q[3]), w[0] * q[0] + w[1] * q[3] - w[2] * q[2], w[1] * q[0] + w[2] * q[1] - w[0] * q[3],
                          w[2] * q[0] + w[0] * q[2] - w[1] * q[1]);
  return q + h / 2 * rate;
}

Motion step_euler_quaternion(const Cuboid<double>& body, const Motion& now, const Load& load, double h) {
  State<double> next = semi_implicit(body, now.state, load, h);
  next.R_WB = rotation_of<double>(naive_quaternion_step(h, next.w_WB, quaternion_of<double>(now.state.R_WB)));
  return motion_of(body, next);
}

Motion fly_euler_momentum(const Cuboid<double>& body, const Motion& now, double h, long steps) {
  Motion x = now;
  Mat3<double>& R = x.state.R_WB;
  for (long step = 0; step < steps; ++step) {
    const Vec3<double> w_W = spin_of(body, R, x.L_W);
    if (step == steps - 1) x.state.w_WB = w_W;
    turn_by_cross(w_W, h, R);
  }
  x.state.p_WB += double(steps) * h * x.state.v_WB;
  return x;
}

Motion step_euler_momentum(const Cuboid<double>& body, const Motion& now, const Load& load, double h) {
  Motion next = now;
  next.L_W = advanced(now.L_W, h, load.tau_W);
  next.state.w_WB = apply<double>(world_inverse_inertia<double>(now.state.R_WB, body.inverse_inertia()), next.L_W);
  next.state.v_WB = advanced(now.state.v_WB, h, linear_acceleration<double>(body.inverse_mass(), load.f_W));
  next.state.p_WB = advanced(now.state.p_WB, h, next.state.v_WB);
  next.state.R_WB = gram_schmidt<double>(naive_rotation_step<double>(h, next.state.w_WB, now.state.R_WB));
  return next;
}

Motion step_euler_momentum_cross(const Cuboid<double>& body, const Motion& now, const Load& load, double h) {
  Motion next = now;
  next.L_W = advanced(now.L_W, h, load.tau_W);
  next.state.w_WB = spin_of(body, now.state.R_WB, next.L_W);
  next.state.v_WB = advanced(now.state.v_WB, h, linear_acceleration<double>(body.inverse_mass(), load.f_W));
  next.state.p_WB = advanced(now.state.p_WB, h, next.state.v_WB);
  turn_by_cross(next.state.w_WB, h, next.state.R_WB);
  return next;
}

}  // namespace rigor
