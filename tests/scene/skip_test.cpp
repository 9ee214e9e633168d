#include <gtest/gtest.h>

#include <rigor/linalg/rotation.hpp>
#include <rigor/scene/simulate.hpp>

namespace rigor {
namespace {

std::vector<State<double>> end_of(const Scene& s, bool skip, RunSummary& summary) {
  std::vector<State<double>> end;
  summary = simulate(s, [&](double, const std::vector<State<double>>& states) { end = states; }, {}, skip);
  return end;
}
void expect_same_bits(const Scene& s) {
  RunSummary with, without;
  const auto a = end_of(s, true, with), b = end_of(s, false, without);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].p_WB, b[i].p_WB) << i;
    EXPECT_EQ(a[i].R_WB, b[i].R_WB) << i;
    EXPECT_EQ(a[i].v_WB, b[i].v_WB) << i;
    EXPECT_EQ(a[i].w_WB, b[i].w_WB) << i;
  }
  EXPECT_EQ(with.ledger.impacts, without.ledger.impacts);
  EXPECT_EQ(with.ledger.energy.end, without.ledger.energy.end);
  EXPECT_EQ(without.ledger.skips.pairs, 0);
  EXPECT_EQ(without.ledger.skips.planes, 0);
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
  end_of(s, true, summary);
  EXPECT_EQ(summary.ledger.skips.pairs, summary.ledger.skips.pairs_of);
  EXPECT_EQ(summary.ledger.skips.planes, summary.ledger.skips.planes_of);
  EXPECT_EQ(summary.ledger.skips.pairs_of, 4950L * summary.steps);
}

}  // namespace
}  // namespace rigor
