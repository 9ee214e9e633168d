#pragma once
#include <cmath>
#include <rigor/linalg/types.hpp>
#include <rigor/scalar/gamma.hpp>

namespace rigor {

/// Quaternion (w, x, y, z), body to world, as plain numbers.
template <class T>
using Vec4 = Eigen::Matrix<T, 4, 1>;

/// R of a quaternion that need not have unit length: R = 1 + (2/n)(s[v]ₓ + [v]ₓ²), n = s² + v·v.
///
/// Exact over ℚ: every integer quaternion ≠ 0 gives an orthogonal matrix of rationals with determinant 1.
/// Source: Euler-Rodrigues parameters; rounding: each entry within a few u.
template <Field T>
Mat3<T> rotation_of(const Vec4<T>& q) {
  const T &s = q[0], &x = q[1], &y = q[2], &z = q[3];
  const T k = T(2) / (s * s + x * x + y * y + z * z);
  Mat3<T> R;
  R << T(1) - k * (y * y + z * z), k * (x * y - s * z), k * (x * z + s * y),  //
      k * (x * y + s * z), T(1) - k * (x * x + z * z), k * (y * z - s * x),   //
      k * (x * z - s * y), k * (y * z + s * x), T(1) - k * (x * x + y * y);
  return R;
}

/// exp([θ]ₓ), Rodrigues' formula: the rotation by |θ| rad about θ. Series below |θ|² = 2^-10 (next term < u/2).
template <Real T>
Mat3<T> exp_so3(const Vec3<T>& theta) {
  using std::cos, std::sin, std::sqrt;
  const T t2 = dot<T>(theta, theta);
  T a, b;  // sin t / t, (1 − cos t) / t²
  if (t2 < T(1) / T(1024)) {
    a = T(1), b = T(1) / T(2);
    T ta = T(1), tb = T(1) / T(2);
    for (int k = 1; k <= 16; ++k) {  // enough for 50 digits
      ta = -ta * t2 / T(2 * k * (2 * k + 1));
      tb = -tb * t2 / T((2 * k + 1) * (2 * k + 2));
      a = a + ta, b = b + tb;
      if (a + ta == a && b + tb == b) break;
    }
  } else {
    const T t = sqrt(t2), half = sin(t / T(2)) / t;
    a = sin(t) / t, b = T(2) * half * half;
  }
  Mat3<T> R;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) R(i, j) = b * theta[i] * theta[j] + (i == j ? T(1) - b * t2 : T(0));
  const Mat3<T> W = skew<T>(theta);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) R(i, j) = R(i, j) + a * W(i, j);
  return R;
}

/// The rotation angle between two rotation matrices, rad in [0, π], without loss near 0:
/// |A − B|_F = 2√2 sin(angle/2).
template <Real T>
T angle_between(const Mat3<T>& A, const Mat3<T>& B) {
  using std::asin, std::sqrt;
  T sum = T(0);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) sum = sum + (A(i, j) - B(i, j)) * (A(i, j) - B(i, j));
  const T s = sqrt(sum / T(8));
  return s < T(1) ? T(2) * asin(s) : T(2) * asin(T(1));
}

/// max |RᵀR − 1|: how far R is from orthonormal columns.
template <Field T>
T orthonormality_defect(const Mat3<T>& R) {
  T worst = T(0);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const T d = dot<T>(R.col(i), R.col(j)) - (i == j ? T(1) : T(0));
      const T size = d < T(0) ? -d : d;
      if (!(size <= worst)) worst = size;  // written so that NaN is kept
    }
  return worst;
}

/// The unit quaternion (w, x, y, z) of a rotation matrix, w ≥ 0. Shepperd's choice of the largest component.
template <Rooted T>
Vec4<T> quaternion_of(const Mat3<T>& R) {
  using std::sqrt;
  const T d[4] = {R(0, 0) + R(1, 1) + R(2, 2), R(0, 0), R(1, 1), R(2, 2)};
  int k = 0;
  for (int i = 1; i < 4; ++i)
    if (d[k] < d[i]) k = i;
  Vec4<T> q;
  if (k == 0) {
    const T s = sqrt(T(1) + d[0]);  // 2w
    q << s / T(2), (R(2, 1) - R(1, 2)) / (T(2) * s), (R(0, 2) - R(2, 0)) / (T(2) * s),
        (R(1, 0) - R(0, 1)) / (T(2) * s);
  } else {
    const int i = k - 1, j = (i + 1) % 3, l = (i + 2) % 3;
    const T s = sqrt(T(1) + R(i, i) - R(j, j) - R(l, l));  // twice component i
    q[0] = (R(l, j) - R(j, l)) / (T(2) * s);
    q[1 + i] = s / T(2);
    q[1 + j] = (R(j, i) + R(i, j)) / (T(2) * s);
    q[1 + l] = (R(l, i) + R(i, l)) / (T(2) * s);
  }
  if (q[0] < T(0)) q = -q;
  return q;
}

}  // namespace rigor
