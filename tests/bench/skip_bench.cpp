// What each skip of the plan saves: the same run with all of them and with all but one, in turn, the best of each.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <rigor/linalg/rotation.hpp>
#include <rigor/scene/simulate.hpp>

namespace {
using namespace rigor;

double seconds(const Scene& scene, const Skips& skips) {
  const auto start = std::chrono::steady_clock::now();
  simulate(scene, [](double, const std::vector<State<double>>&) {}, {}, skips);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Scene thousand() {  // over a floor, four metres apart
  Scene s;
  for (int i = 0; i < 1000; ++i) {
    State<double> start;
    start.p_WB = Vec3<double>(4 * (i % 32), 3, 4 * (i / 32));
    start.R_WB = rotation_of<double>(Vec4<double>(9, 1, -1, 2));
    start.w_WB = Vec3<double>(0.3, 1, -0.2);
    s.bodies.push_back({*Cuboid<double>::make(2.5, {0.7, 1.1, 1.9}), start});
  }
  s.planes.push_back(*Plane<double>::make({0, 0, 0}, {0, 1, 0}));
  s.surface = *Surface<double>::make(0.5, 0.5, 0.3);
  s.until = 0.25;
  return s;
}

void compare(const char* name, const Scene& scene, int rounds) {
  const Skips all{true, true, true, true};
  std::printf("%s\n", name);
  for (const char* id : {"pairs", "planes", "loads", "monitors", "all"}) {
    double with = 1e9, without_it = 1e9;
    for (int k = 0; k < rounds; ++k) {
      with = std::min(with, seconds(scene, all));
      without_it = std::min(without_it, seconds(scene, *without(all, {id})));
    }
    std::printf("  --no-skip %-9s %8.2f ms, skipped %8.2f ms: %.2f times\n", id, 1e3 * without_it, 1e3 * with, without_it / with);
  }
}

}  // namespace

int main() {
  Scene room = builtin_scene("assignment", 3);
  room.every = room.until;
  compare("the assignment's scene, 20 s", room, 9);
  compare("1000 cuboids over a floor, 60 steps", thousand(), 3);
}
