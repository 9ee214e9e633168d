#pragma once
#include <cmath>
#include <complex>
#include <rigor/studies/problem.hpp>

namespace rigor::studies {

// case F-08: a motion chosen first, x(t) and R = Rz(sin t) Rx(t + t^2/4) Rz(cos 2t), and the loads it takes. tau = dL/dt by a
// complex step, exact to rounding. Every term of the equations is active.
struct Chosen {
  using V = Vec3<double>;
  template <class T>
  static Eigen::Matrix<T, 3, 3> about(int axis, const T& angle) {
    using std::cos, std::sin;
    Eigen::Matrix<T, 3, 3> R = Eigen::Matrix<T, 3, 3>::Identity();
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    R(i, i) = R(j, j) = cos(angle);
    R(j, i) = sin(angle);
    R(i, j) = -sin(angle);
    return R;
  }
  template <class T>
  static Eigen::Matrix<T, 3, 3> attitude(const T& t) {
    using std::cos, std::sin;
    return about<T>(2, sin(t)) * about<T>(0, T(t + t * t / 4.0)) * about<T>(2, cos(2.0 * t));
  }
  template <class T>
  static Eigen::Matrix<T, 3, 1> spin(const T& t) {  // world axes: each rate about its axis as the turns before it left it
    using std::cos, std::sin;
    const Eigen::Matrix<T, 3, 3> A = about<T>(2, sin(t)), B = A * about<T>(0, T(t + t * t / 4.0));
    return Eigen::Matrix<T, 3, 1>(cos(t) * A.col(2) + (1.0 + t / 2.0) * A.col(0) * T(1) - 2.0 * sin(2.0 * t) * B.col(2));
  }
  template <class T>
  static Eigen::Matrix<T, 3, 1> momentum(const V& I, const T& t) {
    const Eigen::Matrix<T, 3, 3> R = attitude<T>(t);
    Eigen::Matrix<T, 3, 1> L_B = R.transpose() * spin<T>(t);
    for (int i = 0; i < 3; ++i) L_B[i] *= I[i];
    return R * L_B;
  }
};
inline Problem manufactured() {
  using V = Vec3<double>;
  using C = std::complex<double>;
  Problem p{"manufactured", "", "", *Cuboid<double>::make(2, {1, 2, 3}), {}, nullptr, 2, {}};
  const V I = p.body.inertia();
  const auto position = [](double t) { return V(std::sin(t), t * t * t / 3, std::cos(2 * t)); };
  const auto velocity = [](double t) { return V(std::cos(t), t * t, -2 * std::sin(2 * t)); };
  const auto state = [=](double t) {
    State<double> s;
    s.p_WB = position(t);
    s.v_WB = velocity(t);
    s.R_WB = Chosen::attitude<double>(t);
    s.w_WB = Chosen::spin<double>(t);
    return s;
  };
  p.start = state(0);
  p.end = state(p.until);
  p.load = [I](double t, const State<double>&) {
    const double h = 1e-30;
    const Eigen::Matrix<C, 3, 1> L = Chosen::momentum<C>(I, C(t, h));
    return Load{2 * V(-std::sin(t), 2 * t, -4 * std::cos(2 * t)), V(L[0].imag() / h, L[1].imag() / h, L[2].imag() / h)};
  };
  return p;
}

}  // namespace rigor::studies
