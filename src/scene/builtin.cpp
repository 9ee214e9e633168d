#include <rigor/base/promise.hpp>
#include <rigor/scene/random.hpp>
#include <rigor/scene/scene.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;

Plane<double> plane(const V& point, const V& normal) { return *Plane<double>::make(point, normal); }
SceneBody body(double mass, const V& size, const State<double>& start) { return {*Cuboid<double>::make(mass, size), start}; }

// Ten cuboids in a room, at rest: assignment/interface.md.
Scene assignment(std::uint64_t seed) {
  Scene s;
  std::mt19937_64 random(seed);
  for (int i = 0; i < 10; ++i) {
    // one draw a line: the order of arguments and operands is the compiler's choice
    V size;
    for (int k = 0; k < 3; ++k) size[k] = uniform(random, 0.5, 2.5);
    const double mass = uniform(random, 2, 3);
    const double distance = uniform(random, 2, 10);
    State<double> start;
    start.p_WB = distance * upward_direction(random);
    s.bodies.push_back(body(mass, size, start));
  }
  s.planes = {plane({0, 0, 0}, {0, 1, 0}), plane({0, 5, 0}, {0, -1, 0}), plane({10, 0, 0}, {-1, 0, 0}),
              plane({-10, 0, 0}, {1, 0, 0}), plane({0, 0, 10}, {0, 0, -1}), plane({0, 0, -10}, {0, 0, 1})};
  s.surface = *Surface<double>::make(0.5, 0.5, 0.3);
  s.every = 1.0 / 30;
  return s;
}
// A block let go 1 m above the floor, level.
Scene drop(std::uint64_t) {
  Scene s;
  State<double> start;
  start.p_WB = V(0, 1.25, 0);
  s.bodies.push_back(body(2, {1, 0.5, 0.75}, start));
  s.planes.push_back(plane({0, 0, 0}, {0, 1, 0}));
  s.surface = *Surface<double>::make(0.5, 0, 0);
  s.until = 3;
  return s;
}
// Torque-free, near the unstable axis: case A of the free-flight studies.
Scene tumble(std::uint64_t) {
  Scene s;
  State<double> start;
  start.w_WB = V(0.3, 2, 0.2);
  s.bodies.push_back(body(1, {1, 2, 3}, start));
  s.gravity = zero3<double>();
  s.until = 10;
  return s;
}
// A cuboid sliding on the floor at 3 m/s.
Scene slide(std::uint64_t) {
  Scene s;
  State<double> start;
  start.p_WB = V(0, 0.25, 0);
  start.v_WB = V(3, 0, 0);
  s.bodies.push_back(body(2, {1, 0.5, 0.75}, start));
  s.planes.push_back(plane({0, 0, 0}, {0, 1, 0}));
  s.surface = *Surface<double>::make(0, 0.3, 0.3);
  s.until = 3;
  return s;
}
// The public benchmark box: 0.1 x 0.4 x 0.9 m, 10 kg, thrown and tumbling: case FB-05.
Scene spin_box(std::uint64_t) {
  Scene s;
  State<double> start;
  start.w_WB = V(0.1, 5, 0.1);
  start.v_WB = V(1, 2, 3);
  s.bodies.push_back(body(10, {0.1, 0.4, 0.9}, start));
  s.until = 10;
  return s;
}

struct Builtin {
  const char* name;
  Scene (*make)(std::uint64_t);
};
constexpr Builtin all[] = {{"assignment", assignment}, {"drop", drop}, {"tumble", tumble}, {"slide", slide}, {"spin-box", spin_box}};

}  // namespace

std::vector<std::string> builtin_scenes() {
  std::vector<std::string> names;
  for (const Builtin& b : all) names.push_back(b.name);
  return names;
}

Scene builtin_scene(const std::string& name, std::uint64_t seed) {
  for (const Builtin& b : all)
    if (name == b.name) {
      Scene scene = b.make(seed);
      scene.name = name;
      scene.seed = seed;
      return scene;
    }
  promise(false, "a built-in scene is asked for by one of builtin_scenes()");
  return {};
}

}  // namespace rigor
