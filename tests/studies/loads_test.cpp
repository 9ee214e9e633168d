// Loads with known motions, through the same `integrate` the studies use.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <rigor/linalg/rotation.hpp>
#include <rigor/studies/convergence.hpp>

namespace rigor::studies {
namespace {

using V = Vec3<double>;
using C = std::complex<double>;

// case F-08: a motion chosen first, x(t) and R = Rz(sin t) Rx(t + t^2/4) Rz(cos 2t), and the loads it takes. tau = dL/dt by a
// complex step, exact to rounding. Every term of the equations is active.
struct Chosen {
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
Problem manufactured() {
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
double order(const Problem& p, const char* method, long steps) {
  const auto error = [&](long n) {
    const Errors e = errors_of(p, integrate(p, *find_method(method), n));
    return e.attitude + e.position;
  };
  return std::log2(error(steps) / error(2 * steps));
}

TEST(Manufactured, TheSpinIsTheRateOfTheAttitude) {
  const double h = 1e-30;
  for (const double t : {0.1, 0.7, 1.9}) {
    const Eigen::Matrix<C, 3, 3> R = Chosen::attitude<C>(C(t, h));
    const Mat3<double> rate = R.imag() / h, turn = rate * Chosen::attitude<double>(t).transpose();
    EXPECT_LT(norm<double>(V(V(turn(2, 1), turn(0, 2), turn(1, 0)) - Chosen::spin<double>(t))), 1e-14);
  }
}
TEST(Manufactured, IsRecoveredToTheOrderOfTheMethodOrTwo) {
  const Problem p = manufactured();
  for (const Method& m : methods()) {
    if (m.name == "euler-naive") continue;  // its R leaves the rotations
    EXPECT_NEAR(order(p, std::string(m.name).c_str(), m.order == 1 ? 2000 : 400), std::min(m.order, 2), 0.2) << m.name;
  }
}

// case F-03: a spring on the centre and one about a principal axis: cosines. The load is that of the beginning of a step, so
// every method is of order 1 here; symplectic ones keep the energy from growing.
TEST(Springs, OscillateWithTheirFrequency) {
  Problem p{"spring", "", "", *Cuboid<double>::make(2, {1, 2, 3}), {}, nullptr, 3, {}};
  const double k = 8, twist = 5, w = 2, turn = std::sqrt(twist / p.body.inertia()[2]);
  p.start.p_WB = V(0.3, -0.2, 0.1);
  p.start.R_WB = exp_so3<double>(V(0, 0, 0.4));
  p.load = [=](double, const State<double>& s) { return Load{V(-k * s.p_WB), V(0, 0, -twist * std::atan2(s.R_WB(1, 0), s.R_WB(0, 0)))}; };
  p.end = p.start;
  p.end.p_WB = std::cos(w * 3) * p.start.p_WB;
  p.end.v_WB = -w * std::sin(w * 3) * p.start.p_WB;
  p.end.R_WB = exp_so3<double>(V(0, 0, 0.4 * std::cos(turn * 3)));
  p.end.w_WB = V(0, 0, -turn * 0.4 * std::sin(turn * 3));
  for (const char* m : {"sheet", "euler-exponential", "euler-momentum", "explicit-euler"}) EXPECT_NEAR(order(p, m, 4000), 1, 0.05) << m;
}

// case F-04: quadratic drag on a fall: terminal speed, v = v_e tanh(g t/v_e); linear drag: an exponential.
TEST(Drag, SlowsAsItShould) {
  Problem p{"drag", "", "", *Cuboid<double>::make(2, {1, 2, 3}), {}, nullptr, 3, {}};
  const double g = 9.8, c = 0.5, v_e = std::sqrt(2 * g / c);
  p.load = [=](double, const State<double>& s) { return Load{V(0, -2 * g, 0) - c * norm<double>(s.v_WB) * s.v_WB, zero3<double>()}; };
  p.end = p.start;
  p.end.v_WB = V(0, -v_e * std::tanh(g * 3 / v_e), 0);
  p.end.p_WB = V(0, -v_e * v_e / g * std::log(std::cosh(g * 3 / v_e)), 0);
  EXPECT_NEAR(order(p, "sheet", 4000), 1, 0.05);
  EXPECT_NEAR(order(p, "explicit-euler", 4000), 1, 0.05);
  const State<double> end = integrate(p, *find_method("sheet"), 30000);
  EXPECT_NEAR(end.v_WB[1], p.end.v_WB[1], 2e-4 * v_e);  // a step of 1e-4 s changes v by 1e-3 m/s at most
  p.load = [=](double, const State<double>& s) { return Load{V(-c * s.v_WB), zero3<double>()}; };
  p.start.v_WB = V(4, 0, 0);
  p.end.v_WB = V(4 * std::exp(-0.25 * 3), 0, 0);
  p.end.p_WB = V(4 / 0.25 * (1 - std::exp(-0.25 * 3)), 0, 0);
  EXPECT_NEAR(order(p, "sheet", 4000), 1, 0.05);
}

}  // namespace
}  // namespace rigor::studies
