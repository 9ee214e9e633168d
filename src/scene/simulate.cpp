#include <cmath>
#include <rigor/base/interrupt.hpp>
#include <rigor/scene/simulate.hpp>

namespace rigor {

RunSummary simulate(const Scene& scene, const Observer& observe, const ImpactObserver& on_impact, bool skip) {
  World world(scene, on_impact);
  if (!skip) world.skip_nothing();
  RunSummary summary;
  observe(0, world.states());
  const long steps = std::max(0L, long(std::ceil(scene.until / scene.dt - 1e-9)));
  double next_output = scene.every;
  for (long k = 0; k < steps; ++k) {
    const double t = double(k) * scene.dt;  // not summed: no rounding piles up
    const bool last = k + 1 == steps;
    const double t_next = last ? scene.until : double(k + 1) * scene.dt;
    world.step(t, last ? scene.until - t : scene.dt);
    ++summary.steps;
    summary.t_end = t_next;
    summary.finite = world.finite();
    const bool due = scene.every == 0 || t_next >= next_output - 1e-9 * scene.dt;
    const bool stop = last || !summary.finite || interrupted() != 0;
    if (due || stop) observe(t_next, world.states());
    while (scene.every > 0 && next_output <= t_next + 1e-9 * scene.dt) next_output += scene.every;
    if (stop && !last) {
      summary.interrupted = interrupted() != 0;
      break;
    }
  }
  summary.ledger = world.ledger();
  return summary;
}

}  // namespace rigor
