#include <algorithm>
#include <cmath>
#include <functional>
#include <rigor/base/interrupt.hpp>
#include <rigor/engine/located_world.hpp>
#include <rigor/formulas/gram_schmidt.hpp>
#include <rigor/linalg/rotation.hpp>

namespace rigor {

using V = Vec3<double>;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

LocatedWorld::LocatedWorld(const Scene& scene, RunSummary& summary, const LocatedObserver& observe_impact, const Skips& skips)
    : scene_(scene), summary_(summary), observe_impact_(observe_impact), ledger_(summary.ledger), gravity_(scene.gravity), skips_(skips),
      bodies_(scene.bodies.size()), boxes_(scene.bodies.size()), partners_(scene.bodies.size()), known_(scene.bodies.size(), false), met_(scene.bodies.size(), false) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const SceneBody& b = scene.bodies[i];
    energy_.start += energy(i, b.start);
    linear_.start += b.shape.mass() * b.start.v_WB;
    angular_.start += angular(i, b.start);
    bodies_[i].stride = size(i);
  }
  for (Partners& p : partners_) p.known.reserve(32);
  events_.reserve(16 * bodies_.size() + 128);
  for (std::size_t i = 0; i < bodies_.size(); ++i) begin(i, Moment{}, scene.bodies[i].start);
}

double LocatedWorld::next_time() {
  for (;;) {
    watch_step();
    double t = next_action_ < scene_.actions.size() ? scene_.actions[next_action_].at : infinity;
    t = std::min(t, next_step_);
    while (!events_.empty() && is_void(events_.front())) std::pop_heap(events_.begin(), events_.end(), std::greater<>{}), events_.pop_back();
    if (events_.empty()) return t;
    const Event& first = events_.front();
    t = std::min(t, first.at.value());
    if (first.kind != Event::Kind::look || first.at.value() > t) return t;
    const std::size_t i = first.i;
    std::pop_heap(events_.begin(), events_.end(), std::greater<>{}), events_.pop_back();
    look(i);
  }
}

void LocatedWorld::advance() {
  const double t = now_ = next_time();
  if (next_action_ < scene_.actions.size() && scene_.actions[next_action_].at <= t) return act(scene_.actions[next_action_++]);
  if (events_.empty() || events_.front().at.value() > t) return step_all(t);
  const Event event = events_.front();
  std::pop_heap(events_.begin(), events_.end(), std::greater<>{}), events_.pop_back();
  if (event.kind == Event::Kind::own) happen(event.i);
  else meet(event);
}

void LocatedWorld::push(const Event& event) {
  if (events_.size() > 2 * events_kept_ + 64) {
    std::erase_if(events_, [&](const Event& e) { return is_void(e); });
    std::make_heap(events_.begin(), events_.end(), std::greater<>{});
    events_kept_ = events_.size();
  }
  events_.push_back(event);
  std::push_heap(events_.begin(), events_.end(), std::greater<>{});
}

bool LocatedWorld::is_void(const Event& event) const {
  return bodies_[event.i].flights != event.flight_i || bodies_[event.j].flights != event.flight_j;
}

const std::vector<State<double>>& LocatedWorld::states(double t) {
  shown_.clear();
  for (const LocatedBody& b : bodies_) shown_.push_back(state_at(b, t));
  return shown_;
}

void LocatedWorld::finish(double t) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const State<double> s = state_at(bodies_[i], t);
    if (bodies_[i].flight) account(i, bodies_[i].start.until(t));
    energy_.end += energy(i, s);
    linear_.end += scene_.bodies[i].shape.mass() * s.v_WB;
    angular_.end += angular(i, s);
    ledger_.worst_orthonormality = std::fmax(ledger_.worst_orthonormality, orthonormality_defect<double>(s.R_WB));
    if (bodies_[i].phase == LocatedBody::Phase::stepping) summary_.handed_over[bodies_[i].reported].to = t;
  }
  // what is left over is summed as carefully as what it is left of
  Carried<double> left;
  const auto give = [&](double& account, const Carried<double>& sum, double sign) {
    account = sum.value();
    left += sign * sum.sum, left += sign * sum.carry;
  };
  Ledger::Energy& e = ledger_.energy;
  give(e.end, energy_.end, 1), give(e.start, energy_.start, -1), give(e.correction, energy_.correction, -1), give(e.switched, energy_.switched, -1);
  give(e.restitution_loss, energy_.restitution_loss, 1), give(e.friction_loss, energy_.friction_loss, 1);
  e.worst_drift = std::fabs(left.value());
  for (const auto& [account, sums] : {std::pair(&ledger_.linear, &linear_), std::pair(&ledger_.angular, &angular_)}) {
    account->start = sums->start.value(), account->external = sums->external.value(), account->end = sums->end.value();
    Carried<V> drift;
    for (const V& term : {sums->end.sum, sums->end.carry}) drift += term;
    for (const V& term : {sums->start.sum, sums->start.carry, sums->external.sum, sums->external.carry}) drift -= term;
    account->worst_drift = norm<double>(drift.value());
  }
}

