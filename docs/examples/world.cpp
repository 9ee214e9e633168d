// The assignment's program as a library: a world, stepped by its owner; every impulse is told as it is given.
#include <cstdio>
#include <rigor/scene/world.hpp>

int main() {
  rigor::Scene scene;
  scene.planes.push_back(*rigor::Plane<double>::make({0, 0, 0}, {0, 1, 0}));
  scene.surface = *rigor::Surface<double>::make(0.5, 0, 0);
  rigor::State<double> start;
  start.p_WB = {0, 1.25, 0};
  start.w_WB = {0.3, 0, 1};
  scene.bodies.push_back({*rigor::Cuboid<double>::make(2.5, {0.7, 0.5, 1.9}), start});
  rigor::Vec3<double> given = rigor::zero3<double>();
  int impulses = 0;
  rigor::World world(scene, [&](const rigor::Impact& impact) { given += impact.j_W, ++impulses; });
  for (int k = 0; k < 256; ++k) world.step(k / 256.0, 1 / 256.0);
  const rigor::State<double> end = world.states()[0];
  std::printf("%d impulses, together %.6f N s, less the weight's 24.5 N s: %.6f kg m/s\n", impulses, given[1], given[1] - 24.5);
  std::printf("momentum after one second: %.6f kg m/s\n", 2.5 * end.v_WB[1]);
}
