#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <rigor/engine/located.hpp>
#include <rigor/linalg/rotation.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;

bool whole(const State<double>& s) { return s.p_WB.allFinite() && s.R_WB.allFinite() && s.v_WB.allFinite() && s.w_WB.allFinite(); }
Scene floor_scene(const Cuboid<double>& shape, const State<double>& start, double e, double mu) {
  Scene s;
  s.method = "located";
  s.planes.push_back(*Plane<double>::make(V(0, 0, 0), V(0, 1, 0)));
  s.surface = *Surface<double>::make(e, mu, mu);
  s.friction_law = FrictionLaw::coulomb;
  s.bodies = {{shape, start}};
  s.until = 2;
  s.every = 0.1;
  s.dt = 1.0 / 240;
  return s;
}
// Runs and answers; every state finite, no centre of mass behind a plane.
RunSummary answers(const Scene& s) {
  const auto done = simulate_located(s, [&](double t, const std::vector<State<double>>& states) {
    for (const State<double>& b : states) {
      ASSERT_TRUE(whole(b)) << t;
      for (const Plane<double>& plane : s.planes) ASSERT_GT(plane.gap(b.p_WB), -4 * 9.8 * s.dt * s.dt) << t;  // in the stepper a plate sinks by its fall
    }
  });
  EXPECT_TRUE(done);
  return done ? *done : RunSummary{};
}
State<double> tumbling(double y) {
  State<double> s;
  s.p_WB = V(0, y, 0);
  s.R_WB = rotation_of<double>(Vec4<double>(1, 2, -1, 3));
  s.v_WB = V(1, -2, 0.5);
  s.w_WB = V(2, -3, 1);
  return s;
}

