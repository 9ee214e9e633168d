#include <gtest/gtest.h>

#include <cmath>
#include <rigor/linalg/rotation.hpp>
#include <rigor/scene/trajectory.hpp>
#include <sstream>

namespace rigor {
namespace {

using V = Vec3<double>;

struct Ended {
  RunSummary summary;
  std::vector<State<double>> states;
  std::vector<double> times;
};
Ended run(const Scene& scene) {
  Ended ended;
  ended.summary = simulate(scene, [&](double t, const std::vector<State<double>>& states) {
    ended.times.push_back(t);
    ended.states = states;
  });
  return ended;
}
Scene thrown(double dt, double until) {
  Scene s = builtin_scene("spin-box", 1);
  s.dt = dt;
  s.until = until;
  return s;
}

// cases FB-01, FB-02, D-02: after n steps the position leads the parabola by exactly g t h/2.
// A step far longer than the run is shortened to it: one step, to its end.
TEST(Simulate, EndsAtUntilHoweverLongTheStep) {
  Scene s = builtin_scene("drop", 1);
  s.until = 0.1, s.dt = 1e10, s.every = 0;
  std::vector<double> times;
  EXPECT_EQ(simulate(s, [&](double t, const auto&) { times.push_back(t); }).steps, 1);
  EXPECT_EQ(times, (std::vector<double>{0, 0.1}));
}

TEST(Simulate, LeadsTheParabolaByHalfGTH) {
  const Ended end = run(thrown(0.01, 2));
  const double t = 2, h = 0.01;
  const V g(0, -9.8, 0), parabola = t * V(1, 2, 3) + t * t / 2 * g;
  const V lead = end.states[0].p_WB - parabola;
  EXPECT_NEAR(lead[1], -9.8 * t * h / 2, 200 * 4 * 1e-16 * 20);  // 200 steps, each within a few u of 20 m
  EXPECT_NEAR(lead[0], 0, 1e-13);
}

// case D-13: the last step lands on `until` exactly, whatever dt; D-12: nothing to do is nothing done.
TEST(Simulate, EndsAtUntilExactly) {
  for (const double dt : {0.3, 0.1, 1.0 / 3, 0.7}) EXPECT_EQ(run(thrown(dt, 1)).times.back(), 1.0) << dt;
  EXPECT_EQ(run(thrown(0.1, 1)).summary.steps, 10) << "ten steps of 0.1, and no stub of 1e-16";
  const Ended nothing = run(thrown(0.1, 0));
  EXPECT_EQ(nothing.summary.steps, 0);
  EXPECT_EQ(nothing.states[0].R_WB, identity3<double>());
}

// case ST-07
TEST(Simulate, GivesTheSameBitsTwice) {
  Scene s = builtin_scene("assignment", 3);
  s.until = 5;
  s.actions = {{1, SceneAction::Do::vacuum_on}, {2, SceneAction::Do::vacuum_off}};
  const Ended a = run(s), b = run(s);
  for (std::size_t i = 0; i < a.states.size(); ++i) {
    EXPECT_EQ(a.states[i].p_WB, b.states[i].p_WB);
    EXPECT_EQ(a.states[i].R_WB, b.states[i].R_WB);
  }
}

// case ST-07 across compilers: the trajectory of the assignment's scene, to the bit. The figure is not the program's word
// alone: g++ 12 and clang 14 builds wrote the same file. It changes only when the physics or the draws change.
TEST(Simulate, GivesTheSameBitsWithEveryCompiler) {
  TrajectoryCsv csv;
  simulate(builtin_scene("assignment", 1), [&](double t, const std::vector<State<double>>& states) { csv.add(t, states); });
  std::uint64_t hash = 14695981039346656037u;  // FNV-1a
  for (const char c : csv.text()) hash = (hash ^ std::uint8_t(c)) * 1099511628211u;
  EXPECT_EQ(hash, 4455435163231509838u);
}

// The assignment's scene at several seeds: finite, and nothing ends outside the room.
TEST(Simulate, TheAssignmentsSceneStaysInItsRoom) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Scene s = builtin_scene("assignment", seed);
    s.actions = {{3, SceneAction::Do::vacuum_on}, {6, SceneAction::Do::vacuum_off}, {8, SceneAction::Do::gravity_off}, {10, SceneAction::Do::gravity_on}};
    const Ended end = run(s);
    EXPECT_TRUE(end.summary.finite);
    for (const State<double>& b : end.states)
      for (const Plane<double>& plane : s.planes) EXPECT_GT(plane.gap(b.p_WB), 0) << "seed " << seed;
    EXPECT_LT(end.summary.ledger.worst_orthonormality, 1e-14);
  }
}

