#include <array>
#include <rigor/integrators/composition.hpp>
#include <rigor/integrators/taylor.hpp>
#include <rigor/integrators/turning.hpp>
#include <rigor/linalg/rotation.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;
constexpr std::size_t order = 16;

Turning taylor(const Cuboid<double>& body, const Turning& now, double h) {
  using Series = std::array<double, order + 1>;  // terms with their power of h
  const V &I = body.inertia(), &inverse_I = body.inverse_inertia();
  const V c((I[1] - I[2]) * inverse_I[0], (I[2] - I[0]) * inverse_I[1], (I[0] - I[1]) * inverse_I[2]);
  std::array<Series, 3> w;
  std::array<Series, 4> q;
  for (std::size_t i = 0; i < 3; ++i) w[i][0] = now.L_B[int(i)] * inverse_I[int(i)];
  q[0][0] = 1, q[1][0] = q[2][0] = q[3][0] = 0;
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
    const double step = h / double(k + 1);
    w[0][k + 1] = c[0] * a0 * step, w[1][k + 1] = c[1] * a1 * step, w[2][k + 1] = c[2] * a2 * step;
    q[0][k + 1] = b0 * step / 2, q[1][k + 1] = b1 * step / 2, q[2][k + 1] = b2 * step / 2, q[3][k + 1] = b3 * step / 2;
  }
  Vec4<double> turn = Vec4<double>::Zero();
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = order + 1; k-- > 0;) turn[int(i)] += q[i][k];  // small terms first
  const Mat3<double> E = rotation_of<double>(turn);
  return {now.R_WB * E, apply_transposed<double>(E, now.L_B)};
}

}  // namespace

Motion step_taylor16(const Cuboid<double>& body, const Motion& now, const Load& load, double h) { return kicked_step(taylor, body, now, load, h); }
Motion step_taylor16_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h) { return composed_step(taylor, kahan_li8, body, now, load, t, h); }

}  // namespace rigor