// The list of docs/located-impacts.md: an answer for each, never a hang, never NaN, never through a plane in silence.
TEST(LocatedStress, FastSpins) {
  for (const double spin : {1e2, 1e4, 1e6, 1e8}) {
    State<double> start = tumbling(3);
    start.w_WB *= spin / norm<double>(start.w_WB);
    Scene s = floor_scene(*Cuboid<double>::make(2, {0.5, 0.25, 1}), start, 0.5, 0.3);
    s.until = 0.8;
    answers(s);
  }
}
// A cuboid that spins 17 cm above the plane at 1e8 rad/s: the bound allows advances of some ns, and the search gives up after
// a million of them and says so.
TEST(LocatedStress, ASearchWithoutEndIsHandedOver) {
  State<double> start;
  start.p_WB = V(0, 0.3, 0), start.w_WB = V(0, 1e8, 0);
  Scene s = floor_scene(*Cuboid<double>::make(2, {0.5, 0.25, 1}), start, 0.5, 0.3);
  s.gravity = zero3<double>();
  s.until = 0.01, s.every = 0.01;
  const RunSummary run = answers(s);
  ASSERT_FALSE(run.handed_over.empty());
  EXPECT_EQ(run.handed_over[0].why, "a corner follows the plane within rounding, or a search of a million advances");
  EXPECT_GT(run.steps, 1000000);
}
// A cuboid to and fro in a gap of a nanometre at 1000 m/s: ten million impacts in ten microseconds end the run, with a reason.
TEST(LocatedStress, MillionsOfImpactsInABlinkStopTheRun) {
  if (std::getenv("RIGOR_ALL") == nullptr) GTEST_SKIP() << "ten million impacts, with RIGOR_ALL=1";
  State<double> start;
  start.p_WB = V(0, 1, 0), start.v_WB = V(0, 1000, 0);
  Scene s = floor_scene(*Cuboid<double>::make(2, {1, 2, 1}), start, 1, 0);
  s.gravity = zero3<double>();
  s.planes.push_back(*Plane<double>::make(V(0, 2 + 1e-9, 0), V(0, -1, 0)));
  s.until = 1, s.every = 1;
  const RunSummary run = answers(s);
  EXPECT_EQ(run.stopped, "ten million impacts");
  EXPECT_EQ(run.ledger.impacts, 10000000);
  EXPECT_LT(run.t_end, 2e-5);
}
// Beyond what the stepper can follow the run ends at the first number that is none, and says so.
TEST(LocatedStress, WhatLeavesTheRangeOfDoubleEndsTheRun) {
  State<double> start;
  start.p_WB = V(0, 5, 0), start.w_WB = V(1e12, 0, 1e12);
  Scene s = floor_scene(*Cuboid<double>::make(1, {1, 2, 3}), start, 0, 0);
  const auto run = simulate_located(s, [](double, const auto&) {});
  ASSERT_TRUE(run);
  EXPECT_FALSE(run->finite);
  EXPECT_LT(run->t_end, s.until);
}
// case S-02, BB-15: a thin plate meets the plane, and another, at its time whatever its speed.
TEST(LocatedStress, PlatesAndNeedles) {
  for (const V& size : {V(1, 1e-6, 1), V(1e-3, 1e-3, 2), V(1e-8, 1e-8, 1e-8)}) answers(floor_scene(*Cuboid<double>::make(2, size), tumbling(1.5), 0.5, 0.3));
}
// A plate a micrometre thin at 1e6 m/s, a million of its thicknesses in a microsecond: it hits its twin, which hits the wall.
TEST(LocatedStress, NothingTunnels) {
  const auto plate = *Cuboid<double>::make(2, {1, 1e-6, 1});
  State<double> flying, waiting;
  flying.p_WB = V(0, 20, 0), flying.v_WB = V(0, -1e6, 0);
  waiting.p_WB = V(0, 10, 0);
  Scene s = floor_scene(plate, flying, 1, 0);
  s.gravity = zero3<double>();
  s.bodies.push_back({plate, waiting});
  s.until = 2.5e-5, s.every = 1e-5;
  std::vector<State<double>> end;
  const auto run = simulate_located(s, [&](double, const std::vector<State<double>>& states) { end = states; });
  ASSERT_TRUE(run);
  EXPECT_EQ(run->ledger.pair_impacts, 1);
  EXPECT_EQ(run->ledger.plane_impacts, 1);
  EXPECT_TRUE(run->handed_over.empty());
  EXPECT_NEAR(end[0].v_WB[1], 0, 1e-8) << "exchanged: 1e6 m/s and a few roundings";
  EXPECT_NEAR(end[1].v_WB[1], 1e6, 1e-8);
  EXPECT_NEAR(end[1].p_WB[1], 5, 1e-5) << "20 - 25 m, turned back at the floor, two thicknesses off";
}
TEST(LocatedStress, WhatHasTorqueIsRefused) {
  Scene s = floor_scene(*Cuboid<double>::make(2, {0.5, 0.25, 1}), tumbling(2), 0.5, 0.3);
  s.actions = {{1, SceneAction::Do::vacuum_on}};
  EXPECT_EQ(simulate_located(s, [](double, const auto&) {}).fault().text(), "actions vacuum-on is not known to method 'located'; use a stepper");
  s.actions.clear();
  s.forces.resize(1, {0, V(1, 0, 0)});
  EXPECT_EQ(simulate_located(s, [](double, const auto&) {}).fault().text(), "forces are not known to method 'located' (gravity is); use a stepper");
}
TEST(LocatedStress, StartsInsideAPlaneAreHandedOver) {
  const RunSummary run = answers(floor_scene(*Cuboid<double>::make(2, {0.5, 0.25, 1}), tumbling(0.05), 0.5, 0.3));
  ASSERT_FALSE(run.handed_over.empty());
  EXPECT_EQ(run.handed_over[0].why, "begins inside a plane");
  EXPECT_GT(run.ledger.deepest_penetration, 0);
}
TEST(LocatedStress, CoincidentBodiesAndGreatMassRatios) {
  Scene s = floor_scene(*Cuboid<double>::make(1e-6, {0.5, 0.25, 1}), tumbling(2), 0.5, 0.3);
  s.bodies.push_back({*Cuboid<double>::make(1e6, {0.6, 0.4, 0.7}), tumbling(2)});  // at the same place
  s.bodies.push_back({*Cuboid<double>::make(1, {0.6, 0.4, 0.7}), tumbling(5)});
  const RunSummary run = answers(s);
  ASSERT_FALSE(run.handed_over.empty());
  EXPECT_EQ(run.handed_over[0].why, "begins inside another cuboid");
}
// Face to face, e = 1, masses 1 to 1e12: v' = (m - M)/(m + M) v and V' = 2 m/(m + M) v.
TEST(LocatedStress, AGrainAgainstAMountain) {
  Scene s = floor_scene(*Cuboid<double>::make(1e-6, {0.5, 0.5, 0.5}), {}, 1, 0);
  s.planes.clear();
  s.gravity = zero3<double>();
  s.bodies[0].start.v_WB = V(3, 0, 0);
  State<double> rest;
  rest.p_WB = V(2, 0, 0);
  s.bodies.push_back({*Cuboid<double>::make(1e6, {0.5, 0.5, 0.5}), rest});
  s.until = 1;
  std::vector<State<double>> end;
  const auto run = simulate_located(s, [&](double, const std::vector<State<double>>& states) { end = states; });
  ASSERT_TRUE(run);
  EXPECT_EQ(run->ledger.impacts, 1);
  EXPECT_TRUE(run->handed_over.empty());
  EXPECT_NEAR(end[0].v_WB[0], -3 * (1 - 2e-12), 3 * 8 * 0x1p-53);
  EXPECT_NEAR(end[1].v_WB[0], 6e-12, 6e-12 * 1e-11) << "1/(1 + 1e-12) is left out";
  EXPECT_LT(run->ledger.energy.worst_drift, 16 * 0x1p-53 * run->ledger.energy.start);
}
TEST(LocatedStress, PlanesThatMeetAtAMicroradian) {
  Scene s = floor_scene(*Cuboid<double>::make(2, {0.5, 0.25, 1}), tumbling(2), 1, 0);
  s.planes.push_back(*Plane<double>::make(V(0, 0, 0), V(std::sin(1e-6), std::cos(1e-6), 0)));
  s.until = 10;
  answers(s);
}
// case P-03 without a floor of its own: nothing is lost in 1e5 impacts.
TEST(LocatedStress, AHundredThousandElasticImpactsInAClosedBox) {
  Scene s = floor_scene(*Cuboid<double>::make(2, {0.5, 0.25, 1}), tumbling(1), 1, 0);
  s.planes.clear();
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      V n = zero3<double>();
      n[axis] = -side;
      s.planes.push_back(*Plane<double>::make(V(V(0, 1, 0) - 0.7 * n), n));
    }
  s.bodies[0].start.v_WB = V(30, 20, -10);
  s.until = 2000;
  s.every = 10;
  const RunSummary run = answers(s);
  EXPECT_GT(run.ledger.impacts, 100000);
  EXPECT_TRUE(run.handed_over.empty()) << run.handed_over[0].why;
  EXPECT_LT(run.ledger.energy.worst_drift, double(run.ledger.impacts) * 64 * 0x1p-53 * run.ledger.energy.start);
}

