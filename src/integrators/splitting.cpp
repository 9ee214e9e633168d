#include <rigor/integrators/composition.hpp>
#include <rigor/integrators/quaternion.hpp>
#include <rigor/integrators/splitting.hpp>
#include <rigor/integrators/turning.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;

/// A turn by 2x rad about axis k of the body: q ← q (cos x, sin x e_k), L ← exp(−2x e_k) L.
template <int k>
void turn_about(double x, Vec4<double>& q, V& L) {
  constexpr int i = (k + 1) % 3, j = (k + 2) % 3;
  const CosSinc half = cos_sinc(x * x);
  const double c = half.cos, s = x * half.sinc, C = 1 - 2 * s * s, S = 2 * s * c, y = L[i], z = L[j];
  L[i] = C * y + S * z, L[j] = C * z - S * y;
  Vec4<double> p;
  p[0] = q[0] * c - q[1 + k] * s, p[1 + k] = q[1 + k] * c + q[0] * s;
  p[1 + i] = q[1 + i] * c + q[1 + j] * s, p[1 + j] = q[1 + j] * c - q[1 + i] * s;
  q = p;
}

// Neighbouring half turns about the same axis are done as one, over stages and steps: `carry`.
template <const auto& stages>
Vec4<double> three_axes(const Cuboid<double>& body, const V& L_B, double h, long steps) {
  const V half = body.inverse_inertia() / 2;
  V L = L_B;
  Vec4<double> q(1, 0, 0, 0);
  double carry = 0;
  for (long step = 0; step < steps; ++step)
    for (const double stage : stages) {
      const double g = stage * h;
      turn_about<0>((carry + g / 2) * (L[0] * half[0]), q, L);
      turn_about<1>(g / 2 * (L[1] * half[1]), q, L);
      turn_about<2>(g * (L[2] * half[2]), q, L);
      turn_about<1>(g / 2 * (L[1] * half[1]), q, L);
      carry = g / 2;
    }
  turn_about<0>(carry * (L[0] * half[0]), q, L);
  return q;
}

template <const auto& stages>
Vec4<double> two_axes(const Cuboid<double>& body, const V& L_B, double h, long steps) {
  const int m = middle_axis(body.inertia());
  const auto to_second = [m](const V& x) { return V(x[(m + 2) % 3], x[m], x[(m + 1) % 3]); };  // the axes renamed in turn, the middle one to the second
  const V inverse_I = to_second(body.inverse_inertia()), L0 = to_second(L_B);
  const double half_first = (inverse_I[0] - inverse_I[1]) / 2, half_third = (inverse_I[2] - inverse_I[1]) / 2;
  V L = L0;
  Vec4<double> q(1, 0, 0, 0);
  double carry = 0;
  for (long step = 0; step < steps; ++step)
    for (const double stage : stages) {
      const double g = stage * h;
      turn_about<0>((carry + g / 2) * (L[0] * half_first), q, L);
      turn_about<2>(g * (L[2] * half_third), q, L);
      carry = g / 2;
    }
  turn_about<0>(carry * (L[0] * half_first), q, L);
  q = product(exp_quaternion(double(steps) * h * inverse_I[1] * L0), q);
  return Vec4<double>(q[0], q[1 + (4 - m) % 3], q[1 + (5 - m) % 3], q[1 + (6 - m) % 3]);
}

}  // namespace

int middle_axis(const V& I) {
  for (int k = 0; k < 2; ++k)
    if ((I[k] >= I[k + 1]) == (I[k] <= I[(k + 2) % 3])) return k;
  return 2;
}

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
Motion fly_split3(const Cuboid<double>& body, const Motion& now, double h, long steps) { return free_flight(three_axes<strang>, body, now, h, steps); }
Motion fly_split3_yoshida4(const Cuboid<double>& body, const Motion& now, double h, long steps) { return free_flight(three_axes<yoshida4>, body, now, h, steps); }
Motion fly_split2(const Cuboid<double>& body, const Motion& now, double h, long steps) { return free_flight(two_axes<strang>, body, now, h, steps); }
Motion fly_split2_yoshida4(const Cuboid<double>& body, const Motion& now, double h, long steps) { return free_flight(two_axes<yoshida4>, body, now, h, steps); }
Motion fly_split2_kahan_li6(const Cuboid<double>& body, const Motion& now, double h, long steps) { return free_flight(two_axes<kahan_li6>, body, now, h, steps); }
Motion fly_split2_kahan_li8(const Cuboid<double>& body, const Motion& now, double h, long steps) { return free_flight(two_axes<kahan_li8>, body, now, h, steps); }

}  // namespace rigor
