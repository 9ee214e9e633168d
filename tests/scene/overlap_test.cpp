#include <gtest/gtest.h>

#include <rigor/scene/overlap.hpp>
#include <rigor/scene/simulate.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;

SceneBody cube(const V& at) {
  State<double> start;
  start.p_WB = at;
  return {*Cuboid<double>::make(1, {1, 1, 1}), start};
}

TEST(Overlap, CountsWhoBeginsInsideAWallOrAnother) {
  Scene s;
  s.planes.push_back(*Plane<double>::make(V(0, 0, 0), V(0, 1, 0)));
  s.bodies = {cube({0, 5, 0}), cube({0.75, 5, 0}),  // 0.25 m into each other
              cube({0, 0.4, 0}),                    // 0.1 m into the floor
              cube({9, 0.5, 0}), cube({20, 9, 0})};  // on it; in the air
  const Overlap found = overlap_at_start(s);
  EXPECT_EQ(found.cuboids, 3u);
  EXPECT_DOUBLE_EQ(found.depth, 0.25);
}

TEST(Overlap, TouchingUpToRoundingIsNone) {
  Scene s;
  s.planes.push_back(*Plane<double>::make(V(0, 0, 0), V(0, 1, 0)));
  s.bodies = {cube({0, 0.5 - 1e-12, 0}), cube({0, 1.5 - 1e-9, 0})};
  EXPECT_EQ(overlap_at_start(s).cuboids, 0u);
  s.bodies[1] = cube({0, 1.5 - 1e-8, 0});
  EXPECT_EQ(overlap_at_start(s).cuboids, 2u);
  EXPECT_EQ(overlap_at_start(Scene{}).cuboids, 0u);
}

// The first step pushes out what begins inside: by as much. (Seed 3 has nobody inside another.)
TEST(Overlap, IsWhatTheFirstStepPushesOut) {
  Scene s = builtin_scene("assignment", 3);
  s.until = s.dt;
  const double pushed = simulate(s, [](double, const auto&) {}).ledger.deepest_penetration;
  EXPECT_DOUBLE_EQ(overlap_at_start(s).depth, pushed);
  EXPECT_GT(pushed, 1);
}

}  // namespace
}  // namespace rigor