// Random small worlds: everything between a cube and a plate, every e and mu, floor and walls, several bodies.
TEST(LocatedStress, RandomWorldsAlwaysAnswer) {
  std::mt19937_64 random(20260414);
  const auto in = [&](double low, double high) { return low + (high - low) * (double(random() >> 11) * 0x1p-53); };
  const int worlds = std::getenv("RIGOR_ALL") != nullptr ? 100000 : 1500;
  for (int w = 0; w < worlds; ++w) {
    Scene s;
    s.method = "located";
    const double e = in(0, 1.2), mu = in(-0.2, 1);
    s.surface = *Surface<double>::make(e > 1 ? 1 : e, mu < 0 ? 0 : mu, mu < 0 ? 0 : mu);
    s.friction_law = w % 3 == 0 ? FrictionLaw::sheet : FrictionLaw::coulomb;
    s.gravity = V(in(-1, 1), in(-12, 2), in(-1, 1));
    for (int axis = 0; axis < 3; ++axis)
      for (const double side : {-1.0, 1.0}) {
        V n = zero3<double>();
        n[axis] = -side;
        s.planes.push_back(*Plane<double>::make(V(-2 * n), n));
      }
    const int bodies = 1 + int(random() % 3);
    for (int k = 0; k < bodies; ++k) {
      State<double> b;
      b.p_WB = V(in(-1, 1), in(-1, 1), in(-1, 1));
      if (random() % 3 != 0) b.R_WB = rotation_of<double>(Vec4<double>(in(-1, 1), in(-1, 1), in(-1, 1), in(0.1, 1)));
      if (random() % 3 != 0) b.v_WB = V(in(-5, 5), in(-5, 5), in(-5, 5));
      if (random() % 3 != 0) b.w_WB = V(in(-9, 9), in(-9, 9), in(-9, 9));
      const double thin = random() % 4 == 0 ? 1e-3 : 1;
      s.bodies.push_back({*Cuboid<double>::make(in(0.1, 5), {in(0.1, 0.8), in(0.1, 0.8) * thin, in(0.1, 0.8)}), b});
    }
    s.until = 0.7;
    s.every = 0.1;
    s.dt = 1.0 / 480;
    double gone = 0;
    const auto done = simulate_located(s, [&](double, const std::vector<State<double>>& states) {
      for (std::size_t i = 0; i < states.size(); ++i) {
        ASSERT_TRUE(whole(states[i])) << "world " << w;
        for (const Plane<double>& plane : s.planes) gone = std::fmin(gone, plane.gap(states[i].p_WB));
      }
    });
    ASSERT_TRUE(done) << "world " << w;
    // in the stepper a plate thinner than a step's fall can sink in by it: what the summary calls deepest_penetration
    const double sinks = done->handed_over.empty() ? 0 : 2 * done->ledger.deepest_penetration + 4 * 12 * s.dt * s.dt;
    EXPECT_GE(gone, -sinks) << "world " << w;
    if (done->handed_over.empty()) {
      EXPECT_LT(done->ledger.energy.worst_drift, 1e-9 * (1 + std::fabs(done->ledger.energy.start))) << "world " << w;
    }
    EXPECT_TRUE(done->stopped.empty());
  }
}

}  // namespace
}  // namespace rigor