State<double> LocatedWorld::state_at(const LocatedBody& b, double t) {
  return b.flight ? b.flight->at(std::max(0.0, b.start.until(t))) : b.state;
}

double LocatedWorld::energy(std::size_t i, const State<double>& s) const {
  const V w_B = apply_transposed<double>(s.R_WB, s.w_WB);
  return (shape(i).mass() * dot<double>(s.v_WB, s.v_WB) + dot<double>(w_B, V(w_B.cwiseProduct(shape(i).inertia())))) / 2 -
         shape(i).mass() * dot<double>(gravity_, s.p_WB);
}

V LocatedWorld::angular(std::size_t i, const State<double>& s) const {
  return cross<double>(s.p_WB, V(shape(i).mass() * s.v_WB)) + motion_of(shape(i), s).L_W;
}

void LocatedWorld::account(std::size_t i, double tau) {
  const Flight& f = *bodies_[i].flight;
  const V moved = tau * f.start().v_WB + tau * tau / 2 * f.acceleration();
  linear_.external += shape(i).mass() * tau * f.acceleration();
  angular_.external += shape(i).mass() * cross<double>(V(tau * f.start().p_WB + tau * tau / 2 * f.start().v_WB), f.acceleration());
  if (bodies_[i].support >= 0) energy_.friction_loss -= shape(i).mass() * dot<double>(V(f.acceleration() - gravity_), moved);
}

void LocatedWorld::act(const SceneAction& action) {
  const V before = gravity_;
  gravity_ = action.what == SceneAction::Do::gravity_on ? scene_.gravity : zero3<double>();
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    energy_.switched += shape(i).mass() * dot<double>(V(before - gravity_), state_at(bodies_[i], action.at).p_WB);
    if (!bodies_[i].flight) continue;
    const double tau = bodies_[i].start.until(action.at);
    const V now = gravity_;
    gravity_ = before;
    const State<double> s = arrive(i, tau);
    gravity_ = now;
    begin(i, bodies_[i].start.after(tau), s);
  }
  next_step_ = whole_step_;
  unwatched_.insert(unwatched_.end(), stepping_.begin(), stepping_.end());
}

void LocatedWorld::happen(std::size_t i) {
  LocatedBody& b = bodies_[i];
  const Moment now = b.start.after(b.next);
  const State<double> s = arrive(i, b.next);
  if (b.trouble != nullptr) return hand_over(i, now, s, b.trouble);
  LocatedImpact seen{i, now.value(), b.next, b.flight->start(), s, s};
  const long impacts = ledger_.impacts;
  begin(i, now, s);
  if (!observe_impact_ || ledger_.impacts == impacts) return;
  seen.after = bodies_[i].flight ? bodies_[i].flight->start() : bodies_[i].state;
  observe_impact_(seen);
}

State<double> LocatedWorld::arrive(std::size_t i, double tau) {
  State<double> s = bodies_[i].flight->at(tau);
  account(i, tau);
  bodies_[i].rounding = std::fmax(bodies_[i].rounding, bodies_[i].flight->rounding(tau));
  if (bodies_[i].flight->spin_bound() > 0) s.R_WB = gram_schmidt<double>(s.R_WB);
  return s;
}

Outcome<RunSummary> simulate_located(const Scene& scene, const Observer& observe, const LocatedObserver& observe_impact, const Skips& skips) {
  using Kind = Fault::Kind;
  if (!scene.forces.empty()) return Fault{Kind::unsupported, "forces", "are not known to method 'located' (gravity is); use a stepper"};
  for (const SceneAction& action : scene.actions)
    if (action.what == SceneAction::Do::vacuum_on) return Fault{Kind::unsupported, "actions", "vacuum-on is not known to method 'located'; use a stepper"};

  RunSummary summary;
  LocatedWorld world(scene, summary, observe_impact, skips);
  const double every = output_interval(scene);
  const auto show = [&](double t) {
    const std::vector<State<double>>& states = world.states(t);
    summary.finite = summary.finite && std::all_of(states.begin(), states.end(), is_finite);
    if (summary.finite) observe(t, states);
  };
  const auto ends_early = [&] {
    summary.interrupted = interrupted() != 0;
    return summary.interrupted || !summary.stopped.empty() || !summary.finite;
  };
  long row = 0;
  for (;;) {
    const double next = world.next_time(), end = std::min(next, scene.until);
    for (; !ends_early() && double(row) * every < end; ++row) show(double(row) * every);
    summary.t_end = ends_early() ? std::min(end, double(row) * every) : scene.until;
    if (ends_early() || next > scene.until) break;
    world.advance();
  }
  show(summary.t_end);
  world.finish(summary.t_end);
  return summary;
}

}  // namespace rigor
