#include <cmath>
#include <reference/taylor.hpp>
#include <rigor/linalg/rotation.hpp>
#include <vector>

namespace rigor::reference {
namespace {

template <class T>
struct Series {
  std::vector<T> w[3], q[4];
};

// Coefficients up to `order` of ω_i' = c_i ω_j ω_k and q' = q (0, ω)/2 from their values at the start of the step.
template <class T>
void expand(Series<T>& s, const T (&c)[3], int order) {
  for (int k = 0; k < order; ++k) {
    T a[3] = {T(0), T(0), T(0)}, b[4] = {T(0), T(0), T(0), T(0)};
    for (int j = 0; j <= k; ++j) {
      const T &x = s.w[0][std::size_t(k - j)], &y = s.w[1][std::size_t(k - j)], &z = s.w[2][std::size_t(k - j)];
      const std::size_t i = std::size_t(j);
      a[0] += s.w[1][i] * z, a[1] += s.w[2][i] * x, a[2] += s.w[0][i] * y;
      b[0] -= s.q[1][i] * x + s.q[2][i] * y + s.q[3][i] * z;
      b[1] += s.q[0][i] * x + s.q[2][i] * z - s.q[3][i] * y;
      b[2] += s.q[0][i] * y + s.q[3][i] * x - s.q[1][i] * z;
      b[3] += s.q[0][i] * z + s.q[1][i] * y - s.q[2][i] * x;
    }
    for (int i = 0; i < 3; ++i) s.w[i][std::size_t(k + 1)] = c[i] * a[i] / T(k + 1);
    for (int i = 0; i < 4; ++i) s.q[i][std::size_t(k + 1)] = b[i] / T(2 * (k + 1));
  }
}
template <class T>
T horner(const std::vector<T>& coefficients, const T& h) {
  T sum = coefficients.back();
  for (std::size_t k = coefficients.size() - 1; k-- > 0;) sum = sum * h + coefficients[k];
  return sum;
}

}  // namespace

template <class T>
Attitude<T> taylor_free_body(const Vec3<T>& I, const Vec3<T>& w_B, const Mat3<T>& R_WB, const T& t, int order, double step) {
  const T c[3] = {(I[1] - I[2]) / I[0], (I[2] - I[0]) / I[1], (I[0] - I[1]) / I[2]};
  Series<T> s;
  for (auto& x : s.w) x.assign(std::size_t(order + 1), T(0));
  for (auto& x : s.q) x.assign(std::size_t(order + 1), T(0));
  for (int i = 0; i < 3; ++i) s.w[i][0] = w_B[i];
  s.q[0][0] = T(1);  // the turn since t = 0; R_WB comes in at the end, exactly as given
  const int steps = std::max(1, int(std::ceil(std::abs(double(t)) / step)));
  const T h = t / T(steps);
  for (int n = 0; n < steps; ++n) {
    expand<T>(s, c, order);
    for (auto& x : s.w) x[0] = horner<T>(x, h);
    for (auto& x : s.q) x[0] = horner<T>(x, h);
  }
  const Mat3<T> turn = rotation_of<T>(Vec4<T>(s.q[0][0], s.q[1][0], s.q[2][0], s.q[3][0]));
  Attitude<T> end;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      end.R_WB(i, k) = R_WB(i, 0) * turn(0, k) + R_WB(i, 1) * turn(1, k) + R_WB(i, 2) * turn(2, k);
  end.w_B = Vec3<T>(s.w[0][0], s.w[1][0], s.w[2][0]);
  return end;
}

template Attitude<Precise> taylor_free_body<Precise>(const Vec3<Precise>&, const Vec3<Precise>&, const Mat3<Precise>&, const Precise&, int, double);
template Attitude<long double> taylor_free_body<long double>(const Vec3<long double>&, const Vec3<long double>&, const Mat3<long double>&, const long double&, int, double);
template Attitude<double> taylor_free_body<double>(const Vec3<double>&, const Vec3<double>&, const Mat3<double>&, const double&, int, double);

}  // namespace rigor::reference
