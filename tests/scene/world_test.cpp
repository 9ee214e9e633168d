// The assignment's program between two key presses: impacts as they are told, the hand, switches.
#include <gtest/gtest.h>

#include <cmath>
#include <rigor/scene/simulate.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;

// What bodies gain over a run is what forces and told impacts gave: for each body m (v_end - v_start) = sum of j + m g t.
TEST(World, TellsEveryImpulseThatChangedAVelocity) {
  Scene scene = builtin_scene("assignment", 5);
  scene.until = 4;
  std::vector<V> given(scene.bodies.size(), zero3<double>());
  long told = 0, pairs = 0;
  std::vector<State<double>> end;
  const RunSummary run = simulate(
      scene, [&](double, const auto& states) { end = states; },
      [&](const Impact& impact) {
        ++told, pairs += impact.A >= 0;
        given[std::size_t(impact.B)] += impact.j_W;
        if (impact.A >= 0) given[std::size_t(impact.A)] -= impact.j_W;
      });
  EXPECT_EQ(told, run.ledger.impacts);
  EXPECT_GT(pairs, 10);
  for (std::size_t i = 0; i < end.size(); ++i) {
    const double m = scene.bodies[i].shape.mass();
    const V gained = m * (end[i].v_WB - scene.bodies[i].start.v_WB), expected = given[i] + m * scene.until * scene.gravity;
    // some thousand sums of impulses below 100 N s: 1e4 roundings of 100 u
    EXPECT_LT(norm<double>(V(gained - expected)), 1e4 * 100 * 1.2e-16) << i;
  }
}

// The first touch of a level plate is at a lower corner, on the plane after the correction; then it tilts.
TEST(World, TellsWhereAnImpactIs) {
  Scene scene = builtin_scene("drop", 1);
  scene.until = 0.6;
  std::vector<V> at;
  simulate(scene, [](double, const auto&) {}, [&](const Impact& impact) { at.push_back(impact.p_WC); });
  ASSERT_GE(at.size(), 1u);
  const Vec3<double> size = scene.bodies[0].shape.size();
  EXPECT_NEAR(at[0][1], 0, 1e-15);
  EXPECT_NEAR(std::fabs(at[0][0]), size[0] / 2, 1e-15);
  EXPECT_NEAR(std::fabs(at[0][2]), size[2] / 2, 1e-15);
}

// Held at its centre by a critically damped spring, k = 30 m: x(t) = 1 - (1 + w t) exp(-w t), w = sqrt(30), which is
// 1 - 2.6e-3 after 1.6 s; gravity sags it by g/30.
TEST(World, HandPullsAndLetsGo) {
  Scene scene = builtin_scene("tumble", 1);
  scene.bodies[0].start.w_WB = zero3<double>();
  const double h = 1e-4, w = std::sqrt(30.0);
  World world(scene);
  world.hold(0, zero3<double>(), {1, 0, 0});
  for (int k = 0; k < 16000; ++k) world.step(k * h, h);
  // first order in h: the error of x is below h w
  EXPECT_NEAR(world.states()[0].p_WB[0], 1 - (1 + w * 1.6) * std::exp(-w * 1.6), h * w);
  EXPECT_LT(world.ledger().energy.worst_stepper, 1e-2);
  EXPECT_LT(world.ledger().energy.worst_drift, 16000 * 8 * 0x1p-53 * 15) << "15 J of the spring's work, a few roundings a step";
  world.release();
  const V v = world.states()[0].v_WB;
  world.step(2, h);
  EXPECT_EQ(world.states()[0].v_WB, v);
}

TEST(World, SwitchesGravityVacuumAndMethodOnTheWay) {
  World world(builtin_scene("assignment", 2));
  world.press(SceneAction::Do::gravity_off);
  world.step(0, 0.01);
  for (const auto& s : world.states()) EXPECT_EQ(s.v_WB[1], 0) << "nothing pulls, nothing touched yet";
  EXPECT_FALSE(world.gravity());
  world.press(SceneAction::Do::vacuum_on);
  world.set_method("rk4");
  world.step(0.01, 0.01);
  for (const auto& s : world.states()) EXPECT_NEAR(s.v_WB[1], 0.1, 1e-12) << "the vacuum lifts by 10 m/s^2";
  EXPECT_TRUE(world.vacuum());
  EXPECT_EQ(world.scene().method, "rk4");
}

}  // namespace
}  // namespace rigor
