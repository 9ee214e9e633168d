// Located impacts against two witnesses that share nothing with them: 60 digits, and CVODE with root finding, each restarted
// at every impact.
#include <gtest/gtest.h>

#include <cmath>
#include <rigor/engine/located.hpp>
#include <rigor/linalg/rotation.hpp>

#include "room.hpp"

namespace rigor {
namespace {

using V = Vec3<double>;

// The largest of: time over the segment, place over the room's half width, speed and spin over their sizes, attitude.
struct Off {
  double time = 0, state = 0;
  template <class T>
  void add(const LocatedImpact& got, const reference::WallImpact<T>& want) {
    const auto at_most = [](double& worst, double value) { worst = std::fmax(worst, value); };
    at_most(time, std::fabs(double(P(got.tau) - P(want.t))) / got.tau);
    const State<double>& s = got.before;
    for (int a = 0; a < 3; ++a) {
      at_most(state, std::fabs(double(P(s.p_WB[a]) - P(want.before.p_WB[a]))) / 2);
      at_most(state, std::fabs(double(P(s.v_WB[a]) - P(want.before.v_WB[a]))) / norm<double>(s.v_WB));
      at_most(state, std::fabs(double(P(s.w_WB[a]) - P(want.before.w_WB[a]))) / norm<double>(s.w_WB));
      for (int b = 0; b < 3; ++b) at_most(state, std::fabs(double(P(s.R_WB(a, b)) - P(want.before.R_WB(a, b)))));
      at_most(state, std::fabs(double(P(got.after.v_WB[a]) - P(want.after.v_WB[a]))) / norm<double>(s.v_WB));
      at_most(state, std::fabs(double(P(got.after.w_WB[a]) - P(want.after.w_WB[a]))) / norm<double>(s.w_WB));
    }
  }
};

void compare_impacts(double mu, double e, int impacts) {
  Scene s;
  s.method = "located";
  s.gravity = V(0, -9.8, 0);
  s.surface = *Surface<double>::make(e, mu, mu);
  s.friction_law = FrictionLaw::coulomb;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      V n = zero3<double>();
      n[axis] = -side;
      s.planes.push_back(*Plane<double>::make(V(-2 * n), n));
    }
  State<double> start;
  start.p_WB = V(0.1, 0.3, -0.2);
  start.R_WB = rotation_of<double>(Vec4<double>(1, 2, -1, 3));
  start.v_WB = V(2, 1, -3);
  start.w_WB = V(2, -3, 1);
  s.bodies = {{*Cuboid<double>::make(2, {0.5, 0.25, 1}), start}};
  s.until = 20;
  std::vector<LocatedImpact> seen;
  const auto done = simulate_located(s, [](double, const std::vector<State<double>>&) {}, [&](const LocatedImpact& i) { seen.push_back(i); });
  ASSERT_TRUE(done);
  ASSERT_GE(int(seen.size()), impacts);
  const reference::Throw thrown_one = thrown_in(s);
  Off precise, cvode;
  for (int k = 0; k < impacts; ++k) {
    const LocatedImpact& i = seen[std::size_t(k)];
    const auto want = reference::precise_impacts(thrown_one, thrown<P>(i.from), s.until, 1);
    const auto other = reference::cvode_impacts(thrown_one, thrown<double>(i.from), s.until, 1);
    ASSERT_EQ(want.size(), 1u) << "impact " << k;
    ASSERT_TRUE(other) << "impact " << k;
    ASSERT_EQ(other->size(), 1u) << "impact " << k;
    precise.add(i, want.front());
    cvode.add(i, other->front());
  }
  std::printf("located, mu %.1f, e %.1f, %d impacts: off the 60 digits in time by %.1e of the segment, state by %.1e; off CVODE by %.1e and %.1e\n", mu, e, impacts, precise.time, precise.state, cvode.time, cvode.state);
  EXPECT_LT(precise.time, 1e-12);  // a flight of ExactFlight and an impact; seen: 6e-14
  EXPECT_LT(precise.state, 1e-12);
  EXPECT_GT(precise.state, 0) << "no difference at all would mean the reference is the engine";
  EXPECT_LT(cvode.time, 1e-11);  // what CVODE is good to
  EXPECT_LT(cvode.state, 1e-11);
  EXPECT_GT(cvode.state, 0);
}

TEST(LocatedOracle, TwentyFrictionlessImpactsOfATumblingCuboid) { compare_impacts(0, 1, 20); }
TEST(LocatedOracle, TwentyImpactsWithFriction) { compare_impacts(0.3, 0.9, 20); }

}  // namespace
}  // namespace rigor