// cases E-01, E-02: the accounts close to rounding, by every kind of method; its own error is an account that falls with h.
TEST(Ledger, Closes) {
  double before = 0;
  for (const double dt : {1.0 / 120, 1.0 / 240, 1.0 / 480}) {
    Scene s = builtin_scene("assignment", 2);
    s.dt = dt;
    s.until = 2;
    s.forces = {{0, V(3, 1, -2), V(0.1, 0.2, 0), true, 0.5, 1}};
    const Ledger l = run(s).summary.ledger;
    const double size = norm<double>(l.linear.external);
    EXPECT_LT(l.linear.worst_drift, 1e-12 * size);
    EXPECT_GT(l.energy.restitution_loss, 0);
    EXPECT_GT(l.energy.friction_loss, 0);
    if (before != 0) {
      EXPECT_LT(l.energy.worst_stepper, 0.7 * before);
    }
    before = l.energy.worst_stepper;
  }
  for (const char* method : {"sheet", "rk4", "split2", "euler-momentum", "implicit-midpoint"}) {
    Scene s = builtin_scene("assignment", 3);
    s.method = method;
    s.until = 4;
    s.forces = {{0, V(3, 1, -2), V(0.1, 0.2, 0), true, 0.5, 1}};
    s.actions = {{1, SceneAction::Do::vacuum_on}, {2, SceneAction::Do::gravity_off}, {3, SceneAction::Do::gravity_on}};
    const RunSummary ended = run(s).summary;
    const Ledger& l = ended.ledger;
    // a step of a cuboid and an impact leave a few u of what they exchange: 3000 J, 1000 N s, 10 m
    const double roundings = double(l.impacts + 10 * ended.steps) * 8 * 0x1p-53;
    EXPECT_LT(l.energy.worst_drift, roundings * 3000) << method;
    EXPECT_LT(l.linear.worst_drift, roundings * 1000) << method;
    EXPECT_LT(l.angular.worst_drift, roundings * 10000) << method;
    EXPECT_GT(l.energy.worst_stepper, 1e6 * l.energy.worst_drift) << method << ": the account is not idle";
  }
}

// In free fall the sheet moves with the velocity at the end of the step: p' = p + h v', so kinetic energy grows by
// m (v·g h + g² h²/2), potential energy falls by m (v·g h + g² h²), and m g² h²/2 is lost. Explicit Euler, p' = p + h v, gains as
// much; a method that flies the parabola has nothing of its own.
TEST(Ledger, TellsWhatTheStepsMakeByThemselves) {
  for (const auto& [method, sign] : {std::pair{"sheet", -1.0}, {"explicit-euler", 1.0}, {"rk4", 0.0}}) {
    Scene s = thrown(1.0 / 64, 2);
    s.bodies[0].start.w_WB = zero3<double>();
    s.method = method;
    const Ledger l = run(s).summary.ledger;
    const double mine = sign * 128 * 10 * 9.8 * 9.8 / 64 / 64 / 2;
    EXPECT_NEAR(l.energy.stepper, mine, 128 * 64 * 0x1p-53 * 3000) << method << ": 3000 J, a few roundings a step";
    EXPECT_NEAR(l.energy.worst_stepper, std::fabs(mine), 128 * 64 * 0x1p-53 * 3000) << method;
    EXPECT_LT(l.energy.worst_drift, 128 * 64 * 0x1p-53 * 3000) << method;
  }
}

// case P-04: a cube dropped on its corner, straight below the centre, leaves with e times its speed (flat, one pass over
// four corners would not: case P-11). The impact is handled at the end of its step, so the apex has an error of order h.
TEST(Simulate, BounceIsFirstOrderInTheStep) {
  const double e = 0.5, half_diagonal = std::sqrt(3.0) / 2;
  const auto apex = [&](double dt) {
    Scene s = builtin_scene("drop", 1);
    State<double> start;
    const V up = V(1, 1, 1) / std::sqrt(3.0), side = V(1, -1, 0) / std::sqrt(2.0);
    start.R_WB.row(0) = side.transpose();  // body's (1, 1, 1) points up
    start.R_WB.row(1) = up.transpose();
    start.R_WB.row(2) = cross<double>(side, up).transpose();
    start.p_WB = V(0, half_diagonal + 1, 0);
    s.bodies = {{*Cuboid<double>::make(2, {1, 1, 1}), start}};
    s.dt = dt;
    s.until = 0.9;  // between the first and the second impact
    double best = 0, last = 2;
    bool down = true;
    simulate(s, [&](double, const std::vector<State<double>>& states) {
      const double y = states[0].p_WB[1] - half_diagonal;
      down = down && y <= last;
      if (!down) best = std::fmax(best, y);
      last = y;
    });
    return best;
  };
  double worst = 0;
  for (const double dt : {1.0 / 500, 1.0 / 1000, 1.0 / 2000}) {
    const double off = std::fabs(apex(dt) - e * e);
    EXPECT_LT(off, 8 * dt);  // v_impact (1 + e) is about 6.6 m/s: one step of it and the lead of the parabola
    worst = std::fmax(worst, off);
  }
  EXPECT_GT(worst, 1e-5) << "an exact answer here would mean the test looks at something else";
}

