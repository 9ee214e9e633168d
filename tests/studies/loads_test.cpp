// Loads with known motions, through the same `integrate` the studies use.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <rigor/engine/flow_methods.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/studies/convergence.hpp>
#include <tests/studies/manufactured.hpp>
#include <tests/studies/observed_order.hpp>

namespace rigor::studies {
namespace {

using V = Vec3<double>;
using C = std::complex<double>;

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
// cases F-08, D-11: of the order stated for a load, the load taken at the stages.
TEST(Manufactured, IsRecoveredToTheOrderOfTheMethod) {
  const Problem p = manufactured();
  std::vector<Method> all = methods();
  all.insert(all.end(), flow_methods().begin(), flow_methods().end());
  for (const Method& m : all) {
    if (m.name == "euler-naive") continue;  // its R leaves the rotations
    const Observed seen = observed_order(m, p, m.forced_order);
    EXPECT_GE(seen.used, 4) << m.name;
    EXPECT_NEAR(seen.order, m.forced_order, order_slack(m.forced_order)) << m.name;
  }
}

// case F-03: a spring on the centre and one about a principal axis: cosines. Order 1 where the load is
// held; that of the method where it is taken at the stages.
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
  for (const char* m : {"sheet", "euler-exponential", "euler-momentum", "euler-momentum-cross", "explicit-euler"}) EXPECT_NEAR(order(p, m, 4000), 1, 0.05) << m;
  for (const char* m : {"rk4", "rkmk4", "dormand-prince", "split2", "split2-yoshida4", "split2-kahan-li6", "implicit-midpoint"}) {
    const int stated = find_method(m)->forced_order;
    EXPECT_NEAR(observed_order(*find_method(m), p, stated).order, stated, order_slack(stated)) << m;
  }
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
