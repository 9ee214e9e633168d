#pragma once
#include <functional>
#include <rigor/scene/scene.hpp>
#include <rigor/scene/world.hpp>
#include <string>
#include <vector>

namespace rigor {

/// Called at t = 0, at every output time and at the end: the states of all bodies, in scene order, every number finite.
using Observer = std::function<void(double t, const std::vector<State<double>>& states)>;

/// A body was not in exact flight (method "located" only): so often for this reason, with none for another reason in between.
struct HandOver {
  std::size_t body;
  long times;
  double from, to;       ///< s: beginning of the first time, end of the last
  std::string why;
};
/// Bounces that ended by rule: the height of the next one was below 1e-14 of the cuboid's size.
struct Accumulation {
  std::size_t body;
  double at;             ///< s, the last impact that was computed
  double tail;           ///< s, what the bounces left out would have taken: 2v/(a (1 − e)) for one contact
};

/// Two cuboids of which one at least was in the stepper may have passed through each other (method "located" only): they met more
/// often within one step than it is divided for.
struct MayHaveMissed {
  std::size_t A, B;
  long times;            ///< steps
  double from, to;       ///< s: the first and the last time
};

struct RunSummary {
  Ledger ledger;
  std::vector<HandOver> handed_over;
  std::vector<Accumulation> accumulations;
  std::vector<MayHaveMissed> may_have_missed;
  std::string stopped;   ///< why the run ended before `until`; "" when it did not
  long steps = 0;        ///< of the integrator; method "located": advances of the searches it made, so fewer where searches are skipped
  double t_end = 0;      ///< `until`, or earlier when interrupted
  bool interrupted = false;
  bool finite = true;    ///< false: the run stopped at the first step with a number that is not finite
};

/// The assignment's program, step by step: forces; every cuboid against every plane; every pair i < j, with the
/// position correction split half and half, then the impulse; then every cuboid advances. The last step is shortened
/// to end at `until` exactly; a remainder below 1e-9 of a step is joined to the step before it.
///
/// Friction acts on planes only, pairs have the normal impulse (as the assignment asks). Contact points of a pair: the
/// centroid of the manifold, or the handed-out corner. Impacts are told as they happen, before the `observe` of their step.
///
/// `skips` leaves out what cannot matter (plan.hpp). Same bits with and without.
RunSummary simulate(const Scene& scene, const Observer& observe, const ImpactObserver& on_impact = {}, const Skips& skips = {});

}  // namespace rigor
