#include <gtest/gtest.h>

#include <cmath>
#include <rigor/base/interrupt.hpp>
#include <rigor/engine/located.hpp>
#include <rigor/formulas/kinetic_energy.hpp>
#include <rigor/formulas/world_inertia.hpp>
#include <rigor/linalg/rotation.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;

// A floor, y = 0, with Coulomb's friction.
Scene floor_of(double e, double mu) {
  Scene s;
  s.method = "located";
  s.surface = *Surface<double>::make(e, mu, mu);
  s.friction_law = FrictionLaw::coulomb;
  s.planes.push_back(*Plane<double>::make(V(0, 0, 0), V(0, 1, 0)));
  return s;
}

const Observer nothing = [](double, const std::vector<State<double>>&) {};

// A cuboid that begins inside a ceiling falls in the stepper for a while, on its parabola, with a floor far below: no step gains or
// loses anything.
TEST(LocatedLedger, TheStepperLosesNothingByItself) {
  Scene s;
  s.method = "located";
  s.planes.push_back(*Plane<double>::make(V(0, 5, 0), V(0, -1, 0)));
  s.planes.push_back(*Plane<double>::make(V(0, -100, 0), V(0, 1, 0)));
  State<double> start;
  start.p_WB = V(0.3, 4.9, -0.2), start.v_WB = V(1, 0, 0);
  s.bodies = {{*Cuboid<double>::make(2, {0.5, 0.5, 1}), start}};
  s.dt = 1.0 / 64, s.until = 1;
  const auto run = simulate_located(s, nothing);
  ASSERT_TRUE(run);
  ASSERT_EQ(run->handed_over.size(), 1u);
  EXPECT_NEAR(run->handed_over[0].to, 11 * s.dt, 1e-15) << "one in which it was pushed out, and ten";
  EXPECT_EQ(run->handed_over[0].times, 1);
  EXPECT_GE(run->steps, 11);
  const double deep = 0.15 - 9.8 * s.dt * s.dt / 2;
  EXPECT_NEAR(run->ledger.energy.correction, -2 * 9.8 * deep, 1e-13) << "pushed down by 4.9 + 0.5/2 - 5 m less the fall of a step";
  EXPECT_LT(run->ledger.energy.worst_drift, 1e-13);
}

// Tolerances of these scenes: a few roundings of places of 10 m (1e-15 each), of their squares in energies and of moments about the
// origin (1e-14 each).
//
// Thrown free of everything, gravity off at 1/2 s and on again at 5/4 s: three parabolas, of which the middle one is a line; and the
// energy that goes with the switch and comes back with it.
TEST(LocatedLedger, TheSwitchActsAtItsTime) {
  Scene s;
  s.method = "located";
  s.gravity = V(1, -10, 2);
  State<double> start;
  start.p_WB = V(0.5, 3, -2), start.v_WB = V(1, 4, 0.5), start.w_WB = V(2, -3, 1);
  s.bodies = {{*Cuboid<double>::make(2, {0.5, 0.25, 1}), start}};
  s.actions = {{0.5, SceneAction::Do::gravity_off}, {1.25, SceneAction::Do::gravity_on}, {2, SceneAction::Do::gravity_off}};
  s.until = 2, s.every = 0.25;  // what happens at the end still happens
  const V g = s.gravity;
  const auto place = [&](double t) {
    const double fell = std::fmin(t, 0.5), late = std::fmax(t - 1.25, 0);
    return V(start.p_WB + t * start.v_WB + (fell * fell / 2 + fell * (t - fell) + late * late / 2) * g);
  };
  int rows = 0;
  const auto run = simulate_located(s, [&](double t, const std::vector<State<double>>& states) {
    EXPECT_LT(norm<double>(V(states[0].p_WB - place(t))), 1e-14) << t;
    EXPECT_LT(norm<double>(V(states[0].v_WB - start.v_WB - (std::fmin(t, 0.5) + std::fmax(t - 1.25, 0)) * g)), 1e-14) << t;
    ++rows;
  });
  ASSERT_TRUE(run);
  EXPECT_EQ(rows, 9);
  const Ledger& l = run->ledger;
  EXPECT_NEAR(l.energy.switched, 2 * (dot<double>(g, place(0.5)) - dot<double>(g, place(1.25)) + dot<double>(g, place(2))), 1e-13);
  EXPECT_LT(l.energy.worst_drift, 1e-13);
  EXPECT_LT(l.linear.worst_drift, 1e-13);
  EXPECT_LT(l.angular.worst_drift, 1e-13);
  EXPECT_LT(norm<double>(V(l.linear.external - 2 * 1.25 * g)), 1e-13);
}

