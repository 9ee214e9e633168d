#pragma once
#include <Eigen/Core>
#include <rigor/scalar/concepts.hpp>

namespace rigor {

template <class T>
using Vec3 = Eigen::Matrix<T, 3, 1>;
template <class T>
using Mat3 = Eigen::Matrix<T, 3, 3>;

template <class T>
Vec3<T> zero3() {
  return Vec3<T>(T(0), T(0), T(0));
}

template <class T>
Mat3<T> zero33() {
  return Mat3<T>::Constant(T(0));
}

template <class T>
Mat3<T> identity3() {
  Mat3<T> one;
  one << T(1), T(0), T(0), T(0), T(1), T(0), T(0), T(0), T(1);
  return one;
}

/// a·b as (a₀b₀ + a₁b₁) + a₂b₂, in this order: batch kernels reproduce it bit for bit.
template <Field T>
T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// a×b, each component one difference of two products.
template <Field T>
Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return Vec3<T>(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
}

/// M·v, each row as in dot().
template <Field T>
Vec3<T> apply(const Mat3<T>& M, const Vec3<T>& v) {
  return Vec3<T>(M(0, 0) * v[0] + M(0, 1) * v[1] + M(0, 2) * v[2], M(1, 0) * v[0] + M(1, 1) * v[1] + M(1, 2) * v[2],
                 M(2, 0) * v[0] + M(2, 1) * v[1] + M(2, 2) * v[2]);
}

/// Mᵀ·v, each row as in dot().
template <Field T>
Vec3<T> apply_transposed(const Mat3<T>& M, const Vec3<T>& v) {
  return Vec3<T>(M(0, 0) * v[0] + M(1, 0) * v[1] + M(2, 0) * v[2], M(0, 1) * v[0] + M(1, 1) * v[1] + M(2, 1) * v[2],
                 M(0, 2) * v[0] + M(1, 2) * v[1] + M(2, 2) * v[2]);
}

/// [w]ₓ, the matrix with [w]ₓ v = w × v.
template <Field T>
Mat3<T> skew(const Vec3<T>& w) {
  Mat3<T> W;
  W << T(0), -w[2], w[1], w[2], T(0), -w[0], -w[1], w[0], T(0);
  return W;
}

template <Rooted T>
T norm(const Vec3<T>& a) {
  using std::sqrt;
  return sqrt(dot<T>(a, a));
}

}  // namespace rigor
