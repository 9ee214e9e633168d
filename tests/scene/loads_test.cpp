#include <gtest/gtest.h>

#include <cmath>
#include <rigor/scene/simulate.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;

V speed_after_one_second(double switched_on, double dt) {
  Scene s = builtin_scene("spin-box", 1);
  s.gravity = zero3<double>();
  s.bodies[0].start.v_WB = zero3<double>();
  s.forces = {{0, V(3, -1, 2), zero3<double>(), false, switched_on, 5}};
  s.dt = dt;
  s.until = 1;
  State<double> end;
  simulate(s, [&](double, const std::vector<State<double>>& states) { end = states[0]; });
  return end.v_WB * s.bodies[0].shape.mass();
}

// case F-09: a load acts in the steps that begin while it is on. Switched on at the start of a step the momentum gained
// is F (T − t*) to rounding; inside a step the rest of that step is lost: an error of first order, F (ceil(t*/h) h − t*).
TEST(Loads, SwitchedOnInsideAStepActFromTheNextOne) {
  const V F(3, -1, 2);
  for (const double dt : {1.0 / 64, 1.0 / 128, 1.0 / 1024}) {
    EXPECT_LT(norm<double>(V(speed_after_one_second(0.25, dt) - F * 0.75)), 1e-13) << "on a step's boundary";
    const double late = std::ceil(0.3 / dt) * dt - 0.3;
    EXPECT_GT(late, 0);
    EXPECT_LT(norm<double>(V(speed_after_one_second(0.3, dt) - F * (0.7 - late))), 1e-13) << "inside a step";
  }
}

}  // namespace
}  // namespace rigor
