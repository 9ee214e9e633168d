#include <gtest/gtest.h>

#include <cmath>
#include <rigor/linalg/rotation.hpp>
#include <rigor/studies/convergence.hpp>
#include <set>

namespace rigor::studies {
namespace {

// Numbers of steps at which a method is past its first wiggles and a hundred times above rounding.
std::vector<long> ladder_of(const Method& method) {
  if (method.name == "moser-veselov8") return {48, 64, 80, 100};
  if (method.name == "rkmk4") return {1600, 2400, 3600};  // its terms of order 4 and 5 cancel near 600
  switch (method.order) {
    case 1: return {100, 200, 400, 800};  // on the first second; ten take more than 1e5 steps
    case 2: return {800, 1600, 3200};
    case 4: return {400, 600, 900};
    case 6: return {40, 56, 80, 112};
    case 8: return {28, 34, 40, 48};
    default: return {17, 20, 24, 29};
  }
}

// case D-11: the order a method states is the order it has, on free flight against 60 digits: least squares over the
// ladder, within 5 % (the next term of the error is that large at its coarse end).
TEST(Orders, AreThoseStated) {
  for (const Method& method : methods()) {
    const Problem& problem = *find_problem(method.order == 1 ? "short-A" : "case-A");
    double n = 0, x = 0, y = 0, xx = 0, xy = 0, error = 0;
    for (const long steps : ladder_of(method)) {
      error = errors_of(problem, integrate(problem, method, steps)).attitude;
      const double a = -std::log(double(steps)), b = std::log(error);
      n += 1, x += a, y += b, xx += a * a, xy += a * b;
    }
    const double order = (n * xy - x * y) / (n * xx - x * x);
    std::printf("%-20s order %2d, fitted %.2f, error %.1e rad at %ld steps\n", std::string(method.name).c_str(), method.order, order, error, ladder_of(method).back());
    if (method.order > 8) {
      EXPECT_GT(order, 15) << method.name;  // the next terms still count where the error is above rounding: steeper than 16
    } else {
      EXPECT_NEAR(order, method.order, 0.05 * method.order) << method.name;
    }
  }
}

// case D-09. What a method says it conserves: L to the bit, the energy to rounding over a thousand steps of 0.01 s.
TEST(Orders, WhatIsConservedIsConserved) {
  const Problem& problem = *find_problem("case-A");
  const double energy = motion_of(problem.body, problem.start).L_W.dot(problem.start.w_WB) / 2;
  std::set<std::string_view> kept;
  for (const Method& method : methods()) {
    Motion m = motion_of(problem.body, problem.start);
    const Vec3<double> L = m.L_W;
    double drift = 0, skew = 0;
    for (int k = 0; k < 1000; ++k) {
      m = method.step(problem.body, m, {}, 0.01);
      drift = std::fmax(drift, std::fabs(m.L_W.dot(m.state.w_WB) / 2 / energy - 1));
      skew = std::fmax(skew, orthonormality_defect<double>(m.state.R_WB));
    }
    const bool says_L = method.conserves.find('L') != std::string_view::npos, says_energy = method.conserves.find("energy") != std::string_view::npos;
    EXPECT_EQ(m.L_W == L, says_L) << method.name;
    if (says_energy) {
      EXPECT_LT(drift, 1e-12) << method.name;  // a thousand steps, each solved to a few u
    }
    if (method.name != "euler-naive") {
      EXPECT_LT(skew, 1e-12) << method.name;
    }
    if (says_energy) kept.insert(method.name);
  }
  EXPECT_GE(kept.size(), 4u);
}

// With a torque every one of them is of order min(stated, 2): the load is held over the step.
TEST(Orders, UnderATorqueAreAtMostTwo) {
  const Problem& problem = *find_problem("forced");
  for (const Method& method : methods()) {
    const Ladder ladder = converge(problem, method, method.order == 1 ? 1000 : 100, 4);
    EXPECT_NEAR(ladder.order, std::min(method.order, 2), 0.15) << method.name;
  }
}

// A method is right at any step, forwards and backwards: symmetric ones come back to where they began.
TEST(Orders, SymmetricMethodsAreReversible) {
  const Problem& problem = *find_problem("case-A");
  for (const char* name : {"implicit-midpoint", "split3", "split3-yoshida4", "split2", "split2-yoshida4", "split2-kahan-li6", "split2-kahan-li8", "moser-veselov"}) {
    const Method& method = *find_method(name);
    Motion m = motion_of(problem.body, problem.start);
    for (int k = 0; k < 100; ++k) m = method.step(problem.body, m, {}, 0.02);
    for (int k = 0; k < 100; ++k) m = method.step(problem.body, m, {}, -0.02);
    EXPECT_LT(angle_between<double>(m.state.R_WB, problem.start.R_WB), 1e-12) << name;  // 200 steps of a few u, grown by the flow
  }
}

}  // namespace
}  // namespace rigor::studies
