#pragma once
#include <limits>
#include <map>
#include <memory>
#include <rigor/collision/box_box.hpp>
#include <rigor/engine/flight.hpp>
#include <rigor/engine/located.hpp>
#include <utility>
#include <vector>

namespace rigor {

/// A moment as an unevaluated sum, so that thousands of flights one after the other lose no digit of the time.
struct Moment {
  double hi = 0, lo = 0;
  Moment after(double tau) const {
    const double sum = hi + tau, part = sum - hi, error = (hi - (sum - part)) + (tau - part);
    return {sum, lo + error};
  }
  double value() const { return hi + lo; }
  double until(double t) const { return (t - hi) - lo; }
  double since(const Moment& earlier) const { return (hi - earlier.hi) + (lo - earlier.lo); }
};
constexpr Moment never{std::numeric_limits<double>::infinity(), 0};

/// A cuboid of the located world: what it is doing, and when that ends.
struct LocatedBody {
  enum class Phase { flying, sliding, resting, stepping };
  Phase phase = Phase::flying;
  Moment start;
  std::unique_ptr<Flight> flight;  // of every phase but stepping; without spin and with its own acceleration on a plane
  int support = -1;                // the plane it slides or rests on
  double next = std::numeric_limits<double>::infinity();          // s after start: when something happens
  bool tangled = false;            // and no impact can be named then
  Motion motion;                   // stepping: the state at `start`
  int calm = 0;                    // steps in a row in which it met nothing
  bool handed = false;             // to the stepper, and counted
  std::size_t reported = 0;        // its place among the hand-overs
};

/// When two cuboids meet next.
struct PairEvent {
  Moment at = never;
  bool tangled = false;
};

/// A scene on its way from event to event. Internal to simulate_located; the parts are in located_flight.cpp (planes,
/// slides, rest), located_pairs.cpp and located_stepper.cpp.
class LocatedWorld {
 public:
  LocatedWorld(const Scene& scene, RunSummary& summary, const LocatedObserver& observe_impact);

  /// Time of the next thing that happens: a body's own event, a pair's, a step of the stepper or an action.
  double next_time() const;
  void advance();

  std::vector<State<double>> states(double t) const;
  void finish(double t);

 private:
  const Cuboid<double>& shape(std::size_t i) const { return scene_.bodies[i].shape; }
  double size(std::size_t i) const { return norm<double>(shape(i).size()); }

  static State<double> state_at(const LocatedBody& b, double t);
  double energy(std::size_t i, const State<double>& s) const;
  Vec3<double> angular(std::size_t i, const State<double>& s) const;  ///< momentum about the world's origin

  /// The accounts of a flight, slide or rest up to τ.
  void account(std::size_t i, double tau);

  void act(const SceneAction& action);

  void happen(std::size_t i);

  /// The state τ after the beginning of a flight, which is over: its accounts are made.
  State<double> arrive(std::size_t i, double tau);

  /// Impacts of this moment, then the phase that follows.
  void begin(std::size_t i, const Moment& now, State<double> s);

  /// One impact on a plane, if any of the corners at it approaches.
  bool hit(std::size_t i, State<double>& s, const Plane<double>& plane);

  /// Whether a face lying on the plane can carry friction f (per unit of normal force) without tipping: the centre of
  /// pressure, the foot of the centre of mass moved by −height·f, stays inside the face.
  bool pressure_inside(std::size_t i, const State<double>& s, const Plane<double>& plane, const Vec3<double>& f) const;

  /// Whether a corner at the plane neither leaves it nor bounces higher than smallest_bounce.
  bool persists(std::size_t i, const State<double>& s, const Plane<double>& plane, double& tail) const;

  /// A face flat on one plane without spin: slides or rests. False when it is not that.
  bool lie(std::size_t i, const Moment& now, State<double> s, int support);

  void fly(std::size_t i, const Moment& now, const State<double>& s, const Vec3<double>& a, int support, LocatedBody::Phase phase, double ends);

  // -- pairs

  const PairEvent& nearest_event(std::size_t i) const;
  /// Searches the meetings of body i with everyone, and who each row meets first.
  void search_partners(std::size_t i);
  PairEvent search_pair(std::size_t i, std::size_t j);

  /// Two cuboids touch now: the manifold's approaching points are hit at their mean, until none approaches.
  void meet(std::size_t i, std::size_t j);
  double last_meeting_at(std::size_t i, std::size_t j) const;
  bool hit_pair(std::size_t i, State<double>& a, std::size_t j, State<double>& b, const Separation& apart, double smallest);

  // -- the stepper, for persistent contacts

  void hand_over(std::size_t i, const Moment& now, const State<double>& s, const char* why);
  /// Steps end at multiples of dt, so that all bodies in the stepper step together.
  double next_step() const;
  void step_all(double t);
  /// Not inside a plane or a body that flies: only then can it fly itself.
  bool clear(std::size_t i) const;
  bool respond(std::size_t i, const Plane<double>& plane);
  bool push_apart(std::size_t i, std::size_t j);
  void moved(std::size_t i, const Vec3<double>& shift);
  void note(const ImpactReport<double>& report);

  const Scene& scene_;
  RunSummary& summary_;
  const LocatedObserver& observe_impact_;
  Ledger& ledger_;
  Vec3<double> gravity_;
  std::vector<LocatedBody> bodies_;
  std::vector<PairEvent> pairs_;      // row i, column j > i
  std::vector<std::size_t> nearest_;  // whom row i meets first; itself: nobody
  std::map<std::pair<std::size_t, std::size_t>, double> last_meeting_;
  std::size_t stepping_ = 0, next_action_ = 0;
};

}  // namespace rigor
