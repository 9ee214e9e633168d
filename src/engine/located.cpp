#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <rigor/base/interrupt.hpp>
#include <rigor/base/promise.hpp>
#include <rigor/contact/plane_response.hpp>
#include <rigor/engine/located.hpp>
#include <rigor/engine/plane_search.hpp>
#include <rigor/formulas/angular_acceleration.hpp>
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
};

struct Body {
  enum class Phase { flying, sliding, resting, stepping };
  Phase phase = Phase::flying;
  Moment start;
  std::unique_ptr<Flight> flight;  // of every phase but stepping; without spin and with its own acceleration on a plane
  int support = -1;                // the plane it slides or rests on
  double next = infinity;          // s after start: when something happens
  bool tangled = false;            // and no impact can be named then
  Motion motion;                   // stepping
  long steps = 0;
  int calm = 0;
};

class LocatedWorld {
 public:
  LocatedWorld(const Scene& scene, RunSummary& summary, const ImpactObserver& observe_impact)
      : scene_(scene), summary_(summary), observe_impact_(observe_impact), ledger_(summary.ledger), gravity_(scene.gravity) {
    for (const SceneBody& b : scene.bodies) {
      bodies_.emplace_back();
      ledger_.energy.start += energy(bodies_.size() - 1, b.start);
    }
    for (std::size_t i = 0; i < bodies_.size(); ++i) begin(i, Moment{}, scene.bodies[i].start);
  }

  /// Time of the next thing that happens.
  double next_time() const {
    double t = infinity;
    for (const Body& b : bodies_) t = std::min(t, b.start.after(b.next).value());
    return next_action_ < scene_.actions.size() ? std::min(t, scene_.actions[next_action_].at) : t;
  }
  /// Does what happens next: an action, or one body's event.
  void advance() {
    std::size_t first = 0;
    double t = infinity;
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      if (const double mine = bodies_[i].start.after(bodies_[i].next).value(); mine < t) t = mine, first = i;
    if (next_action_ < scene_.actions.size() && scene_.actions[next_action_].at <= t) act(scene_.actions[next_action_++]);
    else happen(first);
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
      if (bodies_[i].phase == Body::Phase::stepping) summary_.handed_over.back().to = t;
      for (HandOver& h : summary_.handed_over)
        if (h.body == i && std::isinf(h.to)) h.to = t;
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
    if (b.phase == Body::Phase::stepping) return step(i);
    State<double> s = b.flight->at(b.next);
    account(i, b.next);
    const Moment now = b.start.after(b.next);
    if (b.flight->spin_bound() > 0) s.R_WB = gram_schmidt<double>(s.R_WB);
    if (b.phase == Body::Phase::sliding && !b.tangled && dot<double>(s.v_WB, b.flight->start().v_WB) <= 0) s.v_WB = zero3<double>();
    if (b.tangled) return hand_over(i, now, s, "a corner follows the plane within rounding");
    LocatedImpact seen{i, now.value(), b.next, b.flight->start(), s, s};
    const long impacts = ledger_.impacts;
    begin(i, now, s);
    if (!observe_impact_ || ledger_.impacts == impacts) return;
    seen.after = bodies_[i].flight ? bodies_[i].flight->start() : bodies_[i].motion.state;
    observe_impact_(seen);
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
    if (tail > 0) summary_.accumulations.push_back({i, now.value(), tail});
    if (!lie(i, now, s, support)) hand_over(i, now, s, "a persistent contact that is no face lying flat without spin");
  }

