#include <cmath>
#include <rigor/base/interrupt.hpp>
#include <rigor/scene/simulate.hpp>

namespace rigor {

RunSummary simulate(const Scene& scene, const Observer& observe, const ImpactObserver& on_impact, const Skips& skips) {
  World world(scene, on_impact);
  world.set_skips(skips);
  RunSummary summary;
  observe(0, world.states());
  const long steps = scene.until > 0 ? std::max(1L, long(std::ceil(scene.until / scene.dt - 1e-9))) : 0;
  double rows = 0;  // output times passed, of multiples of `every`
  for (long k = 0; k < steps; ++k) {
    const double t = double(k) * scene.dt;  // not summed: no rounding piles up
    const bool last = k + 1 == steps;
    const double t_next = last ? scene.until : double(k + 1) * scene.dt;
    world.step(t, last ? scene.until - t : scene.dt);
    ++summary.steps;
    summary.t_end = t_next;
    summary.finite = world.finite();
    const double passed = scene.every > 0 ? std::floor((t_next + 1e-9 * scene.dt) / scene.every) : rows + 1;
    const bool due = passed > rows;
    rows = passed;
    const bool stop = last || !summary.finite || interrupted() != 0;
    if ((due || stop) && summary.finite) observe(t_next, world.states());
    if (stop && !last) {
      summary.interrupted = interrupted() != 0;
      break;
    }
  }
  world.make_up_accounts();
  summary.ledger = world.ledger();
  return summary;
}

}  // namespace rigor
