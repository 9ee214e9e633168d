#include <gtest/gtest.h>

#include <cmath>
#include <rigor/engine/located.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;

const Observer nothing = [](double, const std::vector<State<double>>&) {};

// A cuboid that begins inside a ceiling falls in the stepper for a while, on its parabola: no step gains or loses anything.
TEST(LocatedLedger, TheStepperLosesNothingByItself) {
  Scene s;
  s.method = "located";
  s.planes.push_back(*Plane<double>::make(V(0, 5, 0), V(0, -1, 0)));
  State<double> start;
  start.p_WB = V(0.3, 4.9, -0.2), start.v_WB = V(1, 0, 0);
  s.bodies = {{*Cuboid<double>::make(2, {0.5, 0.5, 1}), start}};
  s.dt = 1.0 / 64, s.until = 1;
  const auto run = simulate_located(s, nothing);
  ASSERT_TRUE(run);
  ASSERT_EQ(run->handed_over.size(), 1u);
  EXPECT_NEAR(run->handed_over[0].to, 11 * s.dt, 1e-15) << "one in which it was pushed out, and ten";
  const double deep = 0.15 - 9.8 * s.dt * s.dt / 2;
  EXPECT_NEAR(run->ledger.energy.correction, -2 * 9.8 * deep, 1e-13) << "pushed down by 4.9 + 0.5/2 - 5 m less the fall of a step";
  EXPECT_LT(run->ledger.energy.worst_drift, 1e-13);
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
    s.until = 12;
    const auto run = simulate_located(s, nothing);
    ASSERT_TRUE(run);
    EXPECT_FALSE(run->handed_over.empty()) << seed;
    const Ledger& l = run->ledger;
    // a step and an impact leave a few u of the energies and momenta they exchange
    const double roundings = double(l.impacts + run->steps) * 8 * 0x1p-53;
    EXPECT_LT(l.energy.worst_drift, roundings * l.energy.start) << seed;
    EXPECT_LT(l.linear.worst_drift, roundings * 300) << seed << ": 25 kg, 10 m/s";
    EXPECT_LT(l.angular.worst_drift, roundings * 3000) << seed << ": at 10 m";
  }
}

}  // namespace
}  // namespace rigor
