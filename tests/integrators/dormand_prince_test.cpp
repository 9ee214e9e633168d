// The step control of the embedded pair, seen through the times at which it asks for the load.
#include <gtest/gtest.h>

#include <cmath>
#include <rigor/integrators/dormand_prince.hpp>
#include <tests/integrators/laws.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;

/// Σ eᵢ cᵢ⁴ of the published tableau: the estimate of ∫ t⁴ dt over [0, h] is h⁵ times this.
const double estimate_of_t4 =
    std::fabs(-71 / 16695. * std::pow(0.3, 4) + 71 / 1920. * std::pow(0.8, 4) - 17253 / 339200. * std::pow(8 / 9., 4) + 22 / 525. - 1 / 40.);

/// A body at rest at the origin, pushed along x by m A t⁴.
struct Pushed {
  Flown flown;
  std::vector<double> asked;  ///< when the load was asked for: once at the start, six times in each attempt

  /// The length of attempt k: its last stage lies at its end.
  double attempt(std::size_t k) const { return asked[6 * k + 6] - begin(k); }
  double begin(std::size_t k) const {  // the second stage lies at a fifth
    return (5 * asked[6 * k + 1] - asked[6 * k + 6]) / 4;
  }
};
Pushed push(double A, double span, double tolerance) {
  Pushed p;
  const auto flown = fly_dormand_prince(plate, {}, [&](double t, const State<double>&) {
    p.asked.push_back(t);
    return Load{V(plate.mass() * A * std::pow(t, 4), 0, 0), zero3<double>()};
  }, 0, span, tolerance);
  EXPECT_TRUE(flown);
  if (flown) p.flown = *flown;
  return p;
}

// Six decimals of a tolerance would be 0.000000.
TEST(DormandPrince, NamesTheToleranceItRefuses) {
  const auto flown = fly_dormand_prince(plate, {}, [](double, const State<double>&) { return Load{}; }, 0, 1, 1e-15);
  ASSERT_FALSE(flown);
  EXPECT_EQ(flown.fault().text(), "tolerance is 1e-15, must be in [1e-14, 1e-1]: below it the estimate is rounding");
}

// A step is kept exactly when its estimate is within the tolerance times 1 + |v|.
TEST(DormandPrince, KeepsAStepWhenItsEstimateIsWithinTheTolerance) {
  const double h = 0.0199;  // the first guess is longer: one attempt
  for (const double v : {1e-6, 1.0, 10.0})  // reached at the end
    for (const double part : {0.97, 1.03}) {
      const double tolerance = 5 * v * estimate_of_t4 / (1 + v) / part;
      EXPECT_EQ(push(5 * v / std::pow(h, 5), h, tolerance).flown.rejected > 0, part > 1) << v << ", " << part;
    }
}

// |estimate|^(-1/5), nine tenths of it, between a fifth and five times; and the flight goes on to its end after a last step was refused.
TEST(DormandPrince, ChangesTheStepByTheFifthRootOfTheEstimate) {
  const double h = 0.0199, v = 1;
  for (const double part : {2.0, 20.0, 1e6}) {
    const Pushed p = push(5 * v / std::pow(h, 5), h, 5 * v * estimate_of_t4 / (1 + v) / part);
    EXPECT_NEAR(p.attempt(0), h, 1e-15);
    EXPECT_NEAR(p.begin(1), 0, 1e-15);
    EXPECT_NEAR(p.attempt(1) / h, std::fmax(0.2, 0.9 * std::pow(part, -0.2)), 1e-9) << part;
    EXPECT_NEAR(p.flown.end.v_WB[0], v, v * 1e-3) << "at the end of the flight";
  }
  const Pushed calm = push(1e-9, 1, 0.1);  // nothing to estimate: five times as long
  EXPECT_NEAR(calm.attempt(1) / calm.attempt(0), 5, 1e-9);
  Pushed lost;  // a load that is no number from a thousandth of a second on
  const auto no_flight = fly_dormand_prince(plate, {}, [&](double t, const State<double>&) {
    lost.asked.push_back(t);
    return Load{V(t > 1e-3 ? NAN : 1, 0, 0), zero3<double>()};
  }, 0, 1, 1e-6);
  EXPECT_FALSE(no_flight);
  EXPECT_NEAR(lost.attempt(1) / lost.attempt(0), 0.2, 1e-9);
}

