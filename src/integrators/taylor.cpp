#include <array>
#include <rigor/integrators/composition.hpp>
#include <rigor/integrators/quaternion.hpp>
#include <rigor/integrators/taylor.hpp>
#include <rigor/integrators/turning.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;
constexpr std::size_t order = 16;

Vec4<double> taylor(const Cuboid<double>& body, const V& L_B, double h, long steps) {
  using Series = std::array<double, order + 1>;  // terms with their power of h
  const V &I = body.inertia(), &inverse_I = body.inverse_inertia();
  const V c((I[1] - I[2]) * inverse_I[0], (I[2] - I[0]) * inverse_I[1], (I[0] - I[1]) * inverse_I[2]);
  std::array<double, order> step_over;
  for (std::size_t k = 0; k < order; ++k) step_over[k] = h / double(k + 1);
  std::array<Series, 3> w;
  std::array<Series, 4> q;
  const auto sum = [](const Series& x) {
    double s = 0;
    for (std::size_t k = order + 1; k-- > 0;) s += x[k];  // small terms first
    return s;
  };
  for (std::size_t i = 0; i < 3; ++i) w[i][0] = L_B[int(i)] * inverse_I[int(i)];
  q[0][0] = 1, q[1][0] = q[2][0] = q[3][0] = 0;
  for (long step = 0; step < steps; ++step) {
    for (std::size_t k = 0; k < order; ++k) {
      double a0 = 0, a1 = 0, a2 = 0, b0 = 0, b1 = 0, b2 = 0, b3 = 0;
      for (std::size_t j = 0; j <= k; ++j) {
        const double x = w[0][k - j], y = w[1][k - j], z = w[2][k - j];
        a0 += w[1][j] * z, a1 += w[2][j] * x, a2 += w[0][j] * y;
        b0 -= q[1][j] * x + q[2][j] * y + q[3][j] * z;
        b1 += q[0][j] * x + q[2][j] * z - q[3][j] * y;
        b2 += q[0][j] * y + q[3][j] * x - q[1][j] * z;
        b3 += q[0][j] * z + q[1][j] * y - q[2][j] * x;
      }
      const double s = step_over[k];
      w[0][k + 1] = c[0] * a0 * s, w[1][k + 1] = c[1] * a1 * s, w[2][k + 1] = c[2] * a2 * s;
      q[0][k + 1] = b0 * s / 2, q[1][k + 1] = b1 * s / 2, q[2][k + 1] = b2 * s / 2, q[3][k + 1] = b3 * s / 2;
    }
    for (Series& x : w) x[0] = sum(x);
    for (Series& x : q) x[0] = sum(x);
    if (is_time_to_normalise(step)) {
      const Vec4<double> unit = normalised(Vec4<double>(q[0][0], q[1][0], q[2][0], q[3][0]));
      for (std::size_t i = 0; i < 4; ++i) q[i][0] = unit[int(i)];
    }
  }
  return Vec4<double>(q[0][0], q[1][0], q[2][0], q[3][0]);
}

}  // namespace

Motion step_taylor16(const Cuboid<double>& body, const Motion& now, const Load& load, double h) { return kicked_step(taylor, body, now, load, h); }
Motion step_taylor16_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h) { return composed_step(taylor, kahan_li8, body, now, load, t, h); }
Motion fly_taylor16(const Cuboid<double>& body, const Motion& now, double h, long steps) { return free_flight(taylor, body, now, h, steps); }

}  // namespace rigor
