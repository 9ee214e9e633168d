// Cuboids in the stepper, whose steps are seconds long here: what a step would carry past each other is found within it, and the step
// ends a quarter of the thinnest edge later. Times from closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <rigor/linalg/rotation.hpp>
#include <tests/engine/small_scene.hpp>

namespace rigor {
namespace {

constexpr double fall = 9.81;

// One cuboid begins a thousandth inside a wall, along which it moves, and so is in the stepper; the other flies.
struct StepperScene : SmallScene {
  StepperScene(const Vec3<double>& gravity, double dt, double until) : SmallScene(gravity, 0.5, 0, 0, until) { scene.dt = dt; }
  // When the second of them to be handed over is: at the end of the part of the step in which they meet.
  double joined() {
    const RunSummary summary = run();
    if (summary.handed_over.size() < 2) return -1;
    EXPECT_EQ(summary.handed_over[1].why, std::string("met a cuboid in the stepper"));
    return summary.handed_over[1].from;
  }
};
const Vec3<double> unit_cube(1, 1, 1), in_wall(0.499, 0, 0);
const double diagonal = std::sqrt(3.0);
// Turns (1, 1, 1) to z.
const Mat3<double> tip_up = exp_so3<double>(Vec3<double>(std::atan(std::sqrt(2.0)) / std::sqrt(2.0), -std::atan(std::sqrt(2.0)) / std::sqrt(2.0), 0));

// Both fall; one comes from 13 m below at 12.5 m/s and is met at (13 - 1)/12.5 s. A step's end is a quarter of an edge later.
TEST(LocatedPairs, AFallWithinAStepIsWatched) {
  for (const auto& [below, speed] : {std::pair{13., 12.5}, {6., 8.}})
    for (const bool flying_first : {false, true}) {
      StepperScene s(Vec3<double>(0, -fall, 0), 1, 0.99);
      s.plane(zero3<double>(), Vec3<double>(1, 0, 0));
      if (!flying_first) s.add(unit_cube, in_wall, zero3<double>());
      s.add(unit_cube, Vec3<double>(0.6, -below, 0), Vec3<double>(0, speed, 0));
      if (flying_first) s.add(unit_cube, in_wall, zero3<double>());
      EXPECT_NEAR(s.joined(), (below - 1) / speed + 1 / (4 * speed), 1e-9);
      EXPECT_EQ(s.run().ledger.pair_impacts, 1) << "pushed apart at once, whichever is the first";
    }
}

// The second step: the flight began a step before it. From above and from below at 15 m/s, 15.4 m apart when the step begins.
TEST(LocatedPairs, AFlightThatBeganEarlierIsWatchedFromWhereItIs) {
  for (const double side : {1., -1.}) {
    StepperScene s(Vec3<double>(0, -fall, 0), 1, 1.99);
    s.plane(zero3<double>(), Vec3<double>(1, 0, 0));
    s.add(unit_cube, in_wall, zero3<double>());
    s.add(unit_cube, Vec3<double>(0.6, side * 30.4, 0), Vec3<double>(0, -side * 15, 0));
    EXPECT_NEAR(s.joined(), 1 + 14.4 / 15 + 1 / (4 * 15.), 1e-9) << side;
  }
}

// Onto one at rest: it falls 1.5 m. The speed that bounds the rest of the step is the fall's at its end, g h.
TEST(LocatedPairs, AFallOntoOneAtRestIsWatched) {
  StepperScene s(Vec3<double>(0, -fall, 0), 1, 0.99);
  s.plane(zero3<double>(), Vec3<double>(1, 0, 0));
  s.plane(Vec3<double>(0, -3, 0), Vec3<double>(0, 1, 0));
  s.add(unit_cube, in_wall, zero3<double>());
  s.add(unit_cube, Vec3<double>(0.6, -2.5, 0), zero3<double>());
  EXPECT_NEAR(s.joined(), std::sqrt(2 * 1.5 / fall) + 1 / (4 * fall), 1e-9);
}

// A rod passes another with 5 cm of its end; rods meet end to end shortly before a step is over.
TEST(LocatedPairs, RodsThatMeetByTheirEndsAreWatched) {
  StepperScene past(zero3<double>(), 1, 0.99), ends(zero3<double>(), 1, 0.99);
  const Vec3<double> upright(0.2, 0.3, 2.9), along(2.9, 0.3, 0.2);
  past.plane(zero3<double>(), Vec3<double>(0, 1, 0));
  past.add(upright, Vec3<double>(0, 0.149, 0), Vec3<double>(8, 0, 0));
  past.add(upright, Vec3<double>(6, 0.2, 2.85), zero3<double>());
  EXPECT_NEAR(past.joined(), 5.8 / 8 + 0.2 / (4 * 8), 1e-9);
  ends.plane(zero3<double>(), Vec3<double>(0, 1, 0));
  ends.add(along, Vec3<double>(0, 0.149, 0), Vec3<double>(8, 0, 0));
  ends.add(along, Vec3<double>(2.9 + 7.76, 0.2, 0), zero3<double>());
  EXPECT_NEAR(ends.joined(), 0.97 + 0.2 / (4 * 8), 1e-9);
}

// A rod turns by 1.9 mrad a step against a plate of 2 cm, 1 mm above it. Its spin is bounded by its energy, as if all of it were about
// the axis it turns about most easily; the speed of its corners by that, 12 mm/s.
TEST(LocatedPairs, ATurnWithinAStepIsWatched) {
  StepperScene s(zero3<double>(), 1, 1.5);
  const Vec3<double> rod(2.8, 0.5, 0.4);
  const double bound = 8.5e-3, spin = bound * std::sqrt((0.5 * 0.5 + 0.4 * 0.4) / (2.8 * 2.8 + 0.5 * 0.5)), fastest = bound * norm<double>(rod) / 2;
  s.plane(zero3<double>(), Vec3<double>(0, 0, 1));
  s.add(rod, Vec3<double>(0, 0, 0.199), zero3<double>(), Vec3<double>(0, 0, spin));
  s.add(Vec3<double>(1, 0.02, 1), Vec3<double>(1.4, 0.25 + 0.001 + 0.01, 0.6), zero3<double>());
  // the corner (1.4, 0.25) is at 0.251 where 1.4 sin a + 0.25 cos a = 0.251
  const double size = std::hypot(1.4, 0.25), angle = std::asin(0.251 / size) - std::atan2(0.25, 1.4);
  EXPECT_NEAR(s.joined(), angle / spin + 0.02 / (4 * fastest), 1e-7);
}

// Side by side, 0.2 m apart, one passes another within a step: the search that says so is counted by its advances.
TEST(LocatedPairs, WhoPassEachOtherAreLookedAt) {
  StepperScene s(zero3<double>(), 1, 0.99);
  s.plane(Vec3<double>(0, 0, -0.499), Vec3<double>(0, 0, 1));
  s.add(unit_cube, zero3<double>(), Vec3<double>(8, 0, 0));
  s.add(unit_cube, Vec3<double>(4, 1000, 0.3), zero3<double>());
  const long apart = s.run().steps;
  s.start().p_WB[1] = 1.2;
  EXPECT_GT(s.run().steps, apart);
  EXPECT_EQ(s.run().handed_over.size(), 1u);
}

// Corner past corner: the tips of two diagonals overlap by 2e-4 of a diagonal. They have parted when a part would end, yet the step is
// cut for them.
TEST(LocatedPairs, TipsThatPassAreLookedAt) {
  StepperScene s(zero3<double>(), 1, 0.99);
  s.plane(Vec3<double>(0, 0, -diagonal / 2 + 1e-3), Vec3<double>(0, 0, 1));
  s.add(unit_cube, zero3<double>(), Vec3<double>(8, 0, 0));
  s.add(unit_cube, Vec3<double>(4, 1000, 0.9998 * diagonal), zero3<double>());
  for (SceneBody& b : s.scene.bodies) b.start.R_WB = tip_up;
  const long apart = s.run().steps;
  s.start().p_WB[1] = 0;
  EXPECT_GT(s.run().steps, apart);
}

// A tip passes a grain: 4 m on, within the outermost 6e-4 of half its diagonal.
TEST(LocatedPairs, ATipThatPassesAGrainIsWatched) {
  StepperScene s(zero3<double>(), 1, 0.99);
  s.plane(Vec3<double>(0, 0, -diagonal / 2 + 1e-3), Vec3<double>(0, 0, 1));
  s.add(unit_cube, zero3<double>(), Vec3<double>(8, 0, 0));
  s.start().R_WB = tip_up;
  EXPECT_NEAR(apply<double>(tip_up, Vec3<double>(1, 1, 1))[2], diagonal, 1e-14);
  const double grain = 1e-4 * diagonal;
  s.add(Vec3<double>(grain, grain, grain), Vec3<double>(4, 0, 0.4998 * diagonal), zero3<double>());
  EXPECT_NEAR(s.joined(), 0.5, 1e-3 / 8);  // a diagonal times 2.5e-4 √2 before its middle at the most
}

// The floor lifts a tip by 9e-4 of the diagonal at the end of a step, into a grain that hovers 8e-4 above where the tip was.
TEST(LocatedPairs, WhoIsLiftedOutOfItsPathIsLookedAtThere) {
  StepperScene s(zero3<double>(), 1, 1.5);
  s.plane(Vec3<double>(0, 0, (9e-4 - 0.5) * diagonal), Vec3<double>(0, 0, 1));
  s.add(unit_cube, zero3<double>(), Vec3<double>(8, 0, 0));
  s.start().R_WB = tip_up;
  const double grain = 1e-4 * diagonal;
  s.add(Vec3<double>(grain, grain, grain), Vec3<double>(8, 0, (0.5 + 8e-4) * diagonal), zero3<double>());
  EXPECT_EQ(s.joined(), 1);
}

// Two in one another are put side by side, half an edge each and more than a step's box has room for; there the first meets a third, that
// stands 1 mm in the floor: in the same step each of the two gives way by half of the eighth they overlap by.
TEST(LocatedPairs, WhoIsPushedIntoAThirdIsLookedAtThere) {
  StepperScene s(zero3<double>(), 1, 1.5);
  s.plane(zero3<double>(), Vec3<double>(0, 1, 0));
  const double in_another = 0x1p-6, pushed = (1 - in_another) / 2, third = -pushed - 1 + 0.125;
  s.add(unit_cube, Vec3<double>(0, 0.75, 0), zero3<double>());
  s.add(unit_cube, Vec3<double>(in_another, 0.75, 0), zero3<double>());
  s.add(unit_cube, Vec3<double>(third, 0.499, 0), zero3<double>());
  s.run();
  EXPECT_NEAR(s.end[0].p_WB[0], -pushed + 0.0625, 1e-15);
  EXPECT_NEAR(s.end[1].p_WB[0], in_another + pushed, 1e-15);
  EXPECT_NEAR(s.end[2].p_WB[0], third - 0.0625, 1e-15);
}

// It leaves the plane with its first step; ten steps in which it met nothing later it flies. The next time it is ten steps again.
TEST(LocatedPairs, FliesAfterTenStepsThatMetNothing) {
  StepperScene s(zero3<double>(), 0.01, 1);
  s.plane(zero3<double>(), Vec3<double>(0, 1, 0));
  s.add(unit_cube, Vec3<double>(0, 0.49, 0), Vec3<double>(0, 10, 0));
  const RunSummary once = s.run();
  ASSERT_EQ(once.handed_over.size(), 1u);
  EXPECT_NEAR(once.handed_over[0].to, 0.1, 1e-15);

  // 2e14 m away, 7/8 m apart: places are rounded by more than half an edge, and they are handed over whenever they fly
  StepperScene again(zero3<double>(), 1.0 / 64, 1);
  for (const double x : {2e14, 2e14 + 1.875}) again.add(unit_cube, Vec3<double>(x, 0, 0), zero3<double>());
  const RunSummary summary = again.run();
  ASSERT_EQ(summary.handed_over.size(), 2u);
  for (const HandOver& h : summary.handed_over) EXPECT_EQ(h.times, 7) << "after 0, 10, ... 60 of 64 steps";
}

// The run says so when a number leaves the range, at once: before a step, and in one.
TEST(LocatedPairs, ANumberThatLeavesTheRangeEndsTheRun) {
  StepperScene at_once(zero3<double>(), 10, 1);  // an impulse of 1.5e350 kg m/s
  at_once.plane(zero3<double>(), Vec3<double>(0, 1, 0));
  at_once.add(unit_cube, Vec3<double>(0, 0.5, 0), Vec3<double>(0, -1e150, 0));
  at_once.scene.bodies[0].shape = *Cuboid<double>::make(1e200, unit_cube);
  const RunSummary summary = at_once.run();
  ASSERT_EQ(summary.handed_over.size(), 1u);
  EXPECT_EQ(summary.handed_over[0].why, std::string("a number left the range of double"));
  EXPECT_FALSE(summary.finite);
  EXPECT_EQ(summary.t_end, 0);
  StepperScene in_a_step(zero3<double>(), 10, 15);
  in_a_step.scene.every = 1;
  in_a_step.plane(zero3<double>(), Vec3<double>(1, 0, 0));
  in_a_step.add(unit_cube, in_wall, Vec3<double>(0, 1.7e308, 0));
  EXPECT_FALSE(in_a_step.run().finite);
  EXPECT_EQ(in_a_step.run().t_end, 10);
  // whatever two others would meet with in the step to come, at 12 s: that step is not looked at
  in_a_step.scene.until = in_a_step.scene.every = 25;
  in_a_step.add(unit_cube, Vec3<double>(0.499, 0, 1000), zero3<double>());
  in_a_step.add(unit_cube, Vec3<double>(0.499, 97, 1000), Vec3<double>(0, -8, 0));
  EXPECT_EQ(in_a_step.run().t_end, 20);
}

// Two at rest on a floor: one inside the other by more than a billionth of its edge is told, side by side they rest. The 64th of a
// metre apart along the floor keeps other edges from lining up.
TEST(LocatedPairs, RestingOnesThatOverlapAreHandedOver) {
  for (const double edge : {1., 0x1p-10, 0x1p10})
    for (const double apart : {0.5, 1 - 1.1e-9, 1 - 0.9e-9, 1., 1.25}) {
      StepperScene s(Vec3<double>(0, -8 * edge, 0), 1.0 / 64, 1);
      s.plane(zero3<double>(), Vec3<double>(0, 1, 0));
      s.add(edge * unit_cube, Vec3<double>(0, 0.5 * edge, 0), zero3<double>());
      s.add(edge * unit_cube, edge * Vec3<double>(apart, 0.5, 1.0 / 64), zero3<double>());
      const RunSummary summary = s.run();
      if (apart > 1 - 1e-9) {
        EXPECT_TRUE(summary.handed_over.empty()) << apart << ' ' << edge;
      } else {
        ASSERT_EQ(summary.handed_over.size(), 2u) << apart << ' ' << edge;
        EXPECT_EQ(summary.handed_over[0].why, std::string("begins inside another cuboid"));
        EXPECT_EQ(summary.handed_over[0].from, 0);
      }
    }
}

// Far away at X each place is rounded by 16 u X, u = 2^-53, and touching is what the two add up to once more: 64 u X in all. At 3 * 2^44 m
// that is 3/8 of an edge; an overlap of a quarter may be none, and they rest. At 5 * 2^44 m it is 5/8: more than half an edge, and it
// cannot be said what touches what.
TEST(LocatedPairs, RestingOnesWhosePlacesAreRoundedTooFarAreHandedOver) {
  const auto at = [](double far, double overlap) {
    StepperScene s(Vec3<double>(0, -8, 0), 1.0 / 64, 1);
    s.plane(zero3<double>(), Vec3<double>(0, 1, 0));
    s.add(unit_cube, Vec3<double>(far, 0.5, 0), zero3<double>());
    s.add(unit_cube, Vec3<double>(far + 1 - overlap, 0.5, 1.0 / 64), zero3<double>());
    const RunSummary summary = s.run();
    return summary.handed_over.empty() ? "" : summary.handed_over[0].why;
  };
  EXPECT_EQ(at(0x3p44, 0.25), std::string());
  EXPECT_EQ(at(0x3p44, 0.5), std::string("begins inside another cuboid"));
  for (const double overlap : {1., 0.5, 0.25})
    EXPECT_EQ(at(0x5p44, overlap), std::string("flew so far that its place is rounded by a thousandth of its smallest edge"));
}

}  // namespace
}  // namespace rigor