// The first guess is a hundredth of 1 + |y| over 1 + |y'|.
TEST(DormandPrince, GuessesItsFirstStepFromTheState) {
  const auto first = [](const State<double>& s, double sense) {
    Pushed p;
    const auto flown = fly_dormand_prince(plate, s, [&](double t, const State<double>&) {
      p.asked.push_back(t);
      return Load{};
    }, 0, sense, 0.1);
    EXPECT_TRUE(flown);
    return p.attempt(0);
  };
  State<double> s;  // y = (0, 0, q, 0), |q| = 1, y' = 0
  EXPECT_NEAR(first(s, 1), 0.02, 1e-15);
  s.v_WB = V(3, 0, 0);
  EXPECT_NEAR(first(s, 1), 0.01 * (1 + std::sqrt(10.0)) / 4, 1e-15);
  EXPECT_NEAR(first(s, -1), -0.01 * (1 + std::sqrt(10.0)) / 4, 1e-15);
}

// Every component counts: of a slow push the place errs most, of a quick twist the spin.
TEST(DormandPrince, HeedsThePlaceAndTheSpin) {
  for (int axis = 0; axis < 3; ++axis) {
    const V along = V::Unit(axis);
    const double slow = 1000, tolerance = 1e-7;
    const auto there = fly_dormand_prince(plate, {}, [&](double t, const State<double>&) { return Load{V(plate.mass() * std::sin(t / slow) / (slow * slow) * along), zero3<double>()}; }, 0, 6 * slow, tolerance);
    ASSERT_TRUE(there);
    EXPECT_NEAR(there->end.p_WB[axis], 6 - std::sin(6.0), 100 * tolerance) << axis;
    const double quick = 1e-6;
    const auto spun = fly_dormand_prince(plate, {}, [&](double t, const State<double>&) { return Load{zero3<double>(), V(plate.inertia()[axis] * std::sin(t / quick) / quick * along)}; }, 0, 6 * quick, tolerance);
    ASSERT_TRUE(spun);
    EXPECT_NEAR(spun->end.w_WB[axis], 1 - std::cos(6.0), 100 * tolerance) << axis;
  }
}

// A picosecond is as long as its steps ask for: ten radians about a principal axis.
TEST(DormandPrince, FliesAPicosecondAsASecond) {
  const LoadAt none = [](double, const State<double>&) { return Load{}; };
  for (const double span : {1e-12, 1.0, 1e12}) {
    State<double> start;
    start.w_WB = V(0, 0, 10 / span);
    const auto flown = fly_dormand_prince(plate, start, none, 0, span, 1e-9);
    ASSERT_TRUE(flown) << flown.fault().text();
    EXPECT_GT(flown->steps, 10);
    EXPECT_LT(angle_between<double>(flown->end.R_WB, rotation_of<double>(Vec4<double>(std::cos(5), 0, 0, std::sin(5)))), 100 * 1e-9) << span;
  }
}

// A place far away is known to its own size only; that leaves the attitude none the worse.
TEST(DormandPrince, KeepsTheAttitudeOfABodyFarAway) {
  const LoadAt none = [](double, const State<double>&) { return Load{}; };
  const double tolerance = 1e-9;
  const State<double> near = tumbling();
  State<double> far = near;
  far.p_WB = V(1e7, -1e7, 1e7);
  const auto want = fly_dormand_prince(plate, near, none, 0, 5, 1e-13), got = fly_dormand_prince(plate, far, none, 0, 5, tolerance);
  ASSERT_TRUE(want && got);
  EXPECT_LT(angle_between<double>(want->end.R_WB, got->end.R_WB), 100 * tolerance);
}

// Late in a flight a step at the rounding of t is longer than one at the rounding of 1: it ends there, too, instead of going on for ever.
TEST(DormandPrince, EndsWhereALoadIsNoNumberHoweverLate) {
  const auto flown = fly_dormand_prince(plate, {}, [](double t, const State<double>&) { return Load{V(t > 1e9 + 0.5 ? NAN : 1, 0, 0), zero3<double>()}; }, 1e9, 1e9 + 1, 1e-8);
  ASSERT_FALSE(flown);
  EXPECT_EQ(flown.fault().where, "step");
}

// Shorter than the first guess: one step, seven loads, and no step of nothing after it.
TEST(DormandPrince, FliesAShortWayInOneStep) {
  const auto flown = fly_dormand_prince(plate, {}, [](double, const State<double>&) { return Load{}; }, 0, 1e-3, 1e-9);
  ASSERT_TRUE(flown);
  EXPECT_EQ(flown->steps, 1);
  EXPECT_EQ(flown->evaluations, 7);
}

// Over a span whose rounding is nothing, too: the step is then halved down to nothing.
TEST(DormandPrince, EndsWhereALoadIsNoNumberHoweverShortTheSpan) {
  const auto flown = fly_dormand_prince(plate, {}, [](double, const State<double>&) { return Load{V(NAN, 0, 0), zero3<double>()}; }, 0, 1e-307, 1e-8);
  ASSERT_FALSE(flown);
  EXPECT_EQ(flown.fault().where, "step");
}

}  // namespace
}  // namespace rigor