// One cuboid bounces without a loss, the other slides: without gravity the one comes down in a straight line and the other glides.
TEST(LocatedLedger, TheSwitchActsOnWhatBouncesAndOnWhatSlides) {
  Scene s = floor_of(1, 0.3);
  s.gravity = V(0, -10, 0);
  State<double> bouncing, sliding;
  bouncing.p_WB = V(1, 0.25 + 0.05, -2);
  sliding.p_WB = V(10, 0.125, 3), sliding.v_WB = V(3, 0, 0);
  s.bodies = {{*Cuboid<double>::make(1.5, {0.75, 0.5, 1}), bouncing}, {*Cuboid<double>::make(2, {0.5, 0.25, 1}), sliding}};
  s.actions = {{0.25, SceneAction::Do::gravity_off}, {0.5, SceneAction::Do::gravity_on}};
  s.until = 0.6;
  std::vector<State<double>> end;
  const auto run = simulate_located(s, [&](double, const std::vector<State<double>>& states) { end = states; });
  ASSERT_TRUE(run);
  EXPECT_TRUE(run->handed_over.empty()) << run->handed_over[0].why;
  // down after 0.1 s; up at 1 m/s for 0.15 s to 37.5 mm and -0.5 m/s; down after 75 ms; up at 0.5 m/s for 0.175 s; 0.1 s of weight
  EXPECT_EQ(run->ledger.plane_impacts, 2);
  EXPECT_NEAR(end[0].p_WB[1], 0.25 + 0.5 * 0.175 + 0.5 * 0.1 - 5 * 0.01, 1e-15);
  EXPECT_NEAR(end[0].v_WB[1], 0.5 - 1, 1e-14);
  // 3 m/s² from 3 m/s for 0.25 s; 2.25 m/s for 0.25 s; 3 m/s² for 0.1 s
  EXPECT_NEAR(end[1].p_WB[0], 10 + (0.75 - 1.5 * 0.0625) + 2.25 * 0.25 + (0.225 - 1.5 * 0.01), 1e-14);
  EXPECT_NEAR(end[1].v_WB[0], 1.95, 1e-14);
  EXPECT_NEAR(run->ledger.energy.friction_loss, 3 * 3 - 1.95 * 1.95, 1e-13) << "m v²/2, m = 2";
  EXPECT_NEAR(run->ledger.energy.restitution_loss, 0, 1e-14);
  EXPECT_LT(run->ledger.energy.worst_drift, 1e-13);
  EXPECT_LT(run->ledger.linear.worst_drift, 1e-13);
  EXPECT_LT(run->ledger.angular.worst_drift, 1e-12);
}

