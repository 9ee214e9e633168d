#include <rigor/formulas/angular_acceleration.hpp>
#include <rigor/formulas/linear_acceleration.hpp>
#include <rigor/formulas/semi_implicit_step.hpp>
#include <rigor/formulas/world_inverse_inertia.hpp>
#include <rigor/integrators/euler.hpp>
#include <rigor/integrators/quaternion.hpp>
#include <rigor/integrators/turning.hpp>

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
// The spin forms: where a step takes a state. L is not asked for in between.
using Next = State<double> (*)(const Cuboid<double>& body, const State<double>& s, const Load& load, double h);

State<double> sheet(const Cuboid<double>& body, const State<double>& s, const Load& load, double h) {
  const Rates r = rates(body, s, load);
  return semi_implicit_step<double>(h, s, r.a, r.alpha);
}
State<double> explicit_euler(const Cuboid<double>& body, const State<double>& s, const Load& load, double h) {
  const Rates r = rates(body, s, load);
  State<double> next;
  next.p_WB = advanced(s.p_WB, h, s.v_WB);
  next.R_WB = gram_schmidt<double>(naive_rotation_step<double>(h, s.w_WB, s.R_WB));
  next.v_WB = advanced(s.v_WB, h, r.a);
  next.w_WB = advanced(s.w_WB, h, r.alpha);
  return next;
}
State<double> naive(const Cuboid<double>& body, const State<double>& s, const Load& load, double h) {
  State<double> next = semi_implicit(body, s, load, h);
  next.R_WB = naive_rotation_step<double>(h, next.w_WB, s.R_WB);
  return next;
}
State<double> exponential(const Cuboid<double>& body, const State<double>& s, const Load& load, double h) {
  State<double> next = semi_implicit(body, s, load, h);
  const Mat3<double> turn = exp_so3<double>(Vec3<double>(h * next.w_WB));
  for (int k = 0; k < 3; ++k) next.R_WB.col(k) = apply<double>(turn, s.R_WB.col(k));
  return next;
}
State<double> quaternion(const Cuboid<double>& body, const State<double>& s, const Load& load, double h) {
  State<double> next = semi_implicit(body, s, load, h);
  next.R_WB = rotation_of<double>(naive_quaternion_step(h, next.w_WB, quaternion_of<double>(s.R_WB)));
  return next;
}
template <Next next>
Motion step_by(const Cuboid<double>& body, const Motion& now, const Load& load, double h) {
  return motion_of(body, next(body, now.state, load, h));
}
template <Next next>
[[gnu::flatten]] Motion fly_by(const Cuboid<double>& body, const Motion& now, double h, long steps) {
  State<double> s = now.state;
  for (long step = 0; step < steps; ++step) s = next(body, s, {}, h);
  return motion_of(body, s);
}

// The momentum form's new L and v.
Motion pushed(const Cuboid<double>& body, const Motion& now, const Load& load, double h) {
  Motion next = now;
  next.L_W = advanced(now.L_W, h, load.tau_W);
  next.state.v_WB = advanced(now.state.v_WB, h, linear_acceleration<double>(body.inverse_mass(), load.f_W));
  return next;
}
// Steps of the momentum form: spin by way of the body axes (sums as in apply and apply_transposed), Gram and Schmidt of R + h [w]x R
// with reciprocals, the third column as the product of the others. One loop with plain numbers: a State would go through memory.
void turn_by_cross(const Vec3<double>& inverse_I, const Vec3<double>& L_W, double h, long steps, State<double>& s) {
  const auto unit = [](const Vec3<double>& a) { return Vec3<double>(1 / norm<double>(a) * a); };
  Vec3<double> c0 = s.R_WB.col(0), c1 = s.R_WB.col(1), c2 = s.R_WB.col(2), w;
  for (long step = 0; step < steps; ++step) {
    w = dot<double>(c0, L_W) * inverse_I[0] * c0 + dot<double>(c1, L_W) * inverse_I[1] * c1 + dot<double>(c2, L_W) * inverse_I[2] * c2;
    const Vec3<double> a0 = advanced(c0, h, cross<double>(w, c0)), a1 = advanced(c1, h, cross<double>(w, c1));
    c0 = unit(a0);
    c1 = unit(advanced(a1, -dot<double>(c0, a1), c0));
    c2 = cross<double>(c0, c1);
  }
  if (steps > 0) s.w_WB = w;
  s.R_WB << c0, c1, c2;
}

