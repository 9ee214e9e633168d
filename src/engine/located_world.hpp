#pragma once
#include <limits>
#include <map>
#include <optional>
#include <rigor/collision/box_box.hpp>
#include <rigor/collision/box_index.hpp>
#include <rigor/engine/flight.hpp>
#include <rigor/engine/located.hpp>
#include <rigor/engine/pair_search.hpp>
#include <rigor/linalg/carried.hpp>
#include <tuple>
#include <utility>
#include <vector>

namespace rigor {

/// A moment as an unevaluated sum, so that thousands of flights one after the other lose no digit of the time.
struct Moment {
  double hi = 0, lo = 0;
  Moment after(double tau) const {
    const auto [sum, error] = two_sum<double>(hi, tau);
    return {sum, lo + error};
  }
  double value() const { return hi + lo; }
  double until(double t) const { return (t - hi) - lo; }
  double since(const Moment& earlier) const { return (hi - earlier.hi) + (lo - earlier.lo); }
};
constexpr Moment never{std::numeric_limits<double>::infinity(), 0};

/// Where places are rounded by more than this part of the smallest edge, it cannot be said what touches what.
constexpr double coarse = 1e-3;
constexpr const char* too_coarse = "flew so far that its place is rounded by a thousandth of its smallest edge";

/// A cuboid of the located world: what it is doing, and when that ends.
struct LocatedBody {
  enum class Phase { flying, sliding, gliding, resting, stepping };
  Phase phase = Phase::flying;
  Moment start;
  std::optional<Flight> flight;    // of every phase but stepping; with its own acceleration on a plane
  int support = -1;                // the plane it slides, glides or rests on
  double next = std::numeric_limits<double>::infinity();          // s after start: when something happens
  const char* trouble = nullptr;   // why no impact can be named then
  double rounding = 0;             // m: what roundings of its flights may have done to its place
  std::uint32_t flights = 0;       // how many it has begun; events and meetings of earlier ones are void
  double looked = 0;               // s after start: until then its box holds it, and who it meets is known
  double stride = 0;               // m: how far it travels in one box, as experience has it
  State<double> state;             // stepping: at `start`
  int calm = 0;                    // steps in a row in which it met nothing
  bool handed = false;             // to the stepper, and counted
  static constexpr std::size_t nowhere = std::size_t(-1);
  std::size_t reported = nowhere;  // place of its last one among the hand-overs
};

/// When two cuboids meet next.
struct PairEvent {
  Moment at = never;
  PairContact::Kind found = PairContact::Kind::none;
};

/// Something to come. In order of time; of one moment: looks, then cuboids by index, then pairs.
struct Event {
  enum class Kind : std::uint8_t { look, own, meeting };
  Moment at;
  Kind kind;
  PairContact::Kind found;         // of a meeting
  std::uint32_t i, j;              // j of a meeting; i otherwise
  std::uint32_t flight_i, flight_j;
  friend bool operator>(const Event& a, const Event& b) {
    return std::tuple(a.at.value(), a.kind, a.i, a.j) > std::tuple(b.at.value(), b.kind, b.i, b.j);
  }
};

/// A scene on its way from event to event. Internal to simulate_located; the parts are in located_flight.cpp (planes,
/// slides, rest), located_pairs.cpp and located_stepper.cpp.
class LocatedWorld {
 public:
  LocatedWorld(const Scene& scene, RunSummary& summary, const LocatedObserver& observe_impact, const Skips& skips);

  /// Time of the next thing that happens: a body's own event, a pair's, a step of the stepper or an action. Looks that are
  /// due before it are made.
  double next_time();
  void advance();

  /// Kept until the next call.
  const std::vector<State<double>>& states(double t);
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

  /// Whether a face lies on the plane, with no spin but about its normal.
  bool flat(std::size_t i, const State<double>& s, const Plane<double>& plane) const;
  /// The speeds that roundings of speeds are measured by, m/s.
  double pace(std::size_t i, const State<double>& s) const;

  /// A face flat on one plane: glides where there is no friction; without spin it slides or rests. False when it is not that.
  bool lie(std::size_t i, const Moment& now, State<double> s, int support);

  void fly(std::size_t i, const Moment& now, const State<double>& s, const Vec3<double>& a, int support, LocatedBody::Phase phase, double ends);

  // -- pairs: who may meet is found by boxes that hold a flight for a while, docs/located-impacts.md

