#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <rigor/studies/drift.hpp>

namespace rigor::studies {
namespace {

// case FB-09: over 2e4 steps, a million with RIGOR_ALL=1, the methods that conserve something conserve it; explicit Euler gains.
TEST(Drift, OfTheConservingMethodsIsRoundingAndOfExplicitEulerOfFirstOrder) {
  const Problem& problem = *find_problem("case-A");
  for (const char* name : {"implicit-midpoint", "moser-veselov", "moser-veselov4", "moser-veselov8"}) {
    const long steps = std::getenv("RIGOR_ALL") != nullptr ? 1000000 : 20000;
    const Drift d = drift_of(problem, *find_method(name), 0.01, steps);
    EXPECT_LT(d.energy, 5e-17 * double(steps)) << name;  // steps of a few u, were they all of one sign
    EXPECT_EQ(d.momentum, 0) << name;
    EXPECT_TRUE(d.finite);
  }
  // explicit Euler gains every step (D-07), so over a time in proportion to h
  const double coarse = drift_of(problem, *find_method("explicit-euler"), 1e-4, 1000).energy, fine = drift_of(problem, *find_method("explicit-euler"), 5e-5, 2000).energy;
  EXPECT_GT(fine, 0);
  EXPECT_NEAR(coarse / fine, 2, 0.01);
}

// case E-06: the jitter of a method that keeps the energy is rounding, and a part of the worst drift for the others.
TEST(Drift, JitterIsTheSpreadOfTheEnergysSteps) {
  const Problem& problem = *find_problem("case-A");
  EXPECT_LT(drift_of(problem, *find_method("moser-veselov"), 0.01, 1000).energy_jitter, 8 * 0x1p-53);
  const Drift split = drift_of(problem, *find_method("split3"), 0.01, 1000);
  EXPECT_GT(split.energy_jitter, 1e-9);
  EXPECT_LT(split.energy_jitter, split.energy);
}

// A drift that leaves the numbers has none: neither the zeros it began with, nor what it grew to before it overflowed.
TEST(Drift, ThatFailsIsARowWithoutNumbers) {
  int failed = 0;
  for (const Method& method : methods())
    for (const auto& [step, steps] : {std::pair{0.01, 200000L}, {1e30, 10L}}) {
      if (step < 1 && method.order > 1) continue;  // these hold
      const Row row = drift({"drift", "case-A", std::string(method.name), steps, 0, 0, step});
      failed += !row.failed.empty();
      for (const auto& [name, value] : row.values) EXPECT_TRUE(row.failed.empty() ? std::fabs(value) <= 0x1p53 : std::isnan(value)) << method.name << " " << step << " " << name << " " << value;
    }
  EXPECT_GE(failed, 3 + 5);  // euler-naive, euler-exponential and euler-quaternion grow without end; with 1e30 s most overflow at once
}

// case S-03: first-order methods lose the energy at small angles; the implicit ones hold to an angle of some radians; a halved
// spin doubles the step but not the angle.
TEST(Stability, IsAnAngleAndOrdersTheMethods) {
  const Problem& problem = *find_problem("case-A");
  const auto angle = [&](const char* name) { return stable_angle(problem, *find_method(name)); };
  EXPECT_LT(angle("explicit-euler"), angle("euler-exponential"));
  EXPECT_LT(angle("sheet"), 0.1);
  EXPECT_GT(angle("rk4"), 0.3);
  EXPECT_GT(angle("implicit-midpoint"), 2);
  Problem slower = problem;
  slower.start.w_WB /= 2;
  EXPECT_EQ(stable_angle(slower, *find_method("split3")), angle("split3"));
}

}  // namespace
}  // namespace rigor::studies
