// The numbers and rules that docs/located-impacts.md states, each from both of its sides where it has two. Unit cubes, no gravity, no
// friction and elastic where nothing else is said; who begins 0.01 inside the floor z = 0 is in the stepper.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <rigor/engine/pair_search.hpp>
#include <rigor/engine/plane_search.hpp>
#include <rigor/linalg/rotation.hpp>
#include <tests/engine/small_scene.hpp>
#include <tuple>

namespace rigor {
namespace {

struct RuleScene : SmallScene {
  explicit RuleScene(double until, double e = 1, double mu_s = 0, double mu_d = 0) : SmallScene(zero3<double>(), e, mu_s, mu_d, until) {}
};
const Vec3<double> rule_cube(1, 1, 1);
const double rule_diagonal = std::sqrt(3.0);

// Two in the stepper, their centres at -x and x, that come at each other at `speed` each.
void add_head_on(RuleScene& scene, double x, double speed, double y = 0) {
  for (const double side : {-1, 1}) scene.add(rule_cube, Vec3<double>(side * x, y, 0.49), Vec3<double>(-side * speed, 0, 0));
}

// "by a quarter of that edge at most": 3 m apart at 64 m/s they meet at 3/64 s, and the step ends when they overlap by 1/4: each is
// pushed 1/8 m, and has gone 32 m/s for what is left of 1/8 s.
TEST(LocatedPairs, AStepEndsAQuarterOfTheThinnestEdgeAfterTheyMeet) {
  RuleScene x(0.125);
  x.scene.dt = 0.125;
  x.floor();
  add_head_on(x, 2, 32);
  const RunSummary summary = x.run();
  EXPECT_NEAR(summary.ledger.deepest_penetration, 0.125, 1e-12);
  const double rest = 0.125 - (3.0 / 64 + 0.25 / 64);
  for (const double side : {-1, 1}) EXPECT_NEAR(x.end[side > 0].p_WB[0], side * (0.5 + 32 * rest), 1e-12);
}

// "more than half the thinnest edge": 3.6 m/s for 1/8 s is 0.45 of it. They overlap at the step's end, by 0.45 - 0.01, and are pushed
// to where they touch.
TEST(LocatedPairs, AStepOfLessThanHalfTheThinnestEdgeIsNotCut) {
  RuleScene x(0.125);
  x.scene.dt = 0.125;
  x.floor();
  add_head_on(x, 0.505, 1.8);
  EXPECT_NEAR(x.run().ledger.deepest_penetration, 0.22, 1e-12);
  for (const double side : {-1, 1}) EXPECT_NEAR(x.end[side > 0].p_WB[0], side * 0.5, 1e-12);
}

// "A step is divided sixteen times at most": head on at 16 m/s, one pair after another, a seventeenth or eighteenth of a step apart.
TEST(LocatedPairs, AStepIsDividedSixteenTimes) {
  const auto pairs = [](RuleScene& x, double from, int count) {
    for (int k = 1; k <= count; ++k) {
      const double meets = from + double(k) / (count + 1);
      add_head_on(x, 0.5 + 8 * meets, 8, 3 * double(x.scene.bodies.size() / 2));
    }
  };
  RuleScene twice(2);  // sixteen in each of two steps
  twice.scene.dt = 1;
  twice.floor();
  pairs(twice, 0, 16);
  pairs(twice, 1, 16);
  RunSummary summary = twice.run();
  EXPECT_TRUE(summary.may_have_missed.empty());
  EXPECT_EQ(summary.ledger.pair_impacts, 32);

  RuleScene once(1);  // the seventeenth is named, at its time
  once.scene.dt = 1;
  once.floor();
  pairs(once, 0, 17);
  summary = once.run();
  ASSERT_EQ(summary.may_have_missed.size(), 1u);
  EXPECT_EQ(summary.may_have_missed[0].A, 32u);
  EXPECT_EQ(summary.may_have_missed[0].times, 1);
  EXPECT_NEAR(summary.may_have_missed[0].from, 17.0 / 18, 1e-12);
}

// "begins inside a plane is who is deeper than ... 1e-9 of the size" (a cube's is its diagonal).
TEST(Located, InsideAPlaneIsABillionthOfTheSize) {
  for (const double deep : {0.9e-9, 1.1e-9}) {
    RuleScene x(0.1);
    x.floor();
    x.add(rule_cube, Vec3<double>(0, 0, 0.5 - deep * rule_diagonal));
    const RunSummary summary = x.run();
    ASSERT_EQ(summary.handed_over.size(), deep > 1e-9 ? 1u : 0u) << deep;
    if (deep > 1e-9) {
      EXPECT_EQ(summary.handed_over[0].why, std::string("begins inside a plane"));
    }
  }
}

// "Corners of a cuboid within 64 roundings of the plane that approach it are one contact": tilted by so much that two corners of the face
// are that far up, it is hit flat and does not turn; a little more, and it is hit on its edge.
TEST(Located, CornersWithinSixtyFourRoundingsAreOneContact) {
  for (const double roundings : {63.5, 64.5}) {
    RuleScene x(0.125, 0.5);
    x.floor();
    State<double>& s = x.add(rule_cube, Vec3<double>(0, 0, 0.5), Vec3<double>(0, 0, -1)).start();
    const auto gaps = [&] { return corner_gaps(x.scene.bodies[0].shape, s, x.scene.planes[0]); };
    const double tilt = roundings * gaps().rounding;  // of an edge of 1 m
    s.R_WB = exp_so3<double>(Vec3<double>(0, tilt, 0));
    s.p_WB[2] += tilt / 2;
    int up = 0;
    for (const double gap : gaps().gap) up += gap < 0.5 && std::fabs(gap / gaps().rounding - roundings) < 0.25;
    ASSERT_EQ(up, 2);
    const RunSummary summary = x.run();
    if (roundings < 64) {
      EXPECT_EQ(summary.ledger.impacts, 1);
      EXPECT_EQ(norm<double>(x.end[0].w_WB), 0);
      EXPECT_EQ(x.end[0].v_WB[2], 0.5);
    } else {
      EXPECT_GT(norm<double>(x.end[0].w_WB), 0.1);
    }
  }
}

// "a hundred times at most": between two walls it just fits, each impact leaves e of the speed across, which counts as none from 16 u of
// its speed on, n = log(16 u)/log e impacts. 0.8435: 199.56, so two hundred are made in a hundred rounds; 0.8445: 200.97, one too many.
TEST(Located, TheImpactsOfOneMomentAreAHundredRounds) {
  for (const auto& [e, impacts] : {std::pair{0.8435, 200}, {0.8445, 201}}) {
    RuleScene x(0.125, e);
    x.plane(Vec3<double>(-0.5, 0, 0), Vec3<double>(1, 0, 0));
    x.plane(Vec3<double>(0.5, 0, 0), Vec3<double>(-1, 0, 0));
    x.add(rule_cube, zero3<double>(), Vec3<double>(-1, 1, 0));
    ASSERT_EQ(std::ceil(std::log(16 * 0x1p-53) / std::log(e)), impacts);
    const RunSummary summary = x.run();
    if (impacts <= 200) {
      EXPECT_EQ(summary.ledger.impacts, impacts);
      EXPECT_TRUE(summary.handed_over.empty());
    } else {
      ASSERT_EQ(summary.handed_over.size(), 1u);
      EXPECT_EQ(summary.handed_over[0].why, std::string("impacts of one moment do not end"));
    }
  }
}

// "as long as the centre of pressure stays inside the face": of a cube at mu = 1 it is at the edge of the face, and so it slides:
// 4 m/s, 8 m/s^2.
TEST(Located, PressureAtTheEdgeOfTheFaceIsInside) {
  RuleScene x(0.25, 0, 1, 1);
  x.scene.gravity = Vec3<double>(0, 0, -8);
  x.floor();
  x.add(rule_cube, Vec3<double>(0, 0, 0.5), Vec3<double>(4, 0, 0));
  EXPECT_TRUE(x.run().handed_over.empty());
  EXPECT_EQ(x.end[0].p_WB[0], 0.75);
  EXPECT_EQ(x.end[0].v_WB[0], 2);
}

// "rests if the slope is within mu_s": a slope of 3 in 4 and mu_s = 3/4, both without a rounding.
TEST(Located, ASlopeOfMuItselfIsRestedOn) {
  RuleScene x(2, 0, 0.75, 0.5);
  x.scene.gravity = Vec3<double>(3, 0, -4);
  x.floor();
  x.add(Vec3<double>(2, 2, 1), Vec3<double>(0, 0, 0.5));
  EXPECT_TRUE(x.run().handed_over.empty());
  EXPECT_EQ(norm<double>(x.end[0].v_WB), 0);
  EXPECT_EQ(x.end[0].p_WB[0], 0);
}

// Edge falls across edge, 1 mm at 1 mm/s, 1.2e-8 rad from parallel: no face separates two that stand on their edges, the cross product
// of the edges does.
TEST(LocatedPairs, EdgesNearlyParallelMeetAtTheirTime) {
  const auto cube = *Cuboid<double>::make(1, rule_cube);
  State<double> below, above;
  below.R_WB = exp_so3<double>(Vec3<double>(0, std::numbers::pi / 4, 0));
  above.R_WB = Mat3<double>(exp_so3<double>(Vec3<double>(0, 0, 1.2e-8)) * below.R_WB);
  above.p_WB = Vec3<double>(0, 0, std::sqrt(2.0) + 1e-3), above.v_WB = Vec3<double>(0, 0, -1e-3);
  const PairContact found = next_pair_contact(cube, Flight(cube, below, zero3<double>()), 0, cube, Flight(cube, above, zero3<double>()), 0, 0, 10);
  EXPECT_EQ(found.kind, PairContact::Kind::touch);
  EXPECT_NEAR(found.time, 1, 1e-11);  // the places' roundings, 16 u of 3 m, at 1e-3 m/s: 5e-12 s
}

// "at an overlap of 1e-10 of the smallest edge": a cube falls on another with a tilt of 0.9e-10 and is hit flat, so that they change
// speeds; with a tilt of 1.1e-10 on its edge.
TEST(LocatedPairs, TheManifoldIsThatOfATenBillionthOfTheEdge) {
  for (const double tilt : {0.9e-10, 1.1e-10}) {
    RuleScene x(1.125);
    x.add(rule_cube, zero3<double>());
    x.add(rule_cube, Vec3<double>(0, 0, 2 + tilt / 2), Vec3<double>(0, 0, -1)).start().R_WB = exp_so3<double>(Vec3<double>(0, tilt, 0));
    x.run();
    if (tilt < 1e-10) {
      EXPECT_LT(norm<double>(x.end[1].w_WB), 1e-9);
      EXPECT_NEAR(x.end[1].v_WB[2], 0, 1e-9);
      EXPECT_NEAR(x.end[0].v_WB[2], -1, 1e-9);
    } else {
      EXPECT_GT(norm<double>(x.end[1].w_WB), 0.1);
    }
  }
}

// "Where it exceeds a thousandth of the smallest edge it cannot be said which corners touch": 1e14 edges away the doubles are 1/64 of an
// edge apart. One comes to another at an edge a second and is handed over with that reason, once.
TEST(LocatedPairs, WhoMeetFarAwayAreHandedOverForTheRoundingOfTheirPlaces) {
  for (const double edge : {1., 0x1p-10, 0x1p10}) {
    RuleScene x(4);
    x.add(edge * rule_cube, Vec3<double>(1e14 * edge, 0, 0));
    x.add(edge * rule_cube, Vec3<double>((1e14 + 2.5) * edge, 0, 0), Vec3<double>(-edge, 0, 0));
    const RunSummary summary = x.run();
    ASSERT_EQ(summary.handed_over.size(), 2u) << edge;
    for (const HandOver& handed : summary.handed_over) {
      EXPECT_EQ(handed.why, std::string("flew so far that its place is rounded by a thousandth of its smallest edge")) << edge;
      EXPECT_EQ(handed.times, 1) << edge;
    }
  }
}

// "less than a millionth of the smallest edge": from 1 m above one that does not yield, at rest on the floor, it bounces with 4/2^m m/s,
// for 2^-m s. After the bounce m = 22, in which √(g s) would carry it by 0.7 of a millionth, they are handed over; after one more where
// one of the two spins so fast that its corners would go as far again. A speed they have in common is none.
TEST(LocatedPairs, ABounceOfLessThanAMillionthOfAnEdgeIsAPersistentContact) {
  for (const double edge : {1., 0x1p-10, 0x1p10})
    for (const auto& [drift, spin_below, spin_above] : {std::tuple{0., 0., 0.}, {10., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}}) {
      RuleScene x(2, 0.5);
      x.scene.gravity = Vec3<double>(0, 0, -8 * edge);
      x.floor();
      const Vec3<double> below(4, 4, 1), up(0, 0, 1), along(drift * edge, 0, 0);
      x.add(edge * rule_cube, Vec3<double>(0, 0, 0.5 * edge), along, spin_below * std::sqrt(8) / norm<double>(below) * up);
      x.add(edge * rule_cube, Vec3<double>(0.125 * edge, 0, 2.5 * edge), along, spin_above * std::sqrt(8) / rule_diagonal * up);
      x.scene.bodies[0].shape = *Cuboid<double>::make(1e15, edge * below);
      const RunSummary summary = x.run();
      ASSERT_EQ(summary.handed_over.size(), 2u) << edge;
      for (const HandOver& handed : summary.handed_over) {
        EXPECT_EQ(handed.why, std::string("a persistent contact of two cuboids")) << edge;
        EXPECT_NEAR(handed.from, 1.5 - (spin_below + spin_above > 0 ? 0x1p-23 : 0x1p-22), 0x1p-24) << "half the last bounce: " << edge << ' ' << drift << ' ' << spin_below;
      }
    }
}

// "with the fall to spare": in a step of four seconds both fall by up to 64 m. One comes from 29 m below at 12.5 m/s, as one falls
// beside the other, and is met at (29 - 1)/12.5 s, 20 m down.
TEST(LocatedPairs, AFallOfManySizesWithinAStepIsWatched) {
  RuleScene x(3.75, 0.5);
  x.scene.gravity = Vec3<double>(0, -8, 0), x.scene.dt = 4;
  x.plane(zero3<double>(), Vec3<double>(1, 0, 0));
  x.add(rule_cube, Vec3<double>(0.499, 0, 0));
  x.add(rule_cube, Vec3<double>(0.6, -29, 0), Vec3<double>(0, 12.5, 0));
  const RunSummary summary = x.run();
  ASSERT_EQ(summary.handed_over.size(), 2u);
  EXPECT_NEAR(summary.handed_over[1].from, 28 / 12.5 + 1 / (4 * 12.5), 1e-9);
}

// A corner straight down, on its sphere (edges 2, 4, 4: radius 3), a metre above the floor at 1 m/s: met when the run ends.
TEST(Located, ACornerThatLandsAtTheEndOfTheRunIsFound) {
  RuleScene x(1);
  x.floor();
  State<double>& s = x.add(Vec3<double>(2, 4, 4), Vec3<double>(0, 0, 4), Vec3<double>(0, 0, -1)).start();
  s.R_WB.row(0) = Vec3<double>(2, 1, -2) / 3, s.R_WB.row(1) = Vec3<double>(-2, 2, -1) / 3, s.R_WB.row(2) = Vec3<double>(1, 2, 2) / 3;
  EXPECT_EQ(x.run().ledger.impacts, 1);
  EXPECT_NEAR(x.end[0].v_WB[2], 1, 1e-12);
}

// B's parabola has its apex over A, which lies on the floor: the spheres around them come within a ten-billionth of the size there
// (v^2 > g d, so it is the nearest they come) and do not meet. Of any size, at any spin, the search ends.
TEST(LocatedPairs, SpheresThatPassWithinATenBillionthDoNotMeet) {
  struct Case {
    double edge, of_B, spin_A, spin_B, g;  // m, of A's, rad/s, rad/s, m/s^2 per edge
  };
  for (const Case& c : {Case{1, 1, 0, 0, 1}, {1e6, 1, 0, 0, 0.01}, {1, 2, 30, 0, 4}, {1, 2, 0, 30, 4}, {1, 1, 30, 0, 1}, {1, 1, 0, 30, 1}, {1e-6, 1, 3, 3, 0.1}, {1e-6, 1, 30, 0, 8}, {1e-6, 1, 0, 30, 8}}) {
    const double reach = rule_diagonal / 2 * c.edge * (1 + c.of_B), d = reach + 1e-10 * c.edge, v = 10 * c.edge, g = c.g * c.edge, apex = 0.8 * reach / v;
    ASSERT_GT(v * v, g * d);
    RuleScene x(2 * apex);
    x.scene.gravity = Vec3<double>(0, 0, -g);
    x.floor();
    x.add(c.edge * rule_cube, Vec3<double>(0, 0, c.edge / 2), zero3<double>(), Vec3<double>(0, 0, c.spin_A));
    x.add(c.of_B * c.edge * rule_cube, Vec3<double>(-v * apex, 0, c.edge / 2 + d - g * apex * apex / 2), Vec3<double>(v, 0, g * apex), Vec3<double>(0, 0, c.spin_B));
    const RunSummary summary = x.run();
    EXPECT_TRUE(summary.handed_over.empty()) << summary.handed_over[0].why << ", edge " << c.edge << ", spins " << c.spin_A << " " << c.spin_B;
    EXPECT_EQ(summary.ledger.impacts, 0);
  }
}

}  // namespace
}  // namespace rigor
