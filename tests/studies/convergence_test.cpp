#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <rigor/linalg/rotation.hpp>
#include <rigor/studies/convergence.hpp>

namespace rigor::studies {
namespace {

// NASA's worked example of the grid convergence index: h = 1, 2, 4.
TEST(GridConvergence, ReproducesTheWorkedExample) {
  const Gci g = grid_convergence(0.97050, 0.96854, 0.96178, 2);
  EXPECT_NEAR(g.order, 1.78617, 1e-5);
  EXPECT_NEAR(g.extrapolated, 0.97130, 1e-5);
  EXPECT_NEAR(100 * g.fine, 0.10308, 1e-5);
  EXPECT_NEAR(100 * g.coarse, 0.35625, 1e-5);
  EXPECT_NEAR(g.asymptotic, 1.00202, 1e-5);
}

// The plain stepper and its variants against the oracles: order 1.0 +- 0.1 on smooth problems at T = 1 and 2; on the
// flights up to T = 10 first order needs more than 1e5 steps before it is asymptotic.
TEST(Order, OfThePlainStepperIsOne) {
  for (const char* problem : {"short-A", "forced"})
    for (const char* name : {"sheet", "explicit-euler", "euler-exponential", "euler-momentum", "euler-momentum-cross", "euler-momentum-exponential"}) {
      const Ladder l = converge(*find_problem(problem), *find_method(name), 100, 6);
      EXPECT_NEAR(l.order, 1, 0.1) << problem << " " << name;
      EXPECT_GE(l.used, 3);
    }
}

TEST(Order, OfRungeKuttaIsFourWhereTheLoadIsConstant) {
  for (const char* problem : {"short-A", "case-A"}) EXPECT_NEAR(converge(*find_problem(problem), *find_method("rk4"), 25, 6).order, 4, 0.3) << problem;
}

TEST(FittedOrder, LeavesOutRoundingAndWhatIsNotAsymptotic) {
  std::vector<studies::Run> runs;
  for (int k = 0; k < 12; ++k) {
    const double h = std::pow(0.5, k);
    runs.push_back({1L << k, h, {std::fmax(std::pow(h, 4), 1e-14) + (k < 2 ? 1 : 0), 0, 0, 0}});
  }
  int used = 0;
  EXPECT_NEAR(fitted_order(runs, used), 4, 1e-6);
  EXPECT_LT(used, 10);
  EXPECT_TRUE(std::isnan(fitted_order({runs[0], runs[1]}, used)));
}

TEST(Problems, HaveAReferenceThatKeepsWhatThePhysicsKeeps) {
  for (const std::string& name : problem_names()) {
    const Problem& p = *find_problem(name);
    EXPECT_LT(orthonormality_defect<double>(p.end.R_WB), 1e-14) << name;
    if (p.falls) {
      EXPECT_LT((motion_of(p.body, p.end).L_W - motion_of(p.body, p.start).L_W).norm(), 1e-14 * motion_of(p.body, p.start).L_W.norm()) << name;
    }
    EXPECT_EQ(errors_of(p, p.end).attitude, 0) << name;
  }
  EXPECT_EQ(find_problem("case-D"), nullptr);
}

}  // namespace
}  // namespace rigor::studies
