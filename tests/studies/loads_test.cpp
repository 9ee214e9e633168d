// Loads with known motions, through the same `integrate` the studies use.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <rigor/engine/flow_methods.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/studies/convergence.hpp>
#include <tests/studies/observed_order.hpp>

namespace rigor::studies {
namespace {

using V = Vec3<double>;

double order(const Problem& p, const char* method, long steps) {
  const auto error = [&](long n) {
    const Errors e = errors_of(p, integrate(p, *find_method(method), n));
    return e.attitude + e.position;
  };
  return std::log2(error(steps) / error(2 * steps));
}

// cases F-08, D-11: of the order stated for a load, the load taken at the stages.
TEST(Manufactured, IsRecoveredToTheOrderOfTheMethod) {
  const Problem& p = *find_problem("f-08");
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
  const Problem& p = *find_problem("f-03");
  for (const char* m : {"sheet", "euler-exponential", "euler-momentum", "euler-momentum-cross", "explicit-euler"}) EXPECT_NEAR(order(p, m, 4000), 1, 0.05) << m;
  for (const char* m : {"rk4", "rkmk4", "dormand-prince", "split2", "split2-yoshida4", "split2-kahan-li6", "implicit-midpoint"}) {
    const int stated = find_method(m)->forced_order;
    EXPECT_NEAR(observed_order(*find_method(m), p, stated).order, stated, order_slack(stated)) << m;
  }
}

// case F-04: quadratic drag on a fall: terminal speed, v = v_e tanh(g t/v_e); linear drag: an exponential.
TEST(Drag, SlowsAsItShould) {
  Problem p = *find_problem("f-04");
  const double c = 0.5, v_e = std::sqrt(2 * 9.8 / c);
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

// What the catalogue says of its loaded problems is judged by what shares nothing with its references: closed forms, invariants,
// and the methods themselves, which see the load alone.
V spin_at_end(const Problem& p) { return apply_transposed<double>(p.end.R_WB, p.end.w_WB); }

TEST(Loaded, ReferencesAreWhereTheMethodsGo) {
  for (const char* name : {"f-01", "f-02", "f-03", "f-04", "f-05", "f-06", "f-07", "f-08", "forced"}) {
    const Problem& p = *find_problem(name);
    const Errors e = errors_of(p, integrate(p, *find_method("dormand-prince"), 2000));
    EXPECT_LT(e.attitude, 1e-11) << name;  // steps of 2e-3 s at most: h^5 = 3e-14, grown by the flow
    EXPECT_LT(e.momentum, 1e-11) << name;
    EXPECT_LT(e.energy, 1e-11) << name;
    EXPECT_LT(e.position, 1e-11) << name;
  }
}
// case F-02: w1 + i w2 turns by k (w3 t + tau t^2/2 I3), k = (I3 - I1)/I1.
TEST(Loaded, APrismUnderAnAxialTorqueTurnsAsItsClosedFormSays) {
  const Problem& p = *find_problem("f-02");
  const V I = p.body.inertia(), w = spin_at_end(p);
  const double t = p.until, phase = (I[2] - I[0]) / I[0] * (1.1 * t + 0.7 * t * t / (2 * I[2]));
  EXPECT_NEAR(w[0], 0.4 * std::cos(phase) + 0.3 * std::sin(phase), 1e-14);
  EXPECT_NEAR(w[1], 0.4 * std::sin(phase) - 0.3 * std::cos(phase), 1e-14);
  EXPECT_NEAR(w[2], 1.1 + 0.7 * t / I[2], 1e-14);
}
// case F-05: R = Rz(W t) R0 Rz(psi t), psi = w3 - W cos th.
TEST(Loaded, LagrangesTopPrecessesSteadily) {
  const Problem& p = *find_problem("f-05");
  const double W = 0.35020353984998315346, tilt = 0.6;
  const Mat3<double> R = exp_so3<double>(V(0, 0, W * p.until)) * exp_so3<double>(V(tilt, 0, 0)) * exp_so3<double>(V(0, 0, (12 - W * std::cos(tilt)) * p.until));
  EXPECT_LT(angle_between<double>(p.end.R_WB, R), 5e-14);  // an angle of 48 rad, and roundings of the start
}
// cases F-05 to F-07: energy, L.g and the third invariant of each, at the end as at the start, to roundings of numbers of size ten.
TEST(Loaded, TopsKeepTheirInvariants) {
  const auto values = [](const Problem& p, const State<double>& s) {
    const V I = p.body.inertia(), w = apply_transposed<double>(s.R_WB, s.w_WB), g = s.R_WB.row(2), L = I.cwiseProduct(w), P = p.name == "f-05" ? V(0, 0, 2) : V(1.5, 0, 0);
    const std::complex<double> wc(w[0], w[1]), gc(g[0], g[1]);
    const double third = p.name == "f-05" ? w[2] : p.name == "f-06" ? std::norm(wc * wc - P[0] / I[2] * gc) : w[2] * (w[0] * w[0] + w[1] * w[1]) - P[0] / I[2] * w[0] * g[2];
    return V(w.dot(L) / 2 + P.dot(g), L.dot(g), third);
  };
  for (const char* name : {"f-05", "f-06", "f-07"}) {
    const Problem& p = *find_problem(name);
    const V before = values(p, p.start), after = values(p, p.end);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(after[i], before[i], 1e-13 * (1 + std::fabs(before[i]))) << name << ", " << i;
    // a method keeps them as well as it keeps the rest
    const V flown = values(p, integrate(p, *find_method("split2-kahan-li6"), 2000));
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(flown[i], before[i], 1e-10 * (1 + std::fabs(before[i]))) << name << ", " << i;
  }
}
// case FB-07: on the separatrix the spin is hyperbolic: w2 = -W tanh(k (t - t0)), w1 = w3 = U sech, k = 0.6 W, U^2 = 0.68 W^2.
TEST(Loaded, TheSeparatrixIsHyperbolic) {
  const Problem& p = *find_problem("fb-07");
  const double W = std::sqrt(1 + 0.75 * 0.75 / 0.68), k = 0.6 * W, t0 = std::atanh(1 / W) / k;
  const V w = spin_at_end(p);
  EXPECT_NEAR(w[1], -W * std::tanh(k * (p.until - t0)), 1e-15 * 8);
  EXPECT_NEAR(w[0], std::sqrt(0.68) * W / std::cosh(k * (p.until - t0)), 1e-15 * 8);
  EXPECT_NEAR(w[2], w[0], 1e-15 * 8);
}

}  // namespace
}  // namespace rigor::studies
