#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <rigor/base/file.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/report/formula.hpp>
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

// On the separatrix to T = 40 one run falls to one side and the next to the other: numbers, but no order.
TEST(FittedOrder, IsNoneWhereTheRunsLieOnNoLine) {
  const std::vector<double> h{8, 4, 2, 1}, power{6.4e-2, 1.6e-2, 4e-3, 1e-3}, scattered{6.4e-2, 2e-3, 3e-2, 1e-3};
  EXPECT_NEAR(fit_order(h, power).order, 2, 1e-12);
  EXPECT_TRUE(std::isnan(fit_order(h, scattered).order));
  EXPECT_EQ(fit_order(h, scattered).used, 4);
  // by hand, in binary logarithms: y = 5, 3, 2, 0 over x = 3, 2, 1, 0: slope (1.5 x 2.5 + 0.5 x 0.5) x 2 / 5 = 1.6, what is
  // left +-0.1 and +-0.3, standard error sqrt(0.2 / 2 / 5) = 0.14
  EXPECT_NEAR(fit_order(h, {32e-3, 8e-3, 4e-3, 1e-3}).order, 1.6, 1e-12);
  EXPECT_FALSE(std::isnan(fit_order(h, scattered, false).order)) << "errors through impacts scatter about their order";
}

// Errors of a ladder of halvings: rounding is found by its size or by its flatness, and what is finer than it counts with it.
TEST(Places, OfALadderThatComesToRounding) {
  using enum Place;
  const auto of = [](const std::vector<double>& error) {
    std::vector<double> h;
    for (std::size_t k = 0; k < error.size(); ++k) h.push_back(std::ldexp(1, -int(k)));
    return places(h, error);
  };
  EXPECT_EQ(of({0.5, 1e-2, 5e-3, 2.5e-3}), (std::vector<Place>{too_coarse, used, used, used}));
  EXPECT_EQ(of({1e-2, 1e-5, 2e-13, 1e-15}), (std::vector<Place>{used, used, at_floor, at_floor}));           // 300 times 1e-15
  EXPECT_EQ(of({1e-6, 3e-8, 1e-9, 1e-12, 2e-12, 9e-10}), (std::vector<Place>{used, used, used, at_floor, at_floor, at_floor}));  // flat at 1e-12
  EXPECT_EQ(of({1e-16, 2e-16, 5e-15, 1e-12}), (std::vector<Place>(4, at_floor)));                            // rounding that grows with the steps
  EXPECT_EQ(of({0, 0, 0}), (std::vector<Place>(3, at_floor)));
  EXPECT_EQ(of({NAN, 0.2, 1e-3, NAN}), (std::vector<Place>{failed, too_coarse, used, failed}));
  EXPECT_EQ(of({8e-2, 3e-2, 2.8e-2, 7e-3, 1.75e-3, 4.375e-4}), (std::vector<Place>{too_coarse, too_coarse, used, used, used, used}));  // of order 2 from the third on
  EXPECT_EQ(places({8, 4, 2, 1}, {8e-2, 2e-2, 1e-2, 5e-3}, 300, false), (std::vector<Place>(4, used)));      // errors of impacts
  EXPECT_EQ(of({6e-2, 1e-2, 5e-3, 1e-3}), (std::vector<Place>(4, used)));                                    // never settled: all that there is
  EXPECT_EQ(of({1e-3, 9.9e-4, 9.8e-4}), (std::vector<Place>(3, used)));                                      // flat, but not at rounding: no order is seen, and said
}

// A body that falls without spin: nothing of its L is lost, out of nothing; its place is judged as any other's.
TEST(Problems, ABodyWithoutSpinHasErrorsThatAreNumbers) {
  const std::string file = (std::filesystem::temp_directory_path() / ("rigor-falls-" + std::to_string(::getpid()) + ".json")).string();
  ASSERT_TRUE(write_file(file, R"({"until": 1, "cuboids": [{"size": [1, 2, 3], "mass": 2, "position": [0, 5, 1], "velocity": [1, 2, 0]}]})"));
  const auto opened = open_problem(file);
  std::filesystem::remove(file);
  ASSERT_TRUE(opened) << opened.fault().text();
  const Errors e = errors_of(**opened, integrate(**opened, *find_method("rk4"), 10));
  EXPECT_EQ(e.attitude, 0);
  EXPECT_EQ(e.momentum, 0);
  EXPECT_LT(e.energy, 1e-14);
  EXPECT_LT(e.position, 1e-14);
}

TEST(Problems, SayTheirLawsAndHaveAReferenceThatKeepsWhatThePhysicsKeeps) {
  for (const std::string& name : problem_names()) {
    const Problem& p = *find_problem(name);
    EXPECT_LT(orthonormality_defect<double>(p.end.R_WB), 1e-14) << name;
    if (p.falls) {
      EXPECT_LT((motion_of(p.body, p.end).L_W - motion_of(p.body, p.start).L_W).norm(), 1e-14 * motion_of(p.body, p.start).L_W.norm()) << name;
    }
    EXPECT_EQ(errors_of(p, p.end).attitude, 0) << name;
    EXPECT_EQ(laws(p), p.falls ? std::vector<std::string>{"motion.free"} : (std::vector<std::string>{"motion.loaded", "load." + name}));
    for (const std::string& id : laws(p)) EXPECT_NE(report::formula_text(id), "") << id;
  }
  EXPECT_EQ(find_problem("case-D"), nullptr);
  EXPECT_EQ(givens(*find_problem("thrown"))[0].substr(0, 11), "m = 10 kg, ");
  EXPECT_NE(givens(*find_problem("thrown"))[0].find("g = (0, -9.8, 0) m/s²"), std::string::npos);
}

}  // namespace
}  // namespace rigor::studies
