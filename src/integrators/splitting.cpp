#include <cmath>
#include <rigor/integrators/composition.hpp>
#include <rigor/integrators/splitting.hpp>
#include <rigor/integrators/turning.hpp>
#include <rigor/linalg/rotation.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;

/// R ← R exp(a e_k), L ← exp(−a e_k) L: a turn about body axis k.
void turn_about(int k, double a, Turning& x) {
  const int i = (k + 1) % 3, j = (k + 2) % 3;
  const double c = std::cos(a), s = std::sin(a), y = x.L_B[i], z = x.L_B[j];
  x.L_B[i] = c * y + s * z;
  x.L_B[j] = c * z - s * y;
  for (int row = 0; row < 3; ++row) {
    const double b = x.R_WB(row, i), d = x.R_WB(row, j);
    x.R_WB(row, i) = c * b + s * d;
    x.R_WB(row, j) = c * d - s * b;
  }
}

// Neighbouring half turns about the same axis are done as one: `carry`.
template <const auto& stages>
Turning three_axes(const Cuboid<double>& body, const Turning& now, double h) {
  const V& inverse_I = body.inverse_inertia();
  Turning x = now;
  double carry = 0;
  for (const double stage : stages) {
    const double g = stage * h;
    turn_about(0, (carry + g / 2) * x.L_B[0] * inverse_I[0], x);
    turn_about(1, g / 2 * x.L_B[1] * inverse_I[1], x);
    turn_about(2, g * x.L_B[2] * inverse_I[2], x);
    turn_about(1, g / 2 * x.L_B[1] * inverse_I[1], x);
    carry = g / 2;
  }
  turn_about(0, carry * x.L_B[0] * inverse_I[0], x);
  return x;
}

int middle_axis(const V& I) {
  for (int k = 0; k < 3; ++k)
    if ((I[k] >= I[(k + 1) % 3]) == (I[k] <= I[(k + 2) % 3])) return k;
  return 1;  // all three equal
}

template <const auto& stages>
Turning two_axes(const Cuboid<double>& body, const Turning& now, double h) {
  const V& inverse_I = body.inverse_inertia();
  const int k = middle_axis(body.inertia()), a = (k + 1) % 3, c = (k + 2) % 3;
  const double rate_a = inverse_I[a] - inverse_I[k], rate_c = inverse_I[c] - inverse_I[k];
  const V L_W = apply<double>(now.R_WB, now.L_B);
  Turning x = now;
  double carry = 0;
  for (const double stage : stages) {
    const double g = stage * h;
    turn_about(c, (carry + g / 2) * x.L_B[c] * rate_c, x);
    turn_about(a, g * x.L_B[a] * rate_a, x);
    carry = g / 2;
  }
  turn_about(c, carry * x.L_B[c] * rate_c, x);
  x.R_WB = exp_so3<double>(V(h * inverse_I[k] * L_W)) * x.R_WB;
  return x;
}

}  // namespace

Motion step_split3(const Cuboid<double>& body, const Motion& now, const Load& load, double h) { return kicked_step(three_axes<strang>, body, now, load, h); }
Motion step_split3_yoshida4(const Cuboid<double>& body, const Motion& now, const Load& load, double h) { return kicked_step(three_axes<yoshida4>, body, now, load, h); }
Motion step_split2(const Cuboid<double>& body, const Motion& now, const Load& load, double h) { return kicked_step(two_axes<strang>, body, now, load, h); }
Motion step_split2_yoshida4(const Cuboid<double>& body, const Motion& now, const Load& load, double h) { return kicked_step(two_axes<yoshida4>, body, now, load, h); }
Motion step_split2_kahan_li6(const Cuboid<double>& body, const Motion& now, const Load& load, double h) { return kicked_step(two_axes<kahan_li6>, body, now, load, h); }
Motion step_split2_kahan_li8(const Cuboid<double>& body, const Motion& now, const Load& load, double h) { return kicked_step(two_axes<kahan_li8>, body, now, load, h); }
Motion step_split3_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h) { return composed_step(three_axes<strang>, strang, body, now, load, t, h); }
Motion step_split3_yoshida4_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h) { return composed_step(three_axes<strang>, yoshida4, body, now, load, t, h); }
Motion step_split2_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h) { return composed_step(two_axes<strang>, strang, body, now, load, t, h); }
Motion step_split2_yoshida4_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h) { return composed_step(two_axes<strang>, yoshida4, body, now, load, t, h); }
Motion step_split2_kahan_li6_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h) { return composed_step(two_axes<strang>, kahan_li6, body, now, load, t, h); }
Motion step_split2_kahan_li8_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h) { return composed_step(two_axes<strang>, kahan_li8, body, now, load, t, h); }

}  // namespace rigor
