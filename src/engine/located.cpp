#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <rigor/base/interrupt.hpp>
#include <rigor/base/promise.hpp>
#include <rigor/contact/plane_response.hpp>
#include <rigor/engine/located.hpp>
#include <rigor/collision/box_box.hpp>
#include <rigor/engine/pair_search.hpp>
#include <rigor/engine/plane_search.hpp>
#include <rigor/formulas/gram_schmidt.hpp>
#include <rigor/linalg/rotation.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;
constexpr double infinity = std::numeric_limits<double>::infinity(), u = 0x1p-53;
constexpr double smallest_bounce = 1e-14;  // height over size below which bounces end
constexpr int calm_steps = 10;             // of the stepper, before a body flies again
constexpr long most_impacts = 10000000;    // of one run

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
constexpr Moment never{infinity, 0};

struct Body {
  enum class Phase { flying, sliding, resting, stepping };
  Phase phase = Phase::flying;
  Moment start;
  std::unique_ptr<Flight> flight;  // of every phase but stepping; without spin and with its own acceleration on a plane
  int support = -1;                // the plane it slides or rests on
  double next = infinity;          // s after start: when something happens
  bool tangled = false;            // and no impact can be named then
  Motion motion;                   // stepping: the state at `start`
  int calm = 0;                    // steps in a row in which it met nothing
  bool handed = false;             // to the stepper, and counted
  std::size_t reported = 0;        // its place among the hand-overs
};

struct PairEvent {
  Moment at = never;
  bool tangled = false;
};

class LocatedWorld {
 public:
  LocatedWorld(const Scene& scene, RunSummary& summary, const LocatedObserver& observe_impact)
      : scene_(scene), summary_(summary), observe_impact_(observe_impact), ledger_(summary.ledger), gravity_(scene.gravity) {
    for (const SceneBody& b : scene.bodies) {
      bodies_.emplace_back();
      ledger_.energy.start += energy(bodies_.size() - 1, b.start);
    }
    pairs_.resize(bodies_.size() * bodies_.size());
    nearest_.assign(bodies_.size(), 0);
    for (std::size_t i = 0; i < bodies_.size(); ++i) bodies_[i].phase = Body::Phase::stepping;  // unknown to each other until begun
    for (std::size_t i = 0; i < bodies_.size(); ++i) begin(i, Moment{}, scene.bodies[i].start);
  }

