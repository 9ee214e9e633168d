// Method "located" at its limits: a zero that is exact, a number that underflows, a contact at the very end of a run, a world of nobody.
// Cubes have an edge and a mass of 1 unless said, so that I = 1/6 and the expectations are short fractions.
#include <gtest/gtest.h>

#include <cmath>
#include <rigor/engine/first_root.hpp>
#include <rigor/engine/flight.hpp>
#include <tests/engine/small_scene.hpp>

namespace rigor {
namespace {

const Vec3<double> weightless(0, 0, 0), edge_one(1, 1, 1);

// s + c δ²/2 = 0 at √(2 s/−c): 4.5e159 s; 2 c s is less than any number.
TEST(FirstRoot, IsLateWhereTheProductUnderflows) { EXPECT_GT(first_root(1e-3, 0, -1e-322), 1e150); }

// √(ω² (1 + 1e-12)) is 1 for a spin of 1 less 5e-13: no mark for "does not turn". I = 1 for a cube of 6 kg.
TEST(Flight, TurnsWhereTheBoundOnItsSpinIsOne) {
  const auto cube = *Cuboid<double>::make(6, edge_one);
  int ones = 0;
  for (int k = -8; k <= 8; ++k) {
    State<double> start;
    start.w_WB = Vec3<double>(0, 0, 1 / std::sqrt(1 + 1e-12) + k * 0x1p-53);
    const Flight flight(cube, start, weightless);
    EXPECT_NEAR(flight.at(1).R_WB(0, 0), std::cos(1), 1e-12);
    ones += flight.spin_bound() == 1;
  }
  EXPECT_GE(ones, 1);
}

TEST(Located, AWorldOfNobodyRunsToItsEnd) {
  SmallScene nobody(weightless, 1, 0, 0, 1);
  const RunSummary summary = nobody.run();
  EXPECT_EQ(summary.t_end, 1);
  EXPECT_EQ(summary.ledger.impacts, 0);
}

// A slide without a deceleration never ends: static friction alone on a level floor, and a slope that dynamic friction just balances
// (3 = 0.75 * 4). A wall is met at its time, a face 1.5 m away at 1 m/s, and so is the floor by one that falls 1 m beside it.
TEST(Located, ASlideAtConstantSpeedMeetsWhatIsInItsWay) {
  SmallScene level(Vec3<double>(0, 0, -8), 0.5, 0.5, 0, 4);
  level.floor().plane(Vec3<double>(2, 0, 0), Vec3<double>(-1, 0, 0)).add(edge_one, Vec3<double>(0, 0, 0.5), Vec3<double>(1, 0, 0));
  EXPECT_EQ(level.run().ledger.impacts, 1);
  EXPECT_EQ(level.end[0].v_WB, Vec3<double>(-0.5, 0, 0));
  EXPECT_EQ(level.end[0].p_WB, Vec3<double>(1.5 - 0.5 * 2.5, 0, 0.5));

  SmallScene slope(Vec3<double>(3, 0, -4), 0.5, 0.75, 0.75, 2);
  slope.scene.friction_law = FrictionLaw::coulomb;
  slope.floor().add(edge_one, Vec3<double>(0, 0, 0.5), Vec3<double>(1, 0, 0)).add(edge_one, Vec3<double>(0, 5, 1.5));
  EXPECT_GT(slope.run().ledger.impacts, 0);
  EXPECT_EQ(slope.end[0].p_WB, Vec3<double>(2, 0, 0.5));
  EXPECT_GT(slope.end[1].p_WB[2], 0.49);
}

// At the last moment of a run, to the bit: there is no flight that follows.
TEST(Located, AnImpactAtTheEndOfARunIsOne) {
  for (const double until : {1., 0.5, 0.25}) {
    SmallScene s(weightless, 1, 0, 0, until);
    s.floor().add(Vec3<double>(2, 2, 2), Vec3<double>(0, 0, 1 + until), Vec3<double>(0, 0, -1));
    EXPECT_EQ(s.run().ledger.impacts, 1) << until;
    EXPECT_EQ(s.end[0].v_WB[2], 1) << until;
  }
}
TEST(LocatedPairs, AMeetingAtTheEndOfARunIsOne) {
  SmallScene s(weightless, 1, 0, 0, 0.25);
  s.add(Vec3<double>(2, 2, 2), zero3<double>()).add(Vec3<double>(2, 2, 2), Vec3<double>(2.25, 0, 0), Vec3<double>(-1, 0, 0));
  EXPECT_EQ(s.run().ledger.pair_impacts, 1);
  EXPECT_EQ(s.end[0].v_WB[0], -1) << "equal masses exchange their velocities";
  EXPECT_EQ(s.end[1].v_WB[0], 0);
}

// In a gravity whose square is 0 all speeds that others are measured by are 0, and so is the height of the least bounce: at rest it rests.
TEST(Located, WhatLiesInAGravityNextToNoneRests) {
  SmallScene s(Vec3<double>(0, 0, -1e-311), 1, 0, 0, 1);
  s.floor().add(edge_one, Vec3<double>(0, 0, 0.5));
  const RunSummary summary = s.run();
  EXPECT_TRUE(summary.handed_over.empty());
  EXPECT_EQ(s.end[0].p_WB, Vec3<double>(0, 0, 0.5));
  EXPECT_EQ(s.end[0].v_WB, zero3<double>());
}

// A plate lands at (1, -1) m/s, e = mu = 0.5: hit as a mass point, j_n = 1.5 and j_t = 0.75, it leaves with (0.25, 0.5) and no spin. The
// bound on the spin it lands with is 1e-12 of the speed: a little more, and the impulse turns it, so that an edge hits again.
TEST(Located, TheBoundOfALandingWithoutSpinIsSharp) {
  const Vec3<double> size(4, 4, 1);
  for (const double part : {0.75e-12, 1.25e-12}) {
    SmallScene s(weightless, 0.5, 0.5, 0.5, 0.125);
    s.floor().add(size, Vec3<double>(0, 0, 0.5), Vec3<double>(1, 0, -1), Vec3<double>(0, part * std::sqrt(2) / norm<double>(size), 0));
    EXPECT_EQ(s.run().ledger.impacts, part < 1e-12 ? 1 : 2);
    EXPECT_EQ(s.end[0].v_WB == Vec3<double>(0.25, 0, 0.5), part < 1e-12) << s.end[0].v_WB.transpose();
    EXPECT_EQ(s.end[0].w_WB == zero3<double>(), part < 1e-12) << s.end[0].w_WB.transpose();
  }
}

// A slide whose direction is that of the pull downhill, 3 of a pressure of 4, is an exact phase: a = 3 - 2, x = t + t²/2. The pull across
// the slide is at most 1e-12 of the pressure: 3 sin of the angle between them.
TEST(Located, TheBoundOfASlideInLineIsSharp) {
  for (const double part : {0.75e-12, 1.25e-12}) {
    SmallScene s(Vec3<double>(3, 0, -4), 0, 0.5, 0.5, 0.125);
    s.scene.friction_law = FrictionLaw::coulomb;
    s.floor().add(Vec3<double>(4, 4, 1), Vec3<double>(0, 0, 0.5), Vec3<double>(1, part * 4 / 3, 0));
    EXPECT_EQ(s.run().handed_over.size(), part < 1e-12 ? 0u : 1u);
    if (part < 1e-12) {
      EXPECT_EQ(s.end[0].p_WB[0], 0.125 + 0.125 * 0.125 / 2);
    }
  }
}

// On the floor with a spin about the lower edge that stays, so that nothing is hit: it lies flat, and rests, up to a spin whose corners go
// at 1e-12 of what gravity makes of a diagonal, √(g d).
TEST(Located, TheBoundOfTheSpinOfWhatLiesFlatIsSharp) {
  for (const double part : {0.75e-12, 1.25e-12}) {
    const double diagonal = std::sqrt(3), spin = part * std::sqrt(8 * diagonal) / diagonal;
    SmallScene s(Vec3<double>(0, 0, -8), 0.5, 0, 0, 0.125);
    s.floor().add(edge_one, Vec3<double>(0, 0, 0.5), Vec3<double>(0, 0, spin / 2), Vec3<double>(0, spin, 0));
    const RunSummary summary = s.run();
    EXPECT_EQ(summary.handed_over.size(), part < 1e-12 ? 0u : 1u);
    if (part < 1e-12) {
      EXPECT_EQ(summary.ledger.impacts, 0);
      EXPECT_EQ(s.end[0].w_WB, zero3<double>());
    }
  }
}

// B stands on A and turns about the edge x = -1/2 that stays: its lower corners have -1/2 - x. A's upper ones, where A turns, the same.
// A hit at x = 1/2 with an approach of 1, 1/m + x²/I = 2.5 for each: j = 2/5; the other edges then approach at 0.4, j = 0.16.
// Velocities -0.4 - 0.16 and -0.5 + 0.4 + 0.16, spins 1.2 - 0.48 and 1 - 1.2 + 0.48. An edge with a rate of exactly 0 is hit by nothing.
TEST(LocatedPairs, AnEdgeThatTouchesAtRestIsNotHit) {
  const Vec3<double> down(0, 0, -0.5), turn(0, 1, 0), along(8, 0, 0);
  const auto hit = [&](const Vec3<double>& v_A, const Vec3<double>& w_A, const Vec3<double>& v_B, const Vec3<double>& w_B, bool mirrored) {
    SmallScene s(weightless, 1, 0, 0, 0.125);
    s.add(edge_one, zero3<double>(), v_A, w_A).add(edge_one, Vec3<double>(0, 0, 1), v_B, w_B);
    const RunSummary summary = s.run();
    EXPECT_TRUE(summary.handed_over.empty());
    EXPECT_EQ(summary.ledger.pair_impacts, 2);
    const State<double>&still = s.end[mirrored ? 1 : 0], &turning = s.end[mirrored ? 0 : 1];
    const double up = mirrored ? -1 : 1;
    EXPECT_NEAR(still.v_WB[2], up * -0.56, 1e-15);
    EXPECT_NEAR(turning.v_WB[2], up * 0.06, 1e-15);
    EXPECT_NEAR(still.w_WB[1], 0.72, 1e-15);
    EXPECT_NEAR(turning.w_WB[1], 0.28, 1e-15);
  };
  hit(zero3<double>(), zero3<double>(), down, turn, false);
  hit(zero3<double>(), zero3<double>(), Vec3<double>(down + along), turn, false);
  hit(Vec3<double>(-down), turn, zero3<double>(), zero3<double>(), true);
}

// One is pushed out of the floor by 1/8 m in the first step and then touches its neighbour: a gap of exactly 0, by a face or by a corner
// (2² + 4² + 4² = 6², where the spheres around them touch too). The neighbour joins it once, and both stay.
TEST(LocatedPairs, ANeighbourThatTouchesJoinsTheStepperOnce) {
  const Vec3<double> slab(2, 4, 4);
  for (const auto& [size, beside] : {std::pair{edge_one, Vec3<double>(1, 0, 0)}, {edge_one, Vec3<double>(0, 0, 1)}, {slab, slab}}) {
    SmallScene s(weightless, 1, 0, 0, 1);
    const Vec3<double> place(0, 0, size[2] / 2);
    s.floor().add(size, Vec3<double>(0, 0, size[2] / 2 - 0.125)).add(size, Vec3<double>(place + beside));
    const RunSummary summary = s.run();
    ASSERT_EQ(summary.handed_over.size(), 2u) << beside.transpose();
    EXPECT_EQ(summary.handed_over[1].why, std::string("met a cuboid in the stepper"));
    EXPECT_EQ(summary.handed_over[1].from, s.scene.dt);
    for (const HandOver& h : summary.handed_over) {
      EXPECT_EQ(h.times, 1);
      EXPECT_EQ(h.to, 1);
    }
    EXPECT_EQ(s.end[0].p_WB, place);
    EXPECT_EQ(s.end[1].p_WB, Vec3<double>(place + beside));
  }
}

// At 1e15 m places are known to 2 m. Two that spin there 2 m apart, more than the spheres around them, are not taken for one that is met:
// eight steps of each.
TEST(LocatedPairs, OutOfReachNothingIsLookedAtHoweverFarAway) {
  SmallScene s(weightless, 1, 0, 0, 1);
  s.scene.dt = 0.125;
  s.floor();
  for (const double x : {1e15, 1e15 + 2}) s.add(edge_one, Vec3<double>(x, 0, 0.49), zero3<double>(), Vec3<double>(0, 0, 10));
  const RunSummary summary = s.run();
  ASSERT_EQ(summary.handed_over.size(), 2u);
  EXPECT_EQ(summary.steps, 16);
}

// One in a wall would fall 8 m onto another in half a second, and the step of 1 s is cut soon after. Without gravity from 1/8 s on it
// does not fall: the step is whole again, and until then it is shown where it was.
TEST(LocatedPairs, TheSwitchMakesACutStepWholeAgain) {
  for (const bool switched : {false, true}) {
    SmallScene s(Vec3<double>(0, 0, -64), 0.5, 0, 0, 0.9);
    s.scene.dt = 1;
    s.floor().plane(zero3<double>(), Vec3<double>(1, 0, 0)).add(edge_one, Vec3<double>(0.499, 0, 9.5)).add(edge_one, Vec3<double>(0.6, 0, 0.5));
    if (switched) s.scene.actions = {{0.125, SceneAction::Do::gravity_off}};
    const RunSummary summary = s.run();
    EXPECT_EQ(summary.handed_over.size(), switched ? 1u : 2u);
    EXPECT_EQ(s.end[0].p_WB[0], switched ? 0.499 : 0.5);
  }
}

// Pairs are looked at in order of index, each in what the ones before have left of the step: 0 meets 3 after 8 m at 12 m/s, and what is
// left ends 1/48 s later; within that 1 falls 1.5 m onto 2, at a speed bounded by the fall in what is left.
TEST(LocatedPairs, AStepIsCutInOrderOfIndex) {
  SmallScene s(Vec3<double>(0, 0, -8), 0.5, 0, 0, 0.9);
  s.scene.dt = 1;
  s.floor().plane(zero3<double>(), Vec3<double>(1, 0, 0));
  s.add(edge_one, Vec3<double>(0.499, 0, 20)).add(edge_one, Vec3<double>(0.499, 20, 3));
  s.add(edge_one, Vec3<double>(0.6, 20, 0.5)).add(edge_one, Vec3<double>(0.499, -9, 20), Vec3<double>(0, 12, 0));
  const RunSummary summary = s.run();
  ASSERT_EQ(summary.handed_over.size(), 4u);
  EXPECT_EQ(summary.handed_over[3].body, 2u);
  const double left = 8.0 / 12 + 1.0 / 48;
  EXPECT_NEAR(summary.handed_over[3].from, std::sqrt(2 * 1.5 / 8) + 1 / (4 * 8 * left), 1e-9);
}

}  // namespace
}  // namespace rigor