// On a slope the work of gravity during a slide is not the friction's, whatever gravity is when it is booked.
TEST(LocatedLedger, TheSwitchBooksASlideWithTheGravityItHad) {
  Scene s = floor_of(0.5, 0.3);
  s.gravity = V(0.5, -10, 0);
  State<double> sliding;
  sliding.p_WB = V(10, 0.125, 3), sliding.v_WB = V(3, 0, 0);
  s.bodies = {{*Cuboid<double>::make(2, {0.5, 0.25, 1}), sliding}};
  s.actions = {{0.25, SceneAction::Do::gravity_off}};
  s.until = 0.5;
  const auto run = simulate_located(s, nothing);
  ASSERT_TRUE(run);
  EXPECT_NEAR(run->ledger.energy.friction_loss, 2 * 3 * (3 * 0.25 - 2.5 / 2 * 0.0625), 1e-13) << "m mu g times the way";
  EXPECT_LT(run->ledger.energy.worst_drift, 1e-13);
}

// To and fro between two walls with a slow spin: what an impact's roundings do to the attitude does not add up over thousands.
TEST(LocatedLedger, AttitudesStayRotationsOverThousandsOfImpacts) {
  Scene s;
  s.method = "located", s.gravity = zero3<double>();
  s.surface = *Surface<double>::make(1, 0, 0);
  for (const double side : {-1.0, 1.0}) s.planes.push_back(*Plane<double>::make(V(0, side, 0), V(0, -side, 0)));
  State<double> start;
  start.R_WB = rotation_of<double>(Vec4<double>(1, 2, -1, 3)), start.v_WB = V(0, 0.045, 0), start.w_WB = V(0.01, -0.005, 0.0075);
  s.bodies = {{*Cuboid<double>::make(2, {0.5, 0.4, 0.3}), start}};
  s.until = s.every = 1e5;
  const auto run = simulate_located(s, nothing);
  ASSERT_TRUE(run);
  EXPECT_GT(run->ledger.impacts, 2000);
  std::printf("orthonormal to %.1e after %ld impacts\n", run->ledger.worst_orthonormality, run->ledger.impacts);
  EXPECT_LT(run->ledger.worst_orthonormality, 1e-15);
}

// A run that is asked to stop ends at the row to come.
TEST(LocatedLedger, OfAnInterruptedRunEndsWhereItStopped) {
  Scene s;
  s.method = "located";
  State<double> start;
  start.p_WB = V(0, 7, 0), start.w_WB = V(2, -3, 1);
  s.bodies = {{*Cuboid<double>::make(2, {0.5, 0.25, 1}), start}};
  s.until = 2, s.every = 0.25;
  std::vector<double> rows;
  const auto run = simulate_located(s, [&](double t, const std::vector<State<double>>&) {
    rows.push_back(t);
    if (rows.size() == 3) detail::interrupt_seen = SIGINT;
  });
  detail::interrupt_seen = 0;
  ASSERT_TRUE(run);
  EXPECT_TRUE(run->interrupted);
  EXPECT_EQ(rows, (std::vector<double>{0, 0.25, 0.5, 0.75}));
  EXPECT_EQ(run->t_end, 0.75);
  EXPECT_NEAR(run->ledger.linear.external[1], -2 * 9.8 * 0.75, 1e-13);
}

// Dropped flat onto a rough floor with a spin about the normal, which no exact phase knows, at 2 m/s to the side: the stepper goes on
// from the moment it lands.
TEST(LocatedLedger, TheStepperGoesOnFromTheMomentOfTheHandOver) {
  Scene s = floor_of(0, 0.3);
  State<double> start;
  start.p_WB = V(0, 1.125, 0), start.v_WB = V(2, 0, 0), start.w_WB = V(0, 3, 0);
  s.bodies = {{*Cuboid<double>::make(2, {0.5, 0.25, 1}), start}};
  s.until = 0.5, s.every = s.dt;
  double before = 0, furthest = 0;
  const auto run = simulate_located(s, [&](double, const std::vector<State<double>>& states) {
    furthest = std::fmax(furthest, states[0].p_WB[0] - before);
    before = states[0].p_WB[0];
  });
  ASSERT_TRUE(run);
  ASSERT_EQ(run->handed_over.size(), 1u);
  EXPECT_NEAR(run->handed_over[0].from, std::sqrt(2 / 9.8), 1e-14);
  EXPECT_EQ(run->handed_over[0].to, 0.5);
  EXPECT_LT(furthest, 2 * s.dt + 1e-12);
}

