// Loads that change: what a method does with them has a closed form of its own.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <rigor/integrators/dormand_prince.hpp>
#include <rigor/integrators/euler.hpp>
#include <rigor/scalar/gamma.hpp>
#include <tests/integrators/laws.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;
using C = std::complex<double>;

State<double> fly(const char* name, const State<double>& start, double h, long steps, const LoadAt& load) {
  Motion now = motion_of(plate, start);
  for (long k = 0; k < steps; ++k) now = advance(*find_method(name), plate, now, load, double(k) * h, h);
  return now.state;
}

// case K-08: q + h/2 (0, w) q is longer by sqrt(1 + theta^2/4), theta = h|w|, and turns by 2 atan(theta/2).
TEST(QuaternionStep, GrowsAndTurnsAsItsClosedFormSays) {
  const V w(0.3, -1, 0.7);
  const double h = 0.05, theta = h * norm<double>(w);
  const int n = 400;
  Vec4<double> q(1, 0, 0, 0);
  for (int k = 0; k < n; ++k) q = naive_quaternion_step(h, w, q);
  const double grown = std::pow(1 + theta * theta / 4, n / 2.0), angle = n * 2 * std::atan(theta / 2);
  EXPECT_NEAR(q.norm(), grown, gamma_bound(8 * n) * grown);
  EXPECT_GT(grown, 1.1) << "a growth one can see";
  EXPECT_LT(angle_between<double>(rotation_of<double>(q), exp_so3<double>(V(angle / norm<double>(w) * w))), gamma_bound(8 * n));
  // the method makes it a unit one and keeps the angle: about the z axis, where the spin stays as it is
  State<double> s;
  s.w_WB = V(0, 0, 2);
  const State<double> end = fly("euler-quaternion", s, h, n, [](double, const State<double>&) { return Load{}; });
  EXPECT_LT(angle_between<double>(end.R_WB, exp_so3<double>(V(0, 0, n * 2 * std::atan(h)))), gamma_bound(16 * n));
  EXPECT_LT(orthonormality_defect<double>(end.R_WB), gamma_bound(16));
}

// case D-05: on x'' = -w^2 x an explicit Runge-Kutta method multiplies x + i v/w by R(-i h w), a polynomial; half kick, drift, half kick by
// the matrix [1 - z/2, h; -h w^2 (1 - z/4), 1 - z/2], z = (h w)^2: the same as of the mid-point rule for the centre.
TEST(Spring, EveryStepIsTheAmplificationOfItsMethod) {
  const double k = 8, w = std::sqrt(k / plate.mass()), h = 0.05;
  const long n = 200;
  const LoadAt spring = [&](double, const State<double>& s) { return Load{V(-k * s.p_WB), zero3<double>()}; };
  State<double> s;
  s.p_WB = V(1, 0, 0);
  s.v_WB = V(0.5, 0, 0);
  const C z(0, -h * w);  // (x + i v/w)' = -i w (x + i v/w)
  const auto polynomial = [&](std::initializer_list<double> divisors) {
    C sum = 1, power = 1;
    for (const double d : divisors) sum += (power *= z) / d;
    return sum;
  };
  const struct {
    const char* name;
    C R;
  } methods[] = {{"rk4", polynomial({1, 2, 6, 24})},
                 {"rkmk4", polynomial({1, 2, 6, 24})},
                 {"commutator-free4", polynomial({1, 2, 6, 24})},
                 {"dormand-prince", polynomial({1, 2, 6, 24, 120, 600})}};
  for (const auto& m : methods) {
    const State<double> end = fly(m.name, s, h, n, spring);
    const C want = C(1, 0.5 / w) * std::pow(m.R, double(n));
    EXPECT_NEAR(end.p_WB[0], want.real(), gamma_bound(40 * int(n))) << m.name;
    EXPECT_NEAR(end.v_WB[0] / w, want.imag(), gamma_bound(40 * int(n))) << m.name;
    EXPECT_GT(std::fabs(std::abs(std::pow(m.R, double(n))) - 1), 1e-9) << "not idle: the exact solution would not do";
  }
  Eigen::Matrix2d A;
  const double q = h * w * h * w;
  A << 1 - q / 2, h, -h * w * w * (1 - q / 4), 1 - q / 2;
  Eigen::Vector2d x(1, 0.5);
  for (long i = 0; i < n; ++i) x = A * x;
  for (const char* name : {"implicit-midpoint", "split2", "split3", "moser-veselov"}) {
    const State<double> end = fly(name, s, h, n, spring);
    EXPECT_NEAR(end.p_WB[0], x[0], gamma_bound(40 * int(n))) << name;
    EXPECT_NEAR(end.v_WB[0], x[1], gamma_bound(80 * int(n))) << name;
  }
}