  /// Time of the next thing that happens: a body's own event, a pair's, a step of the stepper or an action.
  double next_time() const {
    double t = next_action_ < scene_.actions.size() ? scene_.actions[next_action_].at : infinity;
    if (stepping_ > 0) t = std::min(t, next_step());
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      t = std::min(t, bodies_[i].start.after(bodies_[i].next).value());
      t = std::min(t, nearest_event(i).at.value());
    }
    return t;
  }
  void advance() {
    const double t = next_time();
    if (next_action_ < scene_.actions.size() && scene_.actions[next_action_].at <= t) return act(scene_.actions[next_action_++]);
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      if (bodies_[i].start.after(bodies_[i].next).value() <= t) return happen(i);
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      if (nearest_event(i).at.value() <= t) return meet(i, nearest_[i]);
    step_all(t);
  }

  std::vector<State<double>> states(double t) const {
    std::vector<State<double>> all;
    for (const Body& b : bodies_) all.push_back(state_at(b, t));
    return all;
  }
  void finish(double t) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const State<double> s = state_at(bodies_[i], t);
      if (bodies_[i].flight) account(i, bodies_[i].start.until(t));
      ledger_.energy.end += energy(i, s);
      ledger_.linear.end += scene_.bodies[i].shape.mass() * s.v_WB;
      ledger_.worst_orthonormality = std::fmax(ledger_.worst_orthonormality, orthonormality_defect<double>(s.R_WB));
      if (bodies_[i].phase == Body::Phase::stepping) summary_.handed_over[bodies_[i].reported].to = t;
    }
    Ledger::Energy& e = ledger_.energy;
    e.worst_drift = std::fabs(e.end - e.start - e.correction - e.switched + e.restitution_loss + e.friction_loss);
    ledger_.linear.worst_drift = norm<double>(V(ledger_.linear.end - ledger_.linear.start - ledger_.linear.external));
  }

 private:
  const Cuboid<double>& shape(std::size_t i) const { return scene_.bodies[i].shape; }
  double size(std::size_t i) const { return norm<double>(shape(i).size()); }

  static State<double> state_at(const Body& b, double t) {
    return b.flight ? b.flight->at(std::max(0.0, b.start.until(t))) : b.motion.state;
  }
  double energy(std::size_t i, const State<double>& s) const {
    const V w_B = apply_transposed<double>(s.R_WB, s.w_WB);
    return (shape(i).mass() * dot<double>(s.v_WB, s.v_WB) + dot<double>(w_B, V(w_B.cwiseProduct(shape(i).inertia())))) / 2 -
           shape(i).mass() * dot<double>(gravity_, s.p_WB);
  }

  /// The accounts of a flight, slide or rest up to τ.
  void account(std::size_t i, double tau) {
    const Flight& f = *bodies_[i].flight;
    const V moved = tau * f.start().v_WB + tau * tau / 2 * f.acceleration();
    ledger_.linear.external += shape(i).mass() * tau * f.acceleration();
    if (bodies_[i].support >= 0) ledger_.energy.friction_loss -= shape(i).mass() * dot<double>(V(f.acceleration() - gravity_), moved);
  }

  void act(const SceneAction& action) {
    const V before = gravity_;
    gravity_ = action.what == SceneAction::Do::gravity_on ? scene_.gravity : zero3<double>();
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const State<double> s = state_at(bodies_[i], action.at);
      ledger_.energy.switched += shape(i).mass() * dot<double>(V(before - gravity_), s.p_WB);
      if (!bodies_[i].flight) continue;
      const V now = gravity_;
      gravity_ = before;
      account(i, bodies_[i].start.until(action.at));
      gravity_ = now;
      begin(i, bodies_[i].start.after(bodies_[i].start.until(action.at)), s);
    }
  }

  void happen(std::size_t i) {
    Body& b = bodies_[i];
    const Moment now = b.start.after(b.next);
    State<double> s = arrive(i, b.next);
    if (b.phase == Body::Phase::sliding && !b.tangled && dot<double>(s.v_WB, b.flight->start().v_WB) <= 0) s.v_WB = zero3<double>();
    if (b.tangled) return hand_over(i, now, s, "a corner follows the plane within rounding");
    LocatedImpact seen{i, now.value(), b.next, b.flight->start(), s, s};
    const long impacts = ledger_.impacts;
    begin(i, now, s);
    if (!observe_impact_ || ledger_.impacts == impacts) return;
    seen.after = bodies_[i].flight ? bodies_[i].flight->start() : bodies_[i].motion.state;
    observe_impact_(seen);
  }

  /// The state τ after the beginning of a flight, which is over: its accounts are made.
  State<double> arrive(std::size_t i, double tau) {
    State<double> s = bodies_[i].flight->at(tau);
    account(i, tau);
    if (bodies_[i].flight->spin_bound() > 0) s.R_WB = gram_schmidt<double>(s.R_WB);
    return s;
  }

  /// Impacts of this moment, then the phase that follows.
  void begin(std::size_t i, const Moment& now, State<double> s) {
    for (const Plane<double>& plane : scene_.planes)
      for (const double gap : corner_gaps(shape(i), s, plane).gap)
        if (gap < -1e-9 * size(i)) return hand_over(i, now, s, "begins inside a plane");
    for (int round = 0;; ++round) {
      bool any = false;
      for (const Plane<double>& plane : scene_.planes) any = hit(i, s, plane) || any;
      if (!any) break;
      if (round == 100) return hand_over(i, now, s, "impacts of one moment do not end");
    }
    int support = -1, supports = 0;
    double tail = 0;
    for (std::size_t p = 0; p < scene_.planes.size(); ++p)
      if (persists(i, s, scene_.planes[p], tail)) support = int(p), ++supports;
    if (supports == 0) return fly(i, now, s, gravity_, -1, Body::Phase::flying, infinity);
    if (supports > 1) return hand_over(i, now, s, "rests on more than one plane");
    if (!lie(i, now, s, support)) return hand_over(i, now, s, "a persistent contact that is no face lying flat without spin");
    if (tail > 0) summary_.accumulations.push_back({i, now.value(), tail});
  }

  /// One impact on a plane, if any of the corners at it approaches.
  bool hit(std::size_t i, State<double>& s, const Plane<double>& plane) {
    const CornerGaps c = corner_gaps(shape(i), s, plane);
    V arm = zero3<double>();
    int count = 0;
    for (int k = 0; k < 8; ++k)
      if (c.gap[k] <= 64 * c.rounding && c.rate[k] < -c.still) arm += apply<double>(s.R_WB, shape(i).corner(k)), ++count;
    if (count == 0) return false;
    arm /= count;
    const V weight = shape(i).mass() * gravity_;
    const auto resolve = [&](const Mat3<double>& inverse_I, const V& at) {
      Contact<double> contact{{}, {shape(i).inverse_mass(), inverse_I, at}, plane.normal(), weight};
      return resolve_impact<double>(contact, {{}, {s.v_WB, s.w_WB}}, scene_.surface, scene_.friction_law);
    };
    ImpactResult<double> result;
    bool whole = false;
    if (count == 4 && norm<double>(s.w_WB) * size(i) <= 1e-12 * norm<double>(s.v_WB)) {
      result = resolve(Mat3<double>::Zero(), zero3<double>());
      const double j_n = dot<double>(result.report.j_W, plane.normal());
      whole = pressure_inside(i, s, plane, V((result.report.j_W - j_n * plane.normal()) / j_n));
    }
    if (!whole) result = resolve(world_inverse_inertia<double>(s.R_WB, shape(i).inverse_inertia()), arm);
    if (result.report.separating) return false;
    s.v_WB = result.after.B.v_WB;
    s.w_WB = whole ? zero3<double>() : result.after.B.w_WB;
    ++ledger_.plane_impacts, note(result.report);
    ledger_.linear.external += result.report.j_W;
    return true;
  }

  /// Whether a face lying on the plane can carry friction f (per unit of normal force) without tipping: the centre of
  /// pressure, the foot of the centre of mass moved by −height·f, stays inside the face.
  bool pressure_inside(std::size_t i, const State<double>& s, const Plane<double>& plane, const V& f) const {
    const V n = apply_transposed<double>(s.R_WB, plane.normal()), f_B = apply_transposed<double>(s.R_WB, f), half = shape(i).size() / 2;
    int axis = 0;
    for (int k = 1; k < 3; ++k)
      if (std::fabs(n[k]) > std::fabs(n[axis])) axis = k;
    for (int k = 0; k < 3; ++k)
      if (k != axis && half[axis] * std::fabs(f_B[k]) > half[k]) return false;
    return true;
  }

  /// Whether a corner at the plane neither leaves it nor bounces higher than smallest_bounce.
  bool persists(std::size_t i, const State<double>& s, const Plane<double>& plane, double& tail) const {
    const CornerGaps c = corner_gaps(shape(i), s, plane);
    bool any = false;
    for (int k = 0; k < 8; ++k) {
      if (c.gap[k] > 64 * c.rounding) continue;
      const double press = -dot<double>(plane.normal(), corner_acceleration(shape(i), s, k, gravity_)), leave = std::fmax(0, c.rate[k]);
      if (press > 0 && leave * leave <= 2 * press * smallest_bounce * size(i)) {
        any = true;
        const double e = scene_.surface.restitution();
        if (leave > 0 && e < 1) tail = std::fmax(tail, 2 * leave / (press * (1 - e)));
      }
    }
    return any;
  }

  /// A face flat on one plane without spin: slides or rests. False when it is not that.
  bool lie(std::size_t i, const Moment& now, State<double> s, int support) {
    const Plane<double>& plane = scene_.planes[std::size_t(support)];
    const CornerGaps c = corner_gaps(shape(i), s, plane);
    int touching = 0;
    for (int k = 0; k < 8; ++k) touching += c.gap[k] <= 64 * c.rounding;
    const double scale = norm<double>(s.v_WB) + std::sqrt(norm<double>(gravity_) * size(i));
    if (touching != 4 || norm<double>(s.w_WB) * size(i) > 1e-12 * scale) return false;
    const V n = plane.normal(), downhill = gravity_ - dot<double>(gravity_, n) * n;
    const double press = -dot<double>(gravity_, n), slope = norm<double>(downhill);
    const double leave = dot<double>(s.v_WB, n);
    s.w_WB = zero3<double>();
    s.v_WB -= leave * n;
    ledger_.linear.external -= shape(i).mass() * leave * n;  // of the bounces left out
    ledger_.energy.restitution_loss += shape(i).mass() * leave * leave / 2;
    const double speed = norm<double>(s.v_WB);
    const auto at_rest = [&] {
      s.v_WB = zero3<double>();
      fly(i, now, s, zero3<double>(), support, Body::Phase::resting, infinity);
      return true;
    };
    const double mu_s = scene_.surface.static_friction(), mu_d = scene_.surface.dynamic_friction();
    if (speed <= 16 * u * scale && slope <= mu_s * press * (1 + 4 * u)) return pressure_inside(i, s, plane, V(-downhill / press)) && at_rest();
    const V along = speed > 16 * u * scale ? V(s.v_WB / speed) : V(downhill / slope);
    const double pull = dot<double>(downhill, along), rate = pull - mu_d * press;
    if (norm<double>(V(downhill - pull * along)) > 1e-12 * press) return false;  // friction turns with the slip
    if (!pressure_inside(i, s, plane, V(-mu_d * along))) return false;
    if (speed <= 16 * u * scale && rate <= 0) return at_rest();  // mu_d > mu_s, which the sheet's law allows
    fly(i, now, s, V(rate * along), support, Body::Phase::sliding, rate < 0 ? -speed / rate : infinity);
    return true;
  }

  void fly(std::size_t i, const Moment& now, const State<double>& s, const V& a, int support, Body::Phase phase, double ends) {
    Body& b = bodies_[i];
    if (b.handed) {
      summary_.handed_over[b.reported].to = now.value();
      b.handed = false;
      --stepping_;
    }
    b.phase = phase;
    b.start = now;
    b.support = support;
    b.flight = std::make_unique<Flight>(shape(i), s, a);
    b.next = ends;
    b.tangled = false;
    const double horizon = now.until(scene_.until);
    for (std::size_t p = 0; p < scene_.planes.size(); ++p) {
      if (int(p) == support) continue;
      const PlaneContact found = next_plane_contact(shape(i), *b.flight, scene_.planes[p], 0, std::min(b.next, horizon));
      summary_.steps += found.advances;
      if (found.kind == PlaneContact::Kind::none || found.tau >= b.next) continue;
      b.next = found.tau;
      b.tangled = found.kind == PlaneContact::Kind::tangled;
    }
    search_partners(i);
  }

  // -- pairs

  const PairEvent& nearest_event(std::size_t i) const {
    static const PairEvent none;
    return nearest_[i] > i ? pairs_[i * bodies_.size() + nearest_[i]] : none;
  }
  /// Searches the meetings of body i with everyone, and who each row meets first.
  void search_partners(std::size_t i) {
    const std::size_t n = bodies_.size();
    for (std::size_t j = 0; j < n; ++j) {
      if (j == i) continue;
      const std::size_t low = std::min(i, j), high = std::max(i, j);
      pairs_[low * n + high] = search_pair(low, high);
    }
    for (std::size_t row = 0; row <= i; ++row) {
      if (row < i && nearest_[row] != i && !(pairs_[row * n + i].at.value() < nearest_event(row).at.value())) continue;
      nearest_[row] = row;
      for (std::size_t j = row + 1; j < n; ++j)
        if (pairs_[row * n + j].at.value() < nearest_event(row).at.value()) nearest_[row] = j;
    }
  }
  PairEvent search_pair(std::size_t i, std::size_t j) {
    const Body &a = bodies_[i], &b = bodies_[j];
    if (!a.flight || !b.flight || (a.phase == Body::Phase::resting && b.phase == Body::Phase::resting)) return {};
    const Moment base = a.start.since(b.start) > 0 ? a.start : b.start;
    const PairContact found = next_pair_contact(shape(i), *a.flight, base.since(a.start), shape(j), *b.flight, base.since(b.start), 0, base.until(scene_.until));
    summary_.steps += found.advances;
    if (found.kind == PairContact::Kind::none) return {};
    return {base.after(found.time), found.kind == PairContact::Kind::tangled};
  }

  /// Two cuboids touch now: the manifold's approaching points are hit at their mean, until none approaches.
  void meet(std::size_t i, std::size_t j) {
    const PairEvent event = pairs_[i * bodies_.size() + j];
    const Moment now = event.at;
    State<double> a = arrive(i, now.since(bodies_[i].start)), b = arrive(j, now.since(bodies_[j].start));
    LocatedImpact seen_a{i, now.value(), now.since(bodies_[i].start), bodies_[i].flight->start(), a, a}, seen_b{j, now.value(), now.since(bodies_[j].start), bodies_[j].flight->start(), b, b};
    const Separation apart = separation(shape(i), a, shape(j), b);
    const double smallest = std::min(shape(i).size().minCoeff(), shape(j).size().minCoeff());
    const char* trouble = event.tangled ? "two cuboids stay within rounding of each other" : apart.gap < -1e-9 * smallest ? "begins inside another cuboid" : nullptr;
    bool any = false;
    for (int round = 0; trouble == nullptr; ++round) {
      if (!hit_pair(i, a, j, b, apart, smallest)) break;
      any = true;
      if (round == 100) trouble = "impacts of one moment do not end";
    }
    if (!any && trouble == nullptr) trouble = "two cuboids touch and neither approach nor part";
    // bounces between two that have become too fast to follow: a persistent contact
    const double speed = norm<double>(V(a.v_WB - b.v_WB)) + norm<double>(a.w_WB) * size(i) + norm<double>(b.w_WB) * size(j) + std::sqrt(norm<double>(gravity_) * smallest);
    if (any && trouble == nullptr && (now.value() - last_meeting_at(i, j)) * speed < 1e-6 * smallest) trouble = "a persistent contact of two cuboids";
    last_meeting_[{i, j}] = now.value();
    if (trouble != nullptr) {
      hand_over(i, now, a, trouble);
      hand_over(j, now, b, trouble);
    } else {
      bodies_[j].flight.reset();  // no partner for the search of i until it has begun anew
      begin(i, now, a);
      begin(j, now, b);
    }
    if (!observe_impact_ || !any) return;
    seen_a.after = a, seen_b.after = b;
    observe_impact_(seen_a);
    observe_impact_(seen_b);
  }
  double last_meeting_at(std::size_t i, std::size_t j) const {
    const auto it = last_meeting_.find({i, j});
    return it == last_meeting_.end() ? -infinity : it->second;
  }
  bool hit_pair(std::size_t i, State<double>& a, std::size_t j, State<double>& b, const Separation& apart, double smallest) {
    // the manifold is that of the smallest overlap there is: B moved into A by 1e-10 of the smallest edge
    State<double> pushed = b;
    const double push = apart.gap + 1e-10 * smallest;
    pushed.p_WB -= push * apart.n_AB_W;
    const Manifold found = box_box(shape(i), a, shape(j), pushed);
    if (!found.touches()) return false;
    V point = zero3<double>();
    int count = 0;
    const double still = 16 * u * (norm<double>(a.v_WB) + norm<double>(b.v_WB) + norm<double>(a.w_WB) * size(i) + norm<double>(b.w_WB) * size(j));
    const auto velocity = [](const State<double>& s, const V& at) { return V(s.v_WB + cross<double>(s.w_WB, V(at - s.p_WB))); };
    for (int k = 0; k < found.count; ++k) {
      const V at = found.points[std::size_t(k)].p_WC + push / 2 * apart.n_AB_W;
      if (dot<double>(found.n_AB_W, V(velocity(b, at) - velocity(a, at))) < -still) point += at, ++count;
    }
    if (count == 0) return false;
    point /= count;
    Contact<double> contact;
    contact.n_AB_W = found.n_AB_W;
    contact.A = {shape(i).inverse_mass(), world_inverse_inertia<double>(a.R_WB, shape(i).inverse_inertia()), V(point - a.p_WB)};
    contact.B = {shape(j).inverse_mass(), world_inverse_inertia<double>(b.R_WB, shape(j).inverse_inertia()), V(point - b.p_WB)};
    const auto frictionless = *Surface<double>::make(scene_.surface.restitution(), 0, 0);
    const ImpactResult<double> result = resolve_impact<double>(contact, {{a.v_WB, a.w_WB}, {b.v_WB, b.w_WB}}, frictionless, scene_.friction_law);
    if (result.report.separating) return false;
    a.v_WB = result.after.A.v_WB, a.w_WB = result.after.A.w_WB;
    b.v_WB = result.after.B.v_WB, b.w_WB = result.after.B.w_WB;
    ++ledger_.pair_impacts, note(result.report);
    return true;
  }

  // -- the stepper, for persistent contacts

  void hand_over(std::size_t i, const Moment& now, const State<double>& s, const char* why) {
    Body& b = bodies_[i];
    b.phase = Body::Phase::stepping;
    b.start = now;
    b.support = -1;
    b.flight.reset();
    b.motion = motion_of(shape(i), s);
    b.calm = 0;
    b.next = infinity;
    if (!b.handed) {
      b.handed = true;
      b.reported = summary_.handed_over.size();
      summary_.handed_over.push_back({i, now.value(), infinity, why});
      ++stepping_;
    }
    search_partners(i);
  }
  /// Steps end at multiples of dt, so that all bodies in the stepper step together.
  double next_step() const {
    double t = infinity;
    for (const Body& b : bodies_)
      if (b.handed) t = std::min(t, (std::floor(b.start.value() / scene_.dt * (1 + 4 * u)) + 1) * scene_.dt);
    return t;
  }
  void step_all(double t) {
    std::vector<std::size_t> in;
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      if (bodies_[i].handed) in.push_back(i);
    std::vector<bool> met(bodies_.size(), false);
    for (const std::size_t i : in)
      for (const Plane<double>& plane : scene_.planes) met[i] = respond(i, plane) || met[i];
    for (const std::size_t i : in)
      for (const std::size_t j : in)
        if (i < j && push_apart(i, j)) met[i] = met[j] = true;
    for (const std::size_t i : in) {
      Body& b = bodies_[i];
      const double h = b.start.until(t);
      const V weight = shape(i).mass() * gravity_;
      b.motion = find_method("sheet")->step(shape(i), b.motion, {weight, zero3<double>()}, h);
      ledger_.linear.external += h * weight;
      b.start = Moment{t, 0};
      b.calm = met[i] ? 0 : b.calm + 1;
      ++summary_.steps;
    }
    // who flies into one of them joins them
    for (std::size_t j = 0; j < bodies_.size(); ++j) {
      if (!bodies_[j].flight) continue;
      const State<double> s = bodies_[j].flight->at(bodies_[j].start.until(t));
      for (const std::size_t i : in) {
        const State<double>& other = bodies_[i].motion.state;
        if (norm<double>(V(other.p_WB - s.p_WB)) > (size(i) + size(j)) / 2 || separation(shape(i), other, shape(j), s).gap > 0) continue;
        const State<double> there = arrive(j, bodies_[j].start.until(t));
        hand_over(j, Moment{t, 0}, there, "met a cuboid in the stepper");
        break;
      }
    }
    for (const std::size_t i : in)
      if (bodies_[i].calm >= calm_steps && clear(i)) begin(i, bodies_[i].start, bodies_[i].motion.state);
  }
  /// Not inside a plane or a body that flies: only then can it fly itself.
  bool clear(std::size_t i) const {
    const State<double>& s = bodies_[i].motion.state;
    for (std::size_t j = 0; j < bodies_.size(); ++j) {
      if (j == i) continue;
      const State<double> other = state_at(bodies_[j], bodies_[i].start.value());
      if (norm<double>(V(other.p_WB - s.p_WB)) <= (size(i) + size(j)) / 2 && separation(shape(i), s, shape(j), other).gap <= 0) return false;
    }
    return true;
  }
  bool respond(std::size_t i, const Plane<double>& plane) {
    Body& b = bodies_[i];
    const V weight = shape(i).mass() * gravity_;
    const PlaneResponse<double> response = respond_to_plane<double>(shape(i), b.motion.state, plane, scene_.surface, scene_.friction_law, weight);
    if (response.corners == 0) return false;
    moved(i, response.shift);
    ledger_.linear.external += shape(i).mass() * (response.after.v_WB - b.motion.state.v_WB);
    for (const ImpactReport<double>& report : response.reports)
      if (!report.separating) ++ledger_.plane_impacts, note(report);
    b.motion = motion_of(shape(i), response.after);
    return true;
  }
  bool push_apart(std::size_t i, std::size_t j) {
    State<double> a = bodies_[i].motion.state, b = bodies_[j].motion.state;
    if (norm<double>(V(b.p_WB - a.p_WB)) > (size(i) + size(j)) / 2) return false;
    const Manifold found = box_box(shape(i), a, shape(j), b);
    if (!found.touches()) return false;
    const V point = found.centroid(), shift = found.depth / 2 * found.n_AB_W;
    Contact<double> contact;
    contact.n_AB_W = found.n_AB_W;
    a.p_WB -= shift, b.p_WB += shift;
    moved(i, V(-shift)), moved(j, shift);
    contact.A = {shape(i).inverse_mass(), world_inverse_inertia<double>(a.R_WB, shape(i).inverse_inertia()), V(point - a.p_WB)};
    contact.B = {shape(j).inverse_mass(), world_inverse_inertia<double>(b.R_WB, shape(j).inverse_inertia()), V(point - b.p_WB)};
    const auto frictionless = *Surface<double>::make(scene_.surface.restitution(), 0, 0);
    const ImpactResult<double> result = resolve_impact<double>(contact, {{a.v_WB, a.w_WB}, {b.v_WB, b.w_WB}}, frictionless, scene_.friction_law);
    if (!result.report.separating) {
      ++ledger_.pair_impacts, note(result.report);
      a.v_WB = result.after.A.v_WB, a.w_WB = result.after.A.w_WB;
      b.v_WB = result.after.B.v_WB, b.w_WB = result.after.B.w_WB;
    }
    bodies_[i].motion = motion_of(shape(i), a);
    bodies_[j].motion = motion_of(shape(j), b);
    return true;
  }
  void moved(std::size_t i, const V& shift) {
    ledger_.energy.correction -= shape(i).mass() * dot<double>(gravity_, shift);
    ledger_.deepest_penetration = std::fmax(ledger_.deepest_penetration, norm<double>(shift));
  }
  void note(const ImpactReport<double>& report) {
    if (++ledger_.impacts >= most_impacts) summary_.stopped = "ten million impacts";
    ledger_.energy.restitution_loss += report.restitution_loss;
    ledger_.energy.friction_loss += report.friction_loss;
    ledger_.energy_rises += report.energy_rose;
  }

  const Scene& scene_;
  RunSummary& summary_;
  const LocatedObserver& observe_impact_;
  Ledger& ledger_;
  V gravity_;
  std::vector<Body> bodies_;
  std::vector<PairEvent> pairs_;      // row i, column j > i
  std::vector<std::size_t> nearest_;  // whom row i meets first; itself: nobody
  std::map<std::pair<std::size_t, std::size_t>, double> last_meeting_;
  std::size_t stepping_ = 0, next_action_ = 0;
};

}  // namespace

