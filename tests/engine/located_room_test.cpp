// Twenty impacts in the assignment's room, end to end: nothing is restarted, so every error is carried on and grows as the
// motion lets errors grow. The measure is that growth, taken from the witness with its start moved by 1e-25.
#include <gtest/gtest.h>

#include <rigor/engine/located.hpp>

#include "room_witness.hpp"

namespace rigor {
namespace {

using witness::Body;
using witness::P;

// Positions over the room's height, speeds and spins over those at the start, attitudes as they are.
template <class A, class B>
double difference(const Body<A>& a, const Body<B>& b) {
  double worst = 0;
  for (int i = 0; i < 3; ++i) {
    worst = std::fmax(worst, std::fabs(double(P(a.p[i]) - P(b.p[i]))) / 5);
    worst = std::fmax(worst, std::fabs(double(P(a.v[i]) - P(b.v[i]))) / 20);
    worst = std::fmax(worst, std::fabs(double(P(a.w[i]) - P(b.w[i]))) / 4);
    for (int k = 0; k < 3; ++k) worst = std::fmax(worst, std::fabs(double(P(a.R(i, k)) - P(b.R(i, k)))));
  }
  return worst;
}

void compare_end_to_end(double mu) {
  constexpr std::size_t count = 20;
  constexpr double allowed = 1e-13;  // 20 impacts and as many flights of a few u each; seen: 2.5e-15
  const Scene scene = witness::room(0.5, mu);
  std::vector<LocatedImpact> seen;
  const auto done = simulate_located(scene, [](double, const std::vector<State<double>>&) {}, [&](const LocatedImpact& i) { seen.push_back(i); });
  ASSERT_TRUE(done);
  ASSERT_GE(seen.size(), count);
  const auto want = witness::impacts(scene, witness::start_of(scene), count);
  ASSERT_EQ(want.size(), count);
  std::vector<double> growth(count, 1);
  const double moved = 1e-25;
  for (const int axis : {0, 4, 8}) {  // one of position, one of velocity, one of spin
    Body<P> start = witness::start_of(scene);
    (axis < 3 ? start.p : axis < 6 ? start.v : start.w)[axis % 3] += P(moved) * (axis < 3 ? 5 : axis < 6 ? 20 : 4);
    const auto beside = witness::impacts(scene, start, count);
    for (std::size_t k = 0; k < count; ++k) growth[k] = std::fmax(growth[k], difference(want[k].after, beside[k].after) / moved);
  }
  double worst = 0, worst_time = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const State<double>& s = seen[k].after;
    const Body<double> got{s.p_WB, s.v_WB, s.w_WB, s.R_WB};
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
