// What each skip of the plan saves: the same run with all of them and with all but one, in turn, the best of each. Then what
// two that are not there could save at most.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <rigor/engine/exact_flight.hpp>
#include <rigor/engine/located.hpp>
#include <rigor/formulas/semi_implicit_step.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/scene/simulate.hpp>

namespace {
using namespace rigor;

template <class Run>
double seconds(const Run& run) {
  const std::clock_t start = std::clock();  // of the processor: the machine may be busy
  run();
  return double(std::clock() - start) / CLOCKS_PER_SEC;
}
double seconds(const Scene& scene, const Skips& skips) {
  const Observer nobody = [](double, const std::vector<State<double>>&) {};
  return seconds([&] {
    if (scene.method == "located") (void)simulate_located(scene, nobody, {}, skips);
    else simulate(scene, nobody, {}, skips);
  });
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

Scene at_rest() {  // a thousand without gravity, of which one flies
  Scene s = thousand();
  s.gravity = zero3<double>();
  for (SceneBody& b : s.bodies) b.start.w_WB = zero3<double>();
  s.bodies[0].start.v_WB = Vec3<double>(1, 0, 1);
  return s;
}

void compare(const char* name, const Scene& scene, int rounds, const std::vector<const char*>& ids = {"pairs", "planes", "loads", "rest", "monitors", "all"}) {
  const Skips all{true, true, true, true};
  std::printf("%s\n", name);
  for (const char* id : ids) {
    double with = 1e9, without_it = 1e9;
    for (int k = 0; k < rounds; ++k) {
      with = std::min(with, seconds(scene, all));
      without_it = std::min(without_it, seconds(scene, *without(all, {id})));
    }
    std::printf("  --no-skip %-9s %8.2f ms, skipped %8.2f ms: %.2f times\n", id, 1e3 * without_it, 1e3 * with, without_it / with);
  }
}

// A step of the sheet, and one without Euler's equation: what isotropic inertia could save.
void isotropic() {
  const auto cube = *Cuboid<double>::make(2, {0.5, 0.5, 0.5});
  State<double> start;
  start.R_WB = rotation_of<double>(Vec4<double>(9, 1, -1, 2));
  start.w_WB = Vec3<double>(1, 2, -1);
  const Method& sheet = *find_method("sheet");
  Motion whole = motion_of(cube, start), less = whole;
  double with = 1e9, without_it = 1e9;
  for (int k = 0; k < 9; ++k) {
    with = std::min(with, seconds([&] { for (int n = 0; n < 100000; ++n) whole = sheet.step(cube, whole, {}, 1e-3); }));
    without_it = std::min(without_it, seconds([&] { for (int n = 0; n < 100000; ++n) less = motion_of(cube, semi_implicit_step<double>(1e-3, less.state, zero3<double>(), zero3<double>())); }));
  }
  std::printf("sheet's step of a cube %.0f ns, without angular acceleration %.0f ns; spins differ by %.1e after 9e5 steps\n", 1e4 * with, 1e4 * without_it, norm<double>(Vec3<double>(whole.state.w_WB - less.state.w_WB)));
}
void axis_spin() {
  double sum = 0;
  for (const bool axis : {false, true}) {
    const Vec3<double> I(1, 2, 2.5), w(axis ? 0 : 1, 2, axis ? 0 : -1);
    double make = 1e9, at = 1e9;
    for (int k = 0; k < 9; ++k) {
      make = std::min(make, seconds([&] { for (int n = 0; n < 10000; ++n) sum += ExactFlight::make(I, w, identity3<double>())->tuned().R0(0, 0); }));
      const auto flight = *ExactFlight::make(I, w, identity3<double>());
      at = std::min(at, seconds([&] { for (int n = 0; n < 100000; ++n) sum += flight.at(1e-3 * n).R_WB(0, 0); }));
    }
    std::printf("exact flight, spin %s: set-up %.2f us, evaluation %.0f ns\n", axis ? "about an axis" : "general", 1e2 * make, 1e4 * at);
  }
  if (sum == 1) std::printf("\n");
}

}  // namespace

int main() {
  Scene room = builtin_scene("assignment", 3);
  room.every = room.until;
  compare("the assignment's scene, 20 s", room, 9);
  compare("1000 cuboids over a floor, 60 steps", thousand(), 3);
  compare("1000 cuboids without gravity, all but one at rest, 60 steps", at_rest(), 3);
  room.method = "located";
  compare("located, the assignment's scene, 20 s", room, 9, {"pairs", "planes", "all"});
  Scene many = thousand();
  many.method = "located";
  many.until = many.every = 1;
  compare("located, 1000 cuboids over a floor, 1 s", many, 3, {"pairs", "planes", "all"});
  isotropic();
  axis_spin();
}
