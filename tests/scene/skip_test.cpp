#include <gtest/gtest.h>

#include <cmath>
#include <rigor/linalg/rotation.hpp>
#include <rigor/scene/simulate.hpp>

namespace rigor {
namespace {

std::vector<State<double>> end_of(const Scene& s, const Skips& skips, RunSummary& summary) {
  std::vector<State<double>> end;
  summary = simulate(s, [&](double, const std::vector<State<double>>& states) { end = states; }, {}, skips);
  return end;
}
// Everything skipped against everything but one, for each, and against nothing.
void expect_same_bits(const Scene& s, const Skips& other) {
  RunSummary with, without;
  const auto a = end_of(s, {true, true, true, true}, with), b = end_of(s, other, without);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].p_WB, b[i].p_WB) << i;
    EXPECT_EQ(a[i].R_WB, b[i].R_WB) << i;
    EXPECT_EQ(a[i].v_WB, b[i].v_WB) << i;
    EXPECT_EQ(a[i].w_WB, b[i].w_WB) << i;
  }
  EXPECT_EQ(with.ledger.impacts, without.ledger.impacts);
  EXPECT_EQ(with.ledger.energy.end, without.ledger.energy.end);
  EXPECT_EQ(with.ledger.energy.correction, without.ledger.energy.correction);
  EXPECT_EQ(with.ledger.linear.end, without.ledger.linear.end);
  for (const PlanLine& line : plan(other, without.ledger.skips)) {
    EXPECT_TRUE(line.skipped || line.left_out == 0) << line.id;
  }
  EXPECT_EQ(with.ledger.skips.monitors, with.ledger.skips.monitors_of);
}
void expect_same_bits(const Scene& s) {
  const Skips all{true, true, true, true};
  for (const char* id : {"pairs", "planes", "loads", "rest", "monitors", "all"}) {
    SCOPED_TRACE(id);
    expect_same_bits(s, *without(all, {id}));
  }
}

// What is skipped cannot matter: the assignment's scene, and a crowd of sixty that falls on itself so that position
// corrections of a whole size bring bodies together that were apart when the step began.
TEST(Skip, ChangesNoBit) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Scene s = builtin_scene("assignment", seed);
    s.until = 3;
    expect_same_bits(s);
  }
  Scene crowd;
  crowd.planes.push_back(*Plane<double>::make({0, 0, 0}, {0, 1, 0}));
  crowd.surface = *Surface<double>::make(0.5, 0.5, 0.3);
  crowd.until = 1;
  for (int k = 0; k < 60; ++k) {
    State<double> start;
    start.p_WB = Vec3<double>(0.4 * (k % 4), 1 + 0.5 * (k / 16), 0.4 * (k / 4 % 4));  // they begin inside each other
    start.R_WB = rotation_of<double>(Vec4<double>(9, k % 5, -1, 2));
    start.w_WB = Vec3<double>(0.3, 1, -0.2);
    crowd.bodies.push_back({*Cuboid<double>::make(2.5, {0.3, 0.5, 0.9}), start});
  }
  expect_same_bits(crowd);
}

// Sums of forces are made anew when forces, switches or the vacuum change them.
TEST(Skip, ChangesNoBitWhereForcesChange) {
  Scene s = builtin_scene("assignment", 4);
  s.until = 2;
  s.actions = {{0.3, SceneAction::Do::vacuum_on}, {0.7, SceneAction::Do::gravity_off}, {1.1, SceneAction::Do::vacuum_off}, {1.4, SceneAction::Do::gravity_on}};
  expect_same_bits(s);
  SceneForce push;
  push.body = 1, push.force = Vec3<double>(3, 20, -5), push.at = Vec3<double>(0.1, 0, 0.2), push.from = 0.2, push.to = 0.6;
  s.forces = {push};
  expect_same_bits(s);
}