// case FR-04: a flat cuboid sliding on the floor stops after v0^2/(2 mu g), up to order h, in every direction.
TEST(Simulate, SlidingStopsAfterItsDistanceInEveryDirection) {
  const double want = 9 / (2 * 0.3 * 9.8);
  for (int k = 0; k < 16; ++k) {
    Scene s = builtin_scene("slide", 1);
    s.friction_law = FrictionLaw::coulomb;
    s.dt = 1.0 / 2000;
    const double angle = k * 3.14159265358979 / 8;
    s.bodies[0].start.v_WB = 3 * V(std::cos(angle), 0, std::sin(angle));
    const Ended end = run(s);
    const V moved = end.states[0].p_WB - s.bodies[0].start.p_WB;
    EXPECT_NEAR(std::hypot(moved[0], moved[2]), want, 0.05 * want) << "azimuth " << k;
    EXPECT_LT(norm<double>(end.states[0].v_WB), 0.05);
  }
}

// case D-08: without torque the sheet's stepper keeps neither L nor E exactly, the momentum form keeps L to the bit.
TEST(Simulate, MomentumFormKeepsAngularMomentumToTheBit) {
  Scene s = builtin_scene("tumble", 1);
  s.method = "euler-momentum";
  EXPECT_EQ(run(s).summary.ledger.angular.worst_stepper, 0);
  s.method = "sheet";
  EXPECT_GT(run(s).summary.ledger.angular.worst_stepper, 1e-4);
}

// case S-04: a step far too long ends in a typed result, not in NaN without a word.
TEST(Simulate, SaysWhenNumbersStopBeingFinite) {
  Scene s = builtin_scene("spin-box", 1);
  s.method = "explicit-euler";
  s.dt = 5;
  s.until = 5e4;
  const Ended end = run(s);
  EXPECT_FALSE(end.summary.finite);
  EXPECT_LT(end.summary.t_end, s.until);
  EXPECT_LT(end.times.back(), end.summary.t_end) << "no row with numbers that are none";
  for (const State<double>& b : end.states) EXPECT_TRUE(is_finite(b));
}

// A row is its state's, whatever rows are asked for besides.
TEST(TrajectoryCsv, ARowDoesNotDependOnTheRowsBefore) {
  Scene s = builtin_scene("tumble", 1);
  TrajectoryCsv all, last;
  std::size_t header = last.text().size();
  simulate(s, [&](double t, const std::vector<State<double>>& states) {
    all.add(t, states);
    last = {};
    last.add(t, states);
  });
  EXPECT_TRUE(all.text().ends_with(last.text().substr(header)));
}

TEST(TrajectoryCsv, ReadsBackTheSameNumbers) {
  Scene s = builtin_scene("tumble", 1);
  s.every = 0.1;
  TrajectoryCsv csv;
  std::vector<State<double>> seen;
  simulate(s, [&](double t, const std::vector<State<double>>& states) {
    csv.add(t, states);
    seen.push_back(states[0]);
  });
  std::istringstream in(csv.text());
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line, "t,body,px,py,pz,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz");
  for (const State<double>& state : seen) {
    ASSERT_TRUE(std::getline(in, line));
    std::istringstream cells(line);
    std::vector<double> x;
    for (std::string cell; std::getline(cells, cell, ',');) x.push_back(std::stod(cell));
    ASSERT_EQ(x.size(), 15u);
    const Vec4<double> q(x[5], x[6], x[7], x[8]);
    EXPECT_GE(q[0], 0);
    EXPECT_EQ(x[12], state.w_WB[0]);
    EXPECT_LT(angle_between<double>(rotation_of<double>(q), state.R_WB), 1e-14);
  }
  EXPECT_EQ(seen.size(), 101u);
}

}  // namespace
}  // namespace rigor