Outcome<RunSummary> simulate_located(const Scene& scene, const Observer& observe, const LocatedObserver& observe_impact) {
  using Kind = Fault::Kind;
  if (!scene.forces.empty()) return Fault{Kind::unsupported, "forces", "are not known to method 'located' (gravity is); use a stepper"};
  for (const SceneAction& action : scene.actions)
    if (action.what == SceneAction::Do::vacuum_on) return Fault{Kind::unsupported, "actions", "vacuum-on is not known to method 'located'; use a stepper"};

  RunSummary summary;
  for (const SceneBody& b : scene.bodies) summary.ledger.linear.start += b.shape.mass() * b.start.v_WB;
  LocatedWorld world(scene, summary, observe_impact);
  const double every = scene.every > 0 ? scene.every : 1.0 / 60;
  long row = 0;
  double t_end = scene.until;
  for (;;) {
    const double next = world.next_time();
    for (; std::min(double(row) * every, scene.until) < next && double(row) * every < scene.until; ++row) observe(double(row) * every, world.states(double(row) * every));
    if (next > scene.until) break;
    summary.interrupted = interrupted() != 0;
    if (summary.interrupted || !summary.stopped.empty()) {
      t_end = next;
      break;
    }
    world.advance();
  }
  summary.t_end = t_end;
  observe(t_end, world.states(t_end));
  world.finish(t_end);
  return summary;
}

}  // namespace rigor
