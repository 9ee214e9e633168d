// A tumbling cuboid in the assignment's room: located mode beside our own stepper and Bullet at steps of 1/240 s and finer.
// Time of a run, the best of many, and how far from the 60-digit witness the cuboid ends, after 1, 4 and 20 impacts (halfway
// to the next one).
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <rigor/engine/located.hpp>

#include "../engine/room.hpp"
#include "room_peer.hpp"

namespace {
using namespace rigor;
using V = Vec3<double>;

double best_seconds(const std::function<void()>& run) {
  double best = 1e9;
  for (int k = 0; k < 15; ++k) {
    const auto start = std::chrono::steady_clock::now();
    run();
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}
V bullet([[maybe_unused]] const Scene& scene, [[maybe_unused]] double dt) {
#ifdef RIGOR_BENCH_BULLET
  const auto array = [](const V& a) { return std::array<double, 3>{a[0], a[1], a[2]}; };
  const SceneBody& b = scene.bodies[0];
  bench::PeerRoom room{{}, array(scene.gravity), array(b.shape.size()), array(b.start.p_WB), array(b.start.v_WB), array(b.start.w_WB), b.shape.mass(), scene.surface.restitution(), scene.surface.dynamic_friction(), scene.until, std::lround(scene.until / dt)};
  for (const auto& plane : scene.planes) room.planes.push_back({array(plane.normal()), plane.normal().dot(plane.point())});
  const auto p = bench::bullet_room(room);
  return V(p[0], p[1], p[2]);
#else
  return V::Constant(std::numeric_limits<double>::quiet_NaN());
#endif
}

void compare(double mu) {
  Scene scene = room(0.5, mu);
  const reference::Throw thrown_one = thrown_in(scene);
  const auto want = reference::precise_impacts(thrown_one, thrown<P>(scene.bodies[0].start), scene.until, 21);
  V end;
  const Observer keep = [&](double, const std::vector<State<double>>& states) { end = states[0].p_WB; };
  for (const std::size_t impacts : {1u, 4u, 20u}) {
    const P until = (want[impacts - 1].t + want[impacts].t) / 2;
    scene.until = scene.every = double(until);
    const Thrown<P> there = reference::precise_flight(thrown_one, want[impacts - 1].after, P(scene.until) - want[impacts - 1].t);
    const V p(double(there.p_WB[0]), double(there.p_WB[1]), double(there.p_WB[2]));
    std::printf("mu %.1f, %zu impacts, %.3f s\n", mu, impacts, scene.until);
    double located = 0;
    const auto row = [&](const char* name, const std::function<void()>& run) {
      const double time = best_seconds(run);
      if (located == 0) located = time;
      std::printf("  %-24s %9.1f us, %6.2f times located; off by %8.1e m\n", name, 1e6 * time, time / located, norm<double>(V(end - p)));
    };
    row("located", [&] { (void)simulate_located(scene, keep); });
    for (const long finer : {1, 16, 256}) {
      scene.dt = 1.0 / double(240 * finer);
      scene.method = "sheet";
      row(("sheet, 1/" + std::to_string(240 * finer) + " s").c_str(), [&] { simulate(scene, keep); });
      row(("Bullet, 1/" + std::to_string(240 * finer) + " s").c_str(), [&] { end = bullet(scene, scene.dt); });
    }
    scene.method = "located";
  }
}

}  // namespace

int main() {
  compare(0);
  compare(0.3);
}