// A row at rest without gravity is set going by one that flies into it, one after another; gravity comes and goes.
TEST(Skip, ChangesNoBitWhereSomeAreAtRest) {
  Scene s;
  s.gravity = zero3<double>();
  s.surface = *Surface<double>::make(0.8, 0.3, 0.2);
  s.planes.push_back(*Plane<double>::make({0, -0.5, 0}, {0, 1, 0}));
  for (int k = 0; k < 30; ++k) {
    State<double> start;
    start.p_WB = Vec3<double>(1.2 * k, 0, 0.01 * k);
    start.R_WB = rotation_of<double>(Vec4<double>(30, k % 5, -1, 2));
    s.bodies.push_back({*Cuboid<double>::make(2.5, {0.3, 0.5, 0.9}), start});
  }
  s.bodies[0].start.v_WB = Vec3<double>(6, 0, 0);
  s.until = 3;
  for (const char* method : {"sheet", "rk4", "euler-momentum"}) {
    s.method = method;
    expect_same_bits(s);
    RunSummary summary;
    end_of(s, {}, summary);
    EXPECT_EQ(summary.ledger.skips.rest_of, 30L * summary.steps);
    EXPECT_GT(summary.ledger.skips.rest, 10L * summary.steps) << method;
    EXPECT_GT(summary.ledger.pair_impacts, 5);
  }
  Scene switched = s;
  switched.method = "sheet", switched.gravity = Vec3<double>(0, -9.8, 0);
  switched.actions = {{0, SceneAction::Do::gravity_off}, {1, SceneAction::Do::gravity_on}, {1.2, SceneAction::Do::gravity_off}};
  expect_same_bits(switched);
}

// Accounts nobody reads are not kept: what only a look at every step can tell is not known, and is not told as a number.
TEST(Skip, KeepsNoAccountOfAStepThatNobodyReads) {
  Scene s = builtin_scene("assignment", 2);
  s.until = 1;
  Skips quiet;
  quiet.monitors = true;
  RunSummary kept, skipped;
  end_of(s, {}, kept), end_of(s, quiet, skipped);
  const Ledger &a = kept.ledger, &b = skipped.ledger;
  EXPECT_LT(a.energy.stepper, 0) << "m g^2 h^2/2 for each step in free fall";
  EXPECT_GT(norm<double>(a.angular.stepper), 0);
  for (const double sum : {b.energy.work, b.energy.stepper, b.energy.worst_stepper, b.energy.worst_drift, b.worst_orthonormality, b.linear.worst_drift, b.angular.worst_stepper,
                           b.linear.external[1], b.angular.external[0], b.angular.stepper[2]})
    EXPECT_TRUE(std::isnan(sum));
  EXPECT_EQ(a.energy.end, b.energy.end);
  EXPECT_EQ(a.angular.end, b.angular.end);
  EXPECT_EQ(a.energy.restitution_loss, b.energy.restitution_loss);
  EXPECT_EQ(a.energy.friction_loss, b.energy.friction_loss);
}

TEST(Skip, NamesWhatItDoesNotKnow) {
  EXPECT_EQ(without({}, {"pairs", "friction"}).fault().text(), "no-skip is \"friction\", must be one of all, pairs, planes, loads, rest, monitors");
}

TEST(Skip, LeavesOutMostOfAScatteredScene) {
  Scene s;
  s.planes.push_back(*Plane<double>::make({0, 0, 0}, {0, 1, 0}));
  for (int k = 0; k < 100; ++k) {
    State<double> start;
    start.p_WB = Vec3<double>(4 * (k % 10), 20, 4 * (k / 10));
    s.bodies.push_back({*Cuboid<double>::make(2.5, {0.7, 1.1, 1.9}), start});
  }
  s.until = 0.5;
  RunSummary summary;
  end_of(s, {}, summary);
  EXPECT_EQ(summary.ledger.skips.pairs, summary.ledger.skips.pairs_of);
  EXPECT_EQ(summary.ledger.skips.planes, summary.ledger.skips.planes_of);
  EXPECT_EQ(summary.ledger.skips.pairs_of, 4950L * summary.steps);
  EXPECT_EQ(summary.ledger.skips.loads_of, 100L * summary.steps);
  EXPECT_EQ(summary.ledger.skips.loads, 100L * (summary.steps - 1)) << "summed once, gravity being all there is";
  EXPECT_EQ(summary.ledger.skips.monitors, 0) << "accounts are kept unless nobody wants them";
}

}  // namespace
}  // namespace rigor
