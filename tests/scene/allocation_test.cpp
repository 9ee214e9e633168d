// Counts what the program allocates.
#include <gtest/gtest.h>

#include <rigor/linalg/rotation.hpp>
#include <rigor/scene/world.hpp>
#include <tests/scene/allocations.hpp>

namespace rigor {
namespace {

// A heap of forty on a floor, all methods of the plain stepper's kind: after a first second, a second more.
TEST(Allocation, NoneWhileStepping) {
  for (const char* method : {"sheet", "euler-momentum", "rk4", "split2"}) {
    Scene s;
    s.method = method;
    s.planes.push_back(*Plane<double>::make({0, 0, 0}, {0, 1, 0}));
    s.surface = *Surface<double>::make(0.5, 0.5, 0.3);
    for (int k = 0; k < 40; ++k) {
      State<double> start;
      start.p_WB = Vec3<double>(0.9 * (k % 4), 1 + 0.9 * (k / 16), 0.9 * (k / 4 % 4));
      start.R_WB = rotation_of<double>(Vec4<double>(9, k % 5, -1, 2));
      s.bodies.push_back({*Cuboid<double>::make(2.5, {0.3, 0.5, 0.9}), start});
    }
    World world(s);
    const auto second = [&] {
      for (int k = 0; k < 240; ++k) world.step(k * s.dt, s.dt), world.states();
    };
    second();
    const long before = allocations;
    second();
    EXPECT_EQ(allocations, before) << method;
    EXPECT_GT(world.ledger().pair_impacts, 100) << method;
  }
}

}  // namespace
}  // namespace rigor
