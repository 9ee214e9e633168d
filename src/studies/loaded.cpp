#include <cmath>
#include <complex>
#include <reference/loaded_body.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/studies/loaded.hpp>

namespace rigor::studies {
namespace {

using V = Vec3<double>;
using P = reference::Precise;
using J = reference::Jet<P>;
using reference::Jets;

const Mat3<double>& generic() {
  static const Mat3<double> R = rotation_of<double>(Vec4<double>(1, 2, -1, 3));
  return R;
}

J constant(double x) { return J(P(x)); }
constexpr const char* by_series = "Taylor series of order 24 of the law in 60 digits, 40 steps a second; own error below 1e-18, then rounded to double";
constexpr int order = 24;
constexpr double series_step = 0.025;

void put_end(Problem& p, const Mat3<P>& R_WB, const Vec3<P>& w_B) {
  p.end.R_WB = R_WB.cast<double>();
  p.end.w_WB = Vec3<P>(R_WB * w_B).cast<double>();
}

// A body that spins under a torque held in body axes and a weight of 1 N on an arm. Nothing pushes its centre.
Problem spun(const std::string& name, const std::string& says, const Cuboid<double>& body, const Mat3<double>& R_WB, const V& w_B, const V& arm_B, const V& tau_B, double until) {
  Problem p{name, says, by_series, body, {}, nullptr, until, {}};
  p.start.R_WB = R_WB;
  p.start.w_WB = apply<double>(R_WB, w_B);
  p.load = [=](double, const State<double>& s) {
    const V arm = apply<double>(s.R_WB, arm_B);
    return Load{zero3<double>(), V(apply<double>(s.R_WB, tau_B) + cross<double>(arm, V(0, 0, -1)))};
  };
  const auto end = reference::taylor_loaded_body({{body.inertia(), apply_transposed<double>(R_WB, p.start.w_WB), R_WB}, arm_B, tau_B}, until, order, series_step);
  put_end(p, end.R_WB, end.w_B);
  return p;
}

// case F-08: x(t) and R = Rz(sin t) Rx(t + t^2/4) Rz(cos 2t), for numbers real and complex.
template <class T>
Mat3<T> about(int axis, const T& angle) {
  using std::cos, std::sin;
  Mat3<T> R = Mat3<T>::Identity();
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  R(i, i) = R(j, j) = cos(angle);
  R(j, i) = sin(angle);
  R(i, j) = -sin(angle);
  return R;
}
template <class T>
Mat3<T> chosen_attitude(const T& t) {
  using std::cos, std::sin;
  return about<T>(2, sin(t)) * about<T>(0, T(t + t * t / 4.0)) * about<T>(2, cos(2.0 * t));
}
template <class T>
Vec3<T> chosen_spin(const T& t) {  // world axes: each rate about its axis as the turns before it left it
  using std::cos, std::sin;
  const Mat3<T> A = about<T>(2, sin(t)), B = A * about<T>(0, T(t + t * t / 4.0));
  return Vec3<T>(cos(t) * A.col(2) + (1.0 + t / 2.0) * A.col(0) - 2.0 * sin(2.0 * t) * B.col(2));
}

}  // namespace

Problem constant_push(const std::string& name, double until) {
  Problem p{name, "case F-01: a cuboid 1 x 2 x 3 m, 2 kg, from rest under F = (1, -2, 0.5) N and a torque of 0.75 N m about its third axis",
            "closed form: x = F t^2/2m, angle tau t^2/2I; own error a few roundings", cuboid(2, {1, 2, 3}), {}, nullptr, until, {}};
  const V f(1, -2, 0.5), tau(0, 0, 0.75);
  p.load = [=](double, const State<double>&) { return Load{f, tau}; };
  p.end.v_WB = until / p.body.mass() * f;
  p.end.p_WB = until / 2 * p.end.v_WB;
  p.end.w_WB = V(0, 0, tau[2] * p.body.inverse_inertia()[2] * until);
  p.end.R_WB = exp_so3<double>(V(until / 2 * p.end.w_WB));
  return p;
}

Problem axial_torque(const std::string& name, double until) {
  return spun(name, "case F-02: a square prism 1 x 1 x 3 m, 2 kg, spin (0.4, -0.3, 1.1) rad/s in body axes, under a torque of 0.7 N m about its own axis", cuboid(2, {1, 1, 3}), generic(),
              V(0.4, -0.3, 1.1), zero3<double>(), V(0, 0, 0.7), until);
}

Problem springs(const std::string& name, double until) {
  Problem p{name, "case F-03: a cuboid 1 x 2 x 3 m, 2 kg, on a spring of 8 N/m at its centre and one of 5 N m/rad about its third axis, let go at (0.3, -0.2, 0.1) m and 0.4 rad",
            "closed form: cosines; own error a few roundings", cuboid(2, {1, 2, 3}), {}, nullptr, until, {}};
  const double k = 8, twist = 5, w = std::sqrt(k / p.body.mass()), turn = std::sqrt(twist / p.body.inertia()[2]), angle = 0.4;
  p.start.p_WB = V(0.3, -0.2, 0.1);
  p.start.R_WB = exp_so3<double>(V(0, 0, angle));
  p.load = [=](double, const State<double>& s) { return Load{V(-k * s.p_WB), V(0, 0, -twist * std::atan2(s.R_WB(1, 0), s.R_WB(0, 0)))}; };
  p.end.p_WB = std::cos(w * until) * p.start.p_WB;
  p.end.v_WB = -w * std::sin(w * until) * p.start.p_WB;
  p.end.R_WB = exp_so3<double>(V(0, 0, angle * std::cos(turn * until)));
  p.end.w_WB = V(0, 0, -turn * angle * std::sin(turn * until));
  return p;
}

Problem drag(const std::string& name, double until) {
  Problem p{name, "case F-04: a cuboid 1 x 2 x 3 m, 2 kg, falls from rest at 9.8 m/s^2 against a drag of 0.5 |v| v, spinning at 2 rad/s about its third axis. A load that looks at velocities: ways that kick are of order 1 in position",
            "closed form: v = v_e tanh(g t/v_e); own error a few roundings", cuboid(2, {1, 2, 3}), {}, nullptr, until, {}};
  const double g = 9.8, m = p.body.mass(), c = 0.5, v_e = std::sqrt(m * g / c);
  p.start.w_WB = V(0, 0, 2);
  p.load = [=](double, const State<double>& s) { return Load{V(0, -m * g, 0) - c * norm<double>(s.v_WB) * s.v_WB, zero3<double>()}; };
  p.end.v_WB = V(0, -v_e * std::tanh(g * until / v_e), 0);
  p.end.p_WB = V(0, -v_e * v_e / g * std::log(std::cosh(g * until / v_e)), 0);
  p.end.w_WB = p.start.w_WB;
  p.end.R_WB = exp_so3<double>(V(until * p.start.w_WB));
  return p;
}

Problem lagrange_top(const std::string& name, double until) {
  const double tilt = 0.6, spin = 12, precession = 0.35020353984998315346;  // of I1 W^2 cos th - I3 w3 W + P = 0
  return spun(name, "case F-05: Lagrange's top as a square prism, I = (1, 1, 0.5) kg m^2, its weight of 1 N at 2 m along its axis, tilted by 0.6 rad, spinning at 12 rad/s: it precesses steadily at 0.35020353984998315 rad/s",
              cuboid(3, {1, 1, std::sqrt(3.0)}), exp_so3<double>(V(tilt, 0, 0)), V(0, precession * std::sin(tilt), spin), V(0, 0, 2), zero3<double>(), until);
}
Problem kovalevskaya_top(const std::string& name, double until) {
  return spun(name, "case F-06: Kovalevskaya's top as a cuboid 1 x 1 x sqrt 3 m, 6 kg, its weight of 1 N at 1.5 m along the first axis, spin (0.5, -1.2, 2) rad/s in body axes", cuboid(6, {1, 1, std::sqrt(3.0)}),
              generic(), V(0.5, -1.2, 2), V(1.5, 0, 0), zero3<double>(), until);
}
Problem goryachev_top(const std::string& name, double until) {
  const Cuboid<double> body = cuboid(6, {1, 1, std::sqrt(7.0)});
  const V up = generic().row(2), I = body.inertia();
  V w(0.5, -1.2, 0);
  w[2] = -(I[0] * w[0] * up[0] + I[1] * w[1] * up[1]) / (I[2] * up[2]);
  return spun(name, "case F-07: Goryachev and Chaplygin's top as a cuboid 1 x 1 x sqrt 7 m, 6 kg, its weight of 1 N at 1.5 m along the first axis, its angular momentum level", body, generic(), w, V(1.5, 0, 0),
              zero3<double>(), until);
}

Problem chosen_motion(const std::string& name, double until) {
  using C = std::complex<double>;
  Problem p{name, "case F-08: a cuboid 1 x 2 x 3 m, 2 kg, under the force and torque that make it move by x = (sin t, t^3/3, cos 2t), R = Rz(sin t) Rx(t + t^2/4) Rz(cos 2t): every term is active",
            "the motion chosen beforehand; the torque is the rate of L by a complex step; own error a few roundings", cuboid(2, {1, 2, 3}), {}, nullptr, until, {}};
  const V I = p.body.inertia();
  const auto state = [](double t) {
    State<double> s;
    s.p_WB = V(std::sin(t), t * t * t / 3, std::cos(2 * t));
    s.v_WB = V(std::cos(t), t * t, -2 * std::sin(2 * t));
    s.R_WB = chosen_attitude<double>(t);
    s.w_WB = chosen_spin<double>(t);
    return s;
  };
  p.start = state(0);
  p.end = state(until);
  p.load = [I, m = p.body.mass()](double t, const State<double>&) {
    const double h = 1e-30;
    const Mat3<C> R = chosen_attitude<C>(C(t, h));
    const Vec3<C> L_B = (R.transpose() * chosen_spin<C>(C(t, h))).cwiseProduct(I.cast<C>()), L = R * L_B;
    return Load{m * V(-std::sin(t), 2 * t, -4 * std::cos(2 * t)), V(L.imag() / h)};
  };
  return p;
}

// Its L and its centre have closed forms; the attitude follows L by series.
Problem changing_load(const std::string& name, double until) {
  Problem p{name, "a cuboid 1 x 2 x 3 m, 1 kg, under F = (sin t, -1, cos 2t) N and torque (cos t, sin 2t, 1/2) N m", std::string("L and the centre in closed form, the attitude by ") + by_series, cuboid(1, {1, 2, 3}), {}, nullptr, until, {}};
  p.start.R_WB = generic();
  p.start.w_WB = V(0.3, 1, -0.4);
  p.start.v_WB = V(1, 0, -1);
  p.load = [](double t, const State<double>&) { return Load{V(std::sin(t), -1, std::cos(2 * t)), V(std::cos(t), std::sin(2 * t), 0.5)}; };
  const double t = until;
  p.end.v_WB = V(2 - std::cos(t), -t, std::sin(2 * t) / 2 - 1);
  p.end.p_WB = V(2 * t - std::sin(t), -t * t / 2, (1 - std::cos(2 * t)) / 4 - t);
  const V L0 = motion_of(p.body, p.start).L_W, I = p.body.inertia();
  const Mat3<double> R0 = p.start.R_WB;
  const auto spin_of = [&](const J& at, const Jets& q) {  // body axes
    const Jets L{constant(L0[0]) + sin(at), constant(L0[1]) + (constant(1) - cos(constant(2) * at)) * constant(0.5), constant(L0[2]) + constant(0.5) * at};
    Jets at_start, spin;
    for (int i = 0; i < 3; ++i) at_start.push_back(constant(R0(0, i)) * L[0] + constant(R0(1, i)) * L[1] + constant(R0(2, i)) * L[2]);
    const Jets L_B = reference::turned_back(q, at_start);
    for (std::size_t i = 0; i < 3; ++i) spin.push_back(L_B[i] * J(P(1) / P(I[int(i)])));
    return spin;
  };
  const auto law = [&](const J& at, const Jets& q) { return reference::quaternion_rate(q, spin_of(at, q)); };
  const std::vector<P> q = reference::taylor<P>(law, {P(1), P(0), P(0), P(0)}, P(0), P(until), order, int(std::ceil(until / series_step)));
  const Jets spin = spin_of(J(P(until)), {J(q[0]), J(q[1]), J(q[2]), J(q[3])});
  put_end(p, R0.cast<P>() * rotation_of<P>(Vec4<P>(q[0], q[1], q[2], q[3])), Vec3<P>(spin[0][0], spin[1][0], spin[2][0]));
  return p;
}

}  // namespace rigor::studies