// Three in the air between a floor and a ceiling they reach neither of, one of them with 0.43 m to spare: a flight each, two planes a
// flight; and as many pairs as there were others in the air when it began.
TEST(LocatedLedger, CountsWhatItLeavesOutOfHowMany) {
  Scene s = floor_of(0.5, 0.3);
  s.planes.push_back(*Plane<double>::make(V(0, 100, 0), V(0, -1, 0)));
  for (int k = 0; k < 3; ++k) {
    State<double> start;
    start.p_WB = V(10 * k, k == 0 ? 1 : 50, 0), start.w_WB = V(1, 2, 3);
    s.bodies.push_back({*Cuboid<double>::make(2, {0.5, 0.25, 1}), start});
  }
  s.until = 0.05;
  for (const bool skip : {true, false}) {
    Skips skips;
    skips.pairs = skips.planes = skip;
    const auto run = simulate_located(s, nothing, {}, skips);
    ASSERT_TRUE(run);
    EXPECT_EQ(run->ledger.skips.planes_of, 3 * 2);
    EXPECT_EQ(run->ledger.skips.planes, skip ? 3 * 2 : 0);
    EXPECT_EQ(run->ledger.skips.pairs_of, 0 + 1 + 2);
  }
}

// A plate dropped flat from 1e-13 of its size bounces to 0.04e-13, which is left out; its energy is lost all the same, m g H in all.
// H is known to the roundings of a place of 5 mm, 1e-18 m.
TEST(LocatedLedger, BooksTheBouncesItLeavesOut) {
  Scene s = floor_of(0.2, 0);
  State<double> start;
  const double H = 1e-13;
  start.p_WB = V(0, 0.005 + H, 0);
  s.bodies = {{*Cuboid<double>::make(2, {0.8, 0.01, 0.6}), start}};
  s.until = 1e-3;
  const auto run = simulate_located(s, nothing);
  ASSERT_TRUE(run);
  EXPECT_EQ(run->ledger.impacts, 1);
  EXPECT_EQ(run->accumulations.size(), 1u);
  EXPECT_NEAR(run->ledger.energy.restitution_loss / (2 * 9.8 * H), 1, 1e-3) << "without them 0.96";
}

// The sheet's friction may give energy to a corner (reference/errata.md): the rises that the ledger counts are those seen from outside,
// in the motions before and after.
TEST(LocatedLedger, CountsTheImpactsThatGaveEnergy) {
  long rises = 0;
  for (int c = 0; c < 150; ++c) {
    Scene s = floor_of(0.9, 1.5);
    s.friction_law = FrictionLaw::sheet;
    const auto box = *Cuboid<double>::make(2, {0.5, 0.25, 1});
    State<double> start;
    start.R_WB = rotation_of<double>(Vec4<double>(1, std::sin(c), std::cos(2 * c), std::sin(3 * c)));
    start.p_WB = V(0.3, 1, -0.2), start.v_WB = V(std::sin(5 * c), -4, std::cos(7 * c)), start.w_WB = 8 * V(std::cos(c), std::sin(2 * c), std::cos(3 * c));
    s.bodies = {{box, start}};
    s.until = 0.3;
    long seen = 0, impacts = 0;
    const auto energy = [&](const State<double>& x) {
      return kinetic_energy<double>(2, world_inertia<double>(x.R_WB, box.inertia()), x.v_WB, x.w_WB);
    };
    const auto run = simulate_located(s, nothing, [&](const LocatedImpact& hit) {
      ++impacts;
      seen += energy(hit.after) > energy(hit.before) * (1 + 1e-12);
    });
    ASSERT_TRUE(run);
    if (run->ledger.impacts != impacts) continue;  // several corners at one moment
    EXPECT_EQ(run->ledger.energy_rises, seen) << c;
    rises += seen;
  }
  EXPECT_GE(rises, 3) << "or nothing is shown";
}

