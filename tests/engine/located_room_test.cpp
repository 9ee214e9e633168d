// Twenty impacts in the assignment's room, end to end: nothing is restarted, so every error is carried on and grows as the
// motion lets errors grow. The measure is that growth, taken from the witness with its start moved by 1e-25.
#include <gtest/gtest.h>

#include <rigor/engine/located.hpp>

#include "room.hpp"

namespace rigor {
namespace {

// Positions over the room's height, speeds and spins over those at the start, attitudes as they are.
template <class A, class B>
double difference(const Thrown<A>& a, const Thrown<B>& b) {
  double worst = 0;
  for (int i = 0; i < 3; ++i) {
    worst = std::fmax(worst, std::fabs(double(P(a.p_WB[i]) - P(b.p_WB[i]))) / 5);
    worst = std::fmax(worst, std::fabs(double(P(a.v_WB[i]) - P(b.v_WB[i]))) / 20);
    worst = std::fmax(worst, std::fabs(double(P(a.w_WB[i]) - P(b.w_WB[i]))) / 4);
    for (int k = 0; k < 3; ++k) worst = std::fmax(worst, std::fabs(double(P(a.R_WB(i, k)) - P(b.R_WB(i, k)))));
  }
  return worst;
}

void compare_end_to_end(double mu) {
  constexpr std::size_t count = 20;
  constexpr double allowed = 1e-13;  // 20 impacts and as many flights of a few u each; seen: 2.5e-15
  const Scene scene = room(0.5, mu);
  const reference::Throw thrown_one = thrown_in(scene);
  const Thrown<P> start = thrown<P>(scene.bodies[0].start);
  std::vector<LocatedImpact> seen;
  const auto done = simulate_located(scene, [](double, const std::vector<State<double>>&) {}, [&](const LocatedImpact& i) { seen.push_back(i); });
  ASSERT_TRUE(done);
  ASSERT_GE(seen.size(), count);
  const auto want = reference::precise_impacts(thrown_one, start, scene.until, count);
  ASSERT_EQ(want.size(), count);
  std::vector<double> growth(count, 1);
  const double moved = 1e-25;
  for (const int axis : {0, 4, 8}) {  // one of position, one of velocity, one of spin
    Thrown<P> beside_it = start;
    (axis < 3 ? beside_it.p_WB : axis < 6 ? beside_it.v_WB : beside_it.w_WB)[axis % 3] += P(moved) * (axis < 3 ? 5 : axis < 6 ? 20 : 4);
    const auto beside = reference::precise_impacts(thrown_one, beside_it, scene.until, count);
    for (std::size_t k = 0; k < count; ++k) growth[k] = std::fmax(growth[k], difference(want[k].after, beside[k].after) / moved);
  }
  double worst = 0, worst_time = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const Thrown<double> got = thrown<double>(seen[k].after);
    const double off = difference(want[k].after, got), late = std::fabs(double(P(seen[k].t) - want[k].t)) / seen[k].t;
    EXPECT_LT(off, allowed * growth[k]) << "impact " << k;
    EXPECT_LT(late, allowed * growth[k]) << "impact " << k;
    worst = std::fmax(worst, off / growth[k]), worst_time = std::fmax(worst_time, late / growth[k]);
  }
  std::printf("located end to end, mu %.1f: growth %.1e after %zu impacts (%.2f s), state off by %.1e of the growth, time by %.1e\n", mu, growth.back(), count, seen[count - 1].t, worst, worst_time);
  EXPECT_GT(worst, 0) << "no difference at all would mean the witness is the engine";
}

TEST(LocatedRoom, TwentyFrictionlessImpactsEndToEnd) { compare_end_to_end(0); }
TEST(LocatedRoom, TwentyImpactsWithFrictionEndToEnd) { compare_end_to_end(0.3); }

}  // namespace
}  // namespace rigor