// case D-10: with p stages' worth of order the velocity under a force t^k is exact for k <= p - 1, the position for k <= p - 2, in one
// step however long; one power more is not.
TEST(PolynomialForce, IsIntegratedExactlyUpToTheOrder) {
  for (const char* name : {"rk4", "rkmk4", "commutator-free4", "dormand-prince"}) {
    const int p = find_method(name)->forced_order;
    for (int k = 0; k <= p; ++k) {
      const LoadAt force = [&](double t, const State<double>&) { return Load{V(0, plate.mass() * std::pow(t, k), 0), zero3<double>()}; };
      const double t = 1.5, v = std::pow(t, k + 1) / (k + 1), x = std::pow(t, k + 2) / ((k + 1) * (k + 2));
      const State<double> end = fly(name, {}, t, 1, force);
      EXPECT_NEAR(end.v_WB[1], v, (k <= p - 1 ? gamma_bound(60) : 1) * v) << name << k;
      if (k == p) {
        EXPECT_GT(std::fabs(end.v_WB[1] - v), 1e-4 * v) << name << k;
      }
      if (k <= p - 2) {
        EXPECT_NEAR(end.p_WB[1], x, gamma_bound(60) * x) << name << k;
      }
    }
  }
}

// A torque that depends on the attitude: a pendulum about a principal axis, whose energy is known. Order 1 where the load is held.
TEST(Pendulum, KeepsItsEnergyToTheOrderOfTheMethod) {
  const LoadAt pull = [](double, const State<double>& s) { return Load{zero3<double>(), V(0, 0, -5 * s.R_WB(1, 0))}; };
  State<double> s;
  s.R_WB = exp_so3<double>(V(0, 0, 1.2));
  const double I = plate.inertia()[2];
  const auto energy = [&](const State<double>& x) { return I * x.w_WB[2] * x.w_WB[2] / 2 - 5 * x.R_WB(0, 0); };
  for (const Method& m : methods()) {
    if (m.forced_order == 1 || m.forced_order > 5) continue;
    const auto error = [&](long n) { return std::fabs(energy(fly(std::string(m.name).c_str(), s, 1.3 / double(n), n, pull)) - energy(s)); };
    const double order = std::log2(error(60) / error(120));
    EXPECT_GT(order, m.forced_order - 0.3) << m.name;
    EXPECT_LT(order, m.forced_order + 1.3) << m.name << ": Runge-Kutta methods of even order lose energy at one order more";
  }
}

const LoadAt free_of_load = [](double, const State<double>&) { return Load{}; };
// The error of the whole flight follows the tolerance; the judge is the flow by Taylor's sixteenth order in small steps.
TEST(DormandPrince, ErrorFollowsTheTolerance) {
  const State<double> s = tumbling(), want = fly("taylor16", s, 0.05, 200, free_of_load);
  long before = 0;
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
    const auto flown = fly_dormand_prince(plate, s, free_of_load, 0, 10, tolerance);
    ASSERT_TRUE(flown);
    const double error = angle_between<double>(flown->end.R_WB, want.R_WB);
    std::printf("tolerance %.0e: error %.1e rad, %ld steps, %ld rejected, %ld evaluations\n", tolerance, error, flown->steps, flown->rejected, flown->evaluations);
    EXPECT_LT(error, 100 * tolerance);
    EXPECT_GT(error, tolerance / 100) << "not idle";
    EXPECT_GT(flown->steps, before);
    EXPECT_EQ(flown->evaluations, 1 + 6 * (flown->steps + flown->rejected));
    before = flown->steps;
  }
}

TEST(DormandPrince, FliesBackAndStays) {
  const State<double> s = tumbling();
  const LoadAt drag = [](double t, const State<double>& x) { return Load{V(-0.5 * x.v_WB), V(V(std::cos(t), 0, 0.2) - 0.3 * x.w_WB)}; };
  const auto there = fly_dormand_prince(plate, s, drag, 0, 4, 1e-11);
  ASSERT_TRUE(there);
  EXPECT_GT(angle_between<double>(there->end.R_WB, s.R_WB), 0.1);
  const auto back = fly_dormand_prince(plate, there->end, drag, 4, 0, 1e-11);
  ASSERT_TRUE(back);
  EXPECT_LT(angle_between<double>(back->end.R_WB, s.R_WB), 1e-8);
  EXPECT_LT(norm<double>(V(back->end.p_WB - s.p_WB)), 1e-8);
  EXPECT_EQ(fly_dormand_prince(plate, s, drag, 4, 4, 1e-11)->steps, 0);
}

TEST(DormandPrince, RefusesWhatItCannotDo) {
  const State<double> s = tumbling();
  const auto fault = [&](const LoadAt& load, double t1, double tolerance) { return fly_dormand_prince(plate, s, load, 0, t1, tolerance).fault(); };
  for (const double beyond : {1e-16, 0.11}) EXPECT_EQ(fault(free_of_load, 1, beyond).where, "tolerance");
  for (const double ends : {1e-14, 1e-1}) EXPECT_TRUE(fly_dormand_prince(plate, s, free_of_load, 0, 1, ends)) << ends;
  EXPECT_EQ(fault(free_of_load, 1, NAN).kind, Fault::Kind::out_of_range);
  EXPECT_EQ(fault(free_of_load, NAN, 1e-8).kind, Fault::Kind::not_finite);
  EXPECT_EQ(fault(free_of_load, INFINITY, 1e-8).where, "time");
  EXPECT_EQ(fault([](double t, const State<double>&) { return Load{V(0, t > 0.5 ? NAN : 1, 0), zero3<double>()}; }, 1, 1e-8).where, "step");
}

}  // namespace
}  // namespace rigor
