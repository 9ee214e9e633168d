#include <rigor/integrators/turning.hpp>

namespace rigor {

using V = Vec3<double>;

void move_centre(const Cuboid<double>& body, const V& f_W, double h, State<double>& s) {
  for (int i = 0; i < 3; ++i) {
    const double a = body.inverse_mass() * f_W[i];
    s.p_WB[i] += h * (s.v_WB[i] + h / 2 * a);
    s.v_WB[i] += h * a;
  }
}

Motion kicked_step(FreeTurn turn, const Cuboid<double>& body, const Motion& now, const Load& load, double h) {
  Motion next = now;
  move_centre(body, load.f_W, h, next.state);
  for (int i = 0; i < 3; ++i) next.L_W[i] += h / 2 * load.tau_W[i];
  next.state.R_WB = turn(body, {now.state.R_WB, apply_transposed<double>(now.state.R_WB, next.L_W)}, h).R_WB;
  for (int i = 0; i < 3; ++i) next.L_W[i] += h / 2 * load.tau_W[i];
  const V L_B = apply_transposed<double>(next.state.R_WB, next.L_W);
  next.state.w_WB = apply<double>(next.state.R_WB, V(L_B.cwiseProduct(body.inverse_inertia())));
  return next;
}

}  // namespace rigor
