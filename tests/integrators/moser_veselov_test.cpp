// The coefficients of the preprocessed map, in fifty digits: one short step against the Taylor series of the motion.
#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <rigor/integrators/preprocessed_moments.hpp>

namespace rigor {
namespace {

using T = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
using Turn = std::array<T, 4>;  // a unit quaternion

Turn normalised(const Turn& q) {
  const T n = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  return {q[0] / n, q[1] / n, q[2] / n, q[3] / n};
}

/// Moser and Veselov's step for inverse moments J: the quaternion (1, e) with J⁻¹ e = h/2 L (1 + |e|²) + (J⁻¹ e) × e, by fixed point.
Turn moser_veselov(const Vec3<T>& J, const Vec3<T>& L, const T& h) {
  const Vec3<T> I(1 / J[0], 1 / J[1], 1 / J[2]);
  Vec3<T> e = L.cwiseProduct(J) * (h / 2);
  for (int k = 0; k < 40; ++k) {  // each round gains the digits of |ω|h/2
    const Vec3<T> Ie = I.cwiseProduct(e), right = L * (h / 2 * (1 + dot<T>(e, e))) + cross<T>(Ie, e);
    e = J.cwiseProduct(right);
  }
  return normalised({1, e[0], e[1], e[2]});
}

/// The turn of the body in h, by the Taylor series of L' = L × ω and q' = q ω/2 to order 16: exact to h^17.
Turn taylor(const Vec3<T>& J, const Vec3<T>& L0, const T& h) {
  constexpr int order = 16;
  std::array<Vec3<T>, order + 1> L, w;
  std::array<Turn, order + 1> q;
  L[0] = L0, q[0] = {1, 0, 0, 0};
  for (int n = 0; n < order; ++n) {
    w[n] = J.cwiseProduct(L[n]);
    Vec3<T> dL = zero3<T>();
    Turn dq{0, 0, 0, 0};
    for (int k = 0; k <= n; ++k) {
      dL += cross<T>(L[k], w[n - k]);
      const Turn& a = q[k];
      const Vec3<T>& b = w[n - k];
      dq[0] += -a[1] * b[0] - a[2] * b[1] - a[3] * b[2];
      dq[1] += a[0] * b[0] + a[2] * b[2] - a[3] * b[1];
      dq[2] += a[0] * b[1] + a[3] * b[0] - a[1] * b[2];
      dq[3] += a[0] * b[2] + a[1] * b[1] - a[2] * b[0];
    }
    L[n + 1] = dL / T(n + 1);
    for (int i = 0; i < 4; ++i) q[n + 1][i] = dq[i] / T(2 * (n + 1));
  }
  Turn end{0, 0, 0, 0};
  for (int n = order; n >= 0; --n)
    for (int i = 0; i < 4; ++i) end[i] = end[i] * h + q[n][i];
  return normalised(end);
}

T missed(const Vec3<T>& I, const Vec3<T>& L, const T& h, int order) {
  const Vec3<T> J(1 / I[0], 1 / I[1], 1 / I[2]);
  const Turn got = moser_veselov(preprocessed_inverse_moments<T>(I, J, L, h, order), L, h), want = taylor(J, L, h);
  T sum = 0;
  for (int i = 0; i < 4; ++i) sum += (got[i] - want[i]) * (got[i] - want[i]);
  return sqrt(sum);
}

// An order lower than stated would show at once: at h = 1e-4 a coefficient of the last terms that is off by 1e-6 of itself outweighs the
// step's own error.
TEST(MoserVeselov, EveryCoefficientOfThePreprocessedMapIsRight) {
  const Vec3<T> I(T(13) / 12, T(10) / 12, T(5) / 12);  // the cuboid 1 x 2 x 3 of one kilogram
  for (const Vec3<T>& L : {Vec3<T>(T(7) / 10, -1, T(3) / 10), Vec3<T>(T(-1) / 5, T(1) / 3, 2)})
    for (const int order : {2, 4, 8}) {
      const T h = T(1) / 8192;
      EXPECT_NEAR(double(log(missed(I, L, h, order) / missed(I, L, h / 2, order)) / log(T(2))), order + 1, 1e-3) << order;
    }
}

}  // namespace
}  // namespace rigor