  /// One impact on a plane, if any of the corners at it approaches.
  bool hit(std::size_t i, State<double>& s, const Plane<double>& plane) {
    const CornerGaps c = corner_gaps(shape(i), s, plane);
    const double still = 16 * u * (norm<double>(s.v_WB) + norm<double>(s.w_WB) * size(i));
    V arm = zero3<double>();
    int count = 0;
    for (int k = 0; k < 8; ++k)
      if (c.gap[k] <= 64 * c.rounding && c.rate[k] < -still) arm += apply<double>(s.R_WB, shape(i).corner(k)), ++count;
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
    ++ledger_.impacts, ++ledger_.plane_impacts;
    ledger_.energy.restitution_loss += result.report.restitution_loss;
    ledger_.energy.friction_loss += result.report.friction_loss;
    ledger_.energy_rises += result.report.energy_rose;
    ledger_.linear.external += result.report.j_W;
    if (ledger_.impacts >= most_impacts) summary_.stopped = "ten million impacts";
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
    const Mat3<double> I = world_inertia<double>(s.R_WB, shape(i).inertia()), inverse_I = world_inverse_inertia<double>(s.R_WB, shape(i).inverse_inertia());
    const V alpha = angular_acceleration<double>(I, inverse_I, s.w_WB, zero3<double>());
    bool any = false;
    for (int k = 0; k < 8; ++k) {
      if (c.gap[k] > 64 * c.rounding) continue;
      const V r = apply<double>(s.R_WB, shape(i).corner(k));
      const V a = gravity_ + cross<double>(alpha, r) + cross<double>(s.w_WB, cross<double>(s.w_WB, r));
      const double press = -dot<double>(plane.normal(), a), leave = std::fmax(0, c.rate[k]);
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
    s.w_WB = zero3<double>();
    s.v_WB -= dot<double>(s.v_WB, n) * n;
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
  }

  void hand_over(std::size_t i, const Moment& now, const State<double>& s, const char* why) {
    Body& b = bodies_[i];
    b.phase = Body::Phase::stepping;
    b.start = now;
    b.support = -1;
    b.flight.reset();
    b.motion = motion_of(shape(i), s);
    b.steps = 0;
    b.calm = 0;
    b.next = scene_.dt;
    summary_.handed_over.push_back({i, now.value(), infinity, why});
  }
  void step(std::size_t i) {
    Body& b = bodies_[i];
    const V weight = shape(i).mass() * gravity_;
    bool met = false;
    for (const Plane<double>& plane : scene_.planes) {
      const PlaneResponse<double> response = respond_to_plane<double>(shape(i), b.motion.state, plane, scene_.surface, scene_.friction_law, weight);
      if (response.corners == 0) continue;
      met = true;
      ledger_.energy.correction -= dot<double>(weight, response.shift);
      ledger_.deepest_penetration = std::fmax(ledger_.deepest_penetration, norm<double>(response.shift));
      ledger_.linear.external += shape(i).mass() * (response.after.v_WB - b.motion.state.v_WB);
      for (const ImpactReport<double>& report : response.reports) {
        if (report.separating) continue;
        ++ledger_.impacts, ++ledger_.plane_impacts;
        ledger_.energy.restitution_loss += report.restitution_loss;
        ledger_.energy.friction_loss += report.friction_loss;
        ledger_.energy_rises += report.energy_rose;
      }
      b.motion = motion_of(shape(i), response.after);
    }
    b.motion = find_method("sheet")->step(shape(i), b.motion, {weight, zero3<double>()}, scene_.dt);
    ledger_.linear.external += scene_.dt * weight;
    ++b.steps;
    ++summary_.steps;
    b.calm = met ? 0 : b.calm + 1;
    const Moment now = b.start.after(double(b.steps) * scene_.dt);
    if (b.calm < calm_steps) {
      b.next = double(b.steps + 1) * scene_.dt;
      return;
    }
    for (HandOver& h : summary_.handed_over)
      if (h.body == i && std::isinf(h.to)) h.to = now.value();
    begin(i, now, b.motion.state);
  }

  const Scene& scene_;
  RunSummary& summary_;
  const ImpactObserver& observe_impact_;
  Ledger& ledger_;
  V gravity_;
  std::vector<Body> bodies_;
  std::size_t next_action_ = 0;
};

}  // namespace

Outcome<RunSummary> simulate_located(const Scene& scene, const Observer& observe, const ImpactObserver& observe_impact) {
  using Kind = Fault::Kind;
  if (!scene.forces.empty()) return Fault{Kind::unsupported, "forces", "are not known to method 'located' (gravity is); use a stepper"};
  for (const SceneAction& action : scene.actions)
    if (action.what == SceneAction::Do::vacuum_on) return Fault{Kind::unsupported, "actions", "vacuum-on is not known to method 'located'; use a stepper"};
  if (scene.bodies.size() > 1) return Fault{Kind::unsupported, "cuboids", "are " + std::to_string(scene.bodies.size()) + ", method 'located' finds impacts of one cuboid with planes"};

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
