#include <rigor/integrators/turning.hpp>
#include <rigor/linalg/rotation.hpp>

namespace rigor {

using V = Vec3<double>;

void move_centre(const Cuboid<double>& body, const V& f_W, double h, State<double>& s) {
  for (int i = 0; i < 3; ++i) {
    const double a = body.inverse_mass() * f_W[i];
    s.p_WB[i] += h * (s.v_WB[i] + h / 2 * a);
    s.v_WB[i] += h * a;
  }
}

namespace {

void renew_spin(const Cuboid<double>& body, Motion& x) {
  const V L_B = apply_transposed<double>(x.state.R_WB, x.L_W);
  x.state.w_WB = apply<double>(x.state.R_WB, V(L_B.cwiseProduct(body.inverse_inertia())));
}
void turn_on(FreeTurn turn, const Cuboid<double>& body, double h, long steps, Motion& x) {
  Mat3<double>& R_WB = x.state.R_WB;
  R_WB = R_WB * rotation_of<double>(turn(body, apply_transposed<double>(R_WB, x.L_W), h, steps));
}

}  // namespace

Motion free_flight(FreeTurn turn, const Cuboid<double>& body, const Motion& now, double h, long steps) {
  Motion x = now;
  x.state.p_WB += double(steps) * h * x.state.v_WB;
  turn_on(turn, body, h, steps, x);
  renew_spin(body, x);
  return x;
}

Motion kicked_step(FreeTurn turn, const Cuboid<double>& body, const Motion& now, const Load& load, double h) {
  Motion next = now;
  move_centre(body, load.f_W, h, next.state);
  for (int i = 0; i < 3; ++i) next.L_W[i] += h / 2 * load.tau_W[i];
  turn_on(turn, body, h, 1, next);
  for (int i = 0; i < 3; ++i) next.L_W[i] += h / 2 * load.tau_W[i];
  renew_spin(body, next);
  return next;
}

namespace {

void kick(const Cuboid<double>& body, const LoadAt& load, double t, double h, Motion& x) {
  State<double>& s = x.state;
  const Load at = load(t, s);
  s.v_WB += h * body.inverse_mass() * at.f_W;
  x.L_W += h * at.tau_W;
  renew_spin(body, x);
}
void flow(FreeTurn turn, const Cuboid<double>& body, double h, Motion& x) {
  x.state.p_WB += h * x.state.v_WB;
  turn_on(turn, body, h, 1, x);
  renew_spin(body, x);  // the load may look at it
}

}  // namespace

Motion composed_step(FreeTurn turn, std::span<const double> stages, const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h) {
  Motion x = now;
  double carry = 0, done = 0;  // neighbouring half kicks are one
  for (const double stage : stages) {
    kick(body, load, t + done * h, (carry + stage / 2) * h, x);
    flow(turn, body, stage * h, x);
    done += stage;
    carry = stage / 2;
  }
  kick(body, load, t + h, carry * h, x);
  return x;
}

Motion split_step(FreeTurn turn, const Splitting& parts, const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h) {
  Motion x = now;
  double done = 0;
  for (std::size_t i = 0; i < parts.flow.size(); ++i) {
    kick(body, load, t + done * h, parts.kick[i] * h, x);
    flow(turn, body, parts.flow[i] * h, x);
    done += parts.flow[i];
  }
  kick(body, load, t + h, parts.kick.back() * h, x);
  return x;
}

}  // namespace rigor