// Eight cubes of 2^-8 J and one of 2^46 J land flat without gravity, e = 1/2, the one first: it loses 3/4 of 2^46 J, whose last bit is
// 2^-7 J, then each of the eight 3/4 of 2^-8 J. Every number is a power of two or three of them, so the account is exact.
TEST(LocatedLedger, ASmallLossIsNotLostBesideAGreatOne) {
  Scene s;
  s.method = "located", s.gravity = zero3<double>(), s.until = 1;
  s.surface = *Surface<double>::make(0.5, 0, 0);
  s.planes.push_back(*Plane<double>::make(V(0, 0, 0), V(0, 1, 0)));
  for (int k = 0; k < 9; ++k) {
    State<double> start;
    start.p_WB = k < 8 ? V(2 * k, 0.5 + 0x1p-5, 0) : V(16, 0.5 + 0x1p13, 0);
    start.v_WB = V(0, k < 8 ? -0x1p-4 : -0x1p23, 0);
    s.bodies.push_back({*Cuboid<double>::make(2, {1, 1, 1}), start});
  }
  const auto run = simulate_located(s, nothing);
  ASSERT_TRUE(run);
  ASSERT_EQ(run->ledger.plane_impacts, 9);
  EXPECT_EQ(run->ledger.energy.start, 0x1p46 + 0x1p-5) << "its last bit is 2^-6 J";
  EXPECT_EQ(run->ledger.energy.worst_drift, 0);
  EXPECT_EQ(run->ledger.linear.worst_drift, 0);
}

// The assignment's scene is handed over in part, and all of its energy and momentum are explained.
TEST(LocatedLedger, ExplainsTheAssignmentsScene) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Scene s = builtin_scene("assignment", seed);
    s.method = "located";
    s.actions = {{5, SceneAction::Do::gravity_off}, {6, SceneAction::Do::gravity_on}};
    s.until = 12, s.every = s.dt;
    std::vector<State<double>> before;
    double jump = 0;
    const auto run = simulate_located(s, [&](double, const std::vector<State<double>>& states) {
      for (std::size_t i = 0; i < before.size(); ++i)
        jump = std::fmax(jump, norm<double>(V(states[i].p_WB - before[i].p_WB)) - s.dt * std::fmax(norm<double>(states[i].v_WB), norm<double>(before[i].v_WB)));
      before = states;
    });
    ASSERT_TRUE(run);
    EXPECT_FALSE(run->handed_over.empty()) << seed;
    EXPECT_LT(jump, 2 * run->ledger.deepest_penetration + 10 * s.dt * s.dt) << "no one moves faster than he moves, but where he is pushed out";
    const Ledger& l = run->ledger;
    // a step and an impact leave a few u of the energies and momenta they exchange
    const double roundings = double(l.impacts + run->steps) * 8 * 0x1p-53;
    for (const double some : {l.energy.worst_drift, l.linear.worst_drift, l.angular.worst_drift, l.worst_orthonormality}) EXPECT_GT(some, 0) << "thousands of roundings";
    EXPECT_LT(l.worst_orthonormality, 1e-15);
    EXPECT_LT(std::fabs(l.energy.worst_drift - std::fabs(l.energy.end - l.energy.start - l.energy.correction - l.energy.switched + l.energy.restitution_loss + l.energy.friction_loss)), 8 * 0x1p-52 * l.energy.start);
    EXPECT_LT(l.energy.worst_drift, roundings * l.energy.start) << seed;
    EXPECT_LT(l.linear.worst_drift, roundings * 300) << seed << ": 25 kg, 10 m/s";
    EXPECT_LT(l.angular.worst_drift, roundings * 3000) << seed << ": at 10 m";
  }
}

}  // namespace
}  // namespace rigor