Vec4<double> exponentials(const Cuboid<double>& body, const Vec3<double>& L_B, double h, long steps) {
  const Vec3<double> h_spin = h * body.inverse_inertia();
  return turn_by(L_B, steps, [&](const Vec3<double>& L) { return exp_quaternion(Vec3<double>(h_spin.cwiseProduct(L))); });
}

}  // namespace

Motion step_sheet(const Cuboid<double>& body, const Motion& now, const Load& load, double h) { return step_by<sheet>(body, now, load, h); }
Motion step_explicit_euler(const Cuboid<double>& body, const Motion& now, const Load& load, double h) { return step_by<explicit_euler>(body, now, load, h); }
Motion step_euler_naive(const Cuboid<double>& body, const Motion& now, const Load& load, double h) { return step_by<naive>(body, now, load, h); }
Motion step_euler_exponential(const Cuboid<double>& body, const Motion& now, const Load& load, double h) { return step_by<exponential>(body, now, load, h); }
Motion step_euler_quaternion(const Cuboid<double>& body, const Motion& now, const Load& load, double h) { return step_by<quaternion>(body, now, load, h); }
Motion fly_sheet(const Cuboid<double>& body, const Motion& now, double h, long steps) { return fly_by<sheet>(body, now, h, steps); }
Motion fly_explicit_euler(const Cuboid<double>& body, const Motion& now, double h, long steps) { return fly_by<explicit_euler>(body, now, h, steps); }
Motion fly_euler_naive(const Cuboid<double>& body, const Motion& now, double h, long steps) { return fly_by<naive>(body, now, h, steps); }
Motion fly_euler_exponential(const Cuboid<double>& body, const Motion& now, double h, long steps) { return fly_by<exponential>(body, now, h, steps); }
Motion fly_euler_quaternion(const Cuboid<double>& body, const Motion& now, double h, long steps) { return fly_by<quaternion>(body, now, h, steps); }

Vec4<double> naive_quaternion_step(double h, const Vec3<double>& w, const Vec4<double>& q) {
  const Vec4<double> rate(-(w[0] * q[1] + w[1] * q[2] + w[2] * q[3]), w[0] * q[0] + w[1] * q[3] - w[2] * q[2], w[1] * q[0] + w[2] * q[1] - w[0] * q[3],
                          w[2] * q[0] + w[0] * q[2] - w[1] * q[1]);
  return q + h / 2 * rate;
}

Motion fly_euler_momentum_cross(const Cuboid<double>& body, const Motion& now, double h, long steps) {
  Motion x = now;
  turn_by_cross(body.inverse_inertia(), x.L_W, h, steps, x.state);
  x.state.p_WB += double(steps) * h * x.state.v_WB;
  return x;
}

Motion step_euler_momentum(const Cuboid<double>& body, const Motion& now, const Load& load, double h) {
  Motion next = pushed(body, now, load, h);
  next.state.w_WB = apply<double>(world_inverse_inertia<double>(now.state.R_WB, body.inverse_inertia()), next.L_W);
  next.state.p_WB = advanced(now.state.p_WB, h, next.state.v_WB);
  next.state.R_WB = gram_schmidt<double>(naive_rotation_step<double>(h, next.state.w_WB, now.state.R_WB));
  return next;
}
Motion step_euler_momentum_cross(const Cuboid<double>& body, const Motion& now, const Load& load, double h) {
  return fly_euler_momentum_cross(body, pushed(body, now, load, h), h, 1);
}
Motion step_euler_momentum_exponential(const Cuboid<double>& body, const Motion& now, const Load& load, double h) {
  return fly_euler_momentum_exponential(body, pushed(body, now, load, h), h, 1);
}
Motion fly_euler_momentum_exponential(const Cuboid<double>& body, const Motion& now, double h, long steps) { return free_flight(exponentials, body, now, h, steps); }

}  // namespace rigor