  /// Puts body i into a box that holds it for a while from `looked`, and searches its meetings with those whose boxes
  /// overlap it and who were not searched in these two flights.
  void look(std::size_t i);
  /// Everybody whose box overlaps `box`, in order of index; everybody at all where pairs are not skipped.
  void near(const AxisBox& box, std::vector<std::uint32_t>& found) const;
  PairEvent search_pair(std::size_t i, std::size_t j);

  void push(const Event& event);
  bool is_void(const Event& event) const;
  /// Ends the flight of body i: its events are void.
  void land(std::size_t i);

  /// Two cuboids touch now: the manifold's approaching points are hit at their mean, until none approaches.
  void meet(const Event& event);
  /// What roundings of this flight and those before may have done to the place of one in flight, m.
  static double rounding_at(const LocatedBody& body, const Moment& now);
  /// How deep two may be in one another and still touch, m: a billionth of the smallest edge, and what roundings of places make.
  double allowed_overlap(std::size_t i, const State<double>& a, std::size_t j, const State<double>& b) const;
  double last_meeting_at(std::size_t i, std::size_t j) const;
  bool hit_pair(std::size_t i, State<double>& a, std::size_t j, State<double>& b, const Separation& apart, double smallest);

  // -- the stepper, for persistent contacts

  void hand_over(std::size_t i, const Moment& now, const State<double>& s, const char* why);
  /// Steps end at multiples of dt, so that all bodies in the stepper step together; and where two would meet that a step could
  /// carry past each other, soon after they meet.
  double step_after(const Moment& start) const;
  void step_all(double t);
  /// Looks at what the step to come would carry past each other, for bodies in `unwatched_`.
  void watch_step();
  void watch_pair(std::size_t i, std::size_t j);
  /// A body in the stepper has moved: where it has left its box it gets a new one, and true is returned.
  bool settle(std::size_t i);
  /// Whether the spheres around two cuboids do not touch.
  bool spheres_apart(std::size_t i, const State<double>& a, std::size_t j, const State<double>& b) const;
  /// Not inside another cuboid: only then can it fly itself.
  bool clear(std::size_t i);
  bool respond(std::size_t i, const Plane<double>& plane);
  bool push_apart(std::size_t i, std::size_t j);
  void moved(std::size_t i, const Vec3<double>& shift);
  void note(const ImpactReport<double>& report);

  const Scene& scene_;
  RunSummary& summary_;
  const LocatedObserver& observe_impact_;
  Ledger& ledger_;                     // counts and extremes; what is summed up gets there in finish
  struct Momentum {
    Carried<Vec3<double>> start, external, end;
  } linear_, angular_;
  struct {
    Carried<double> start, restitution_loss, friction_loss, correction, switched, end;
  } energy_;
  Vec3<double> gravity_;
  Skips skips_;
  std::vector<LocatedBody> bodies_;
  BoxIndex boxes_;
  std::vector<Event> events_;         // a heap, with events of earlier flights in it
  std::size_t events_kept_ = 0;       // when those were last thrown out
  /// Whom a body was searched with, and in which flight of theirs.
  struct Partner {
    std::uint32_t body, flight;
  };
  struct Partners {
    std::vector<Partner> known;
    std::size_t kept = 0;             // when those of earlier flights were last thrown out
  };
  void forget_void(Partners& partners) const;
  std::vector<Partners> partners_;
  std::vector<std::uint32_t> found_, fresh_;
  std::vector<bool> known_, met_;
  std::size_t flying_ = 0;
  std::map<std::pair<std::size_t, std::size_t>, double> last_meeting_;
  std::vector<std::uint32_t> stepping_, step_of_;  // in order of index; of the step on its way
  std::vector<std::pair<std::uint32_t, std::uint32_t>> flown_into_;
  long steps_ = 0;
  double next_step_ = std::numeric_limits<double>::infinity();  // s; not after whole_step_
  double whole_step_ = next_step_;       // the next multiple of dt
  int parts_ = 0;                        // of the step on its way
  double now_ = 0;                       // s: everything before has happened
  std::vector<std::uint32_t> unwatched_; // who moves on a path that the step to come was not searched with
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> missed_;  // place in may_have_missed
  std::size_t next_action_ = 0;
  std::vector<State<double>> shown_;
};

}  // namespace rigor
