#include <algorithm>
#include <cmath>
#include <limits>
#include <rigor/base/promise.hpp>
#include <rigor/collision/box_box.hpp>
#include <rigor/collision/handed_out_pair.hpp>
#include <rigor/contact/plane_response.hpp>
#include <rigor/formulas/momentum.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/scene/random.hpp>
#include <rigor/scene/world.hpp>

namespace rigor {

using V = Vec3<double>;

World::World(Scene scene, ImpactObserver on_impact)
    : scene_(std::move(scene)), on_impact_(std::move(on_impact)), method_(find_method(scene_.method)), random_(scene_.seed) {
  promise(method_ != nullptr, "a checked scene names a method");
  for (const SceneBody& b : scene_.bodies) motions_.push_back(motion_of(b.shape, b.start));
  for (const SceneBody& b : scene_.bodies) reach_.push_back(norm<double>(b.shape.size()) / 2 + 0.01);
  if (!reach_.empty()) margin_ = *std::max_element(reach_.begin(), reach_.end()) / 4;
  loads_.resize(motions_.size());
  still_.assign(motions_.size(), false);
  vacuum_.assign(motions_.size(), Wrench<double>{});
  gravity_ = scene_.gravity;
  ledger_.energy.start = ledger_.energy.end = energy();
  ledger_.linear.start = ledger_.linear.end = linear();
  ledger_.angular.start = ledger_.angular.end = angular();
}

void World::step(double t, double h) {
  act(t);
  sum_forces(t);
  for (std::size_t i = 0; i < motions_.size(); ++i)
    for (const Plane<double>& plane : scene_.planes) against_plane(i, plane);
  pairs();
  for (std::size_t i = 0; i < motions_.size(); ++i) advance(i, h);
  ++ledger_.skips.monitors_of;
  if (skips_.monitors) ++ledger_.skips.monitors;
  else audit();
}

const std::vector<State<double>>& World::states() const {
  shown_.clear();
  for (const Motion& m : motions_) shown_.push_back(m.state);
  return shown_;
}
bool World::finite() const {
  for (const Motion& m : motions_)
    if (!is_finite(m.state)) return false;
  return true;
}
// Key presses whose time has come.
void World::act(double t) {
  for (; next_action_ < scene_.actions.size() && scene_.actions[next_action_].at <= t; ++next_action_) press(scene_.actions[next_action_].what);
}
void World::press(SceneAction::Do what) {
  const double before = potential();
  steady_ = false;
  switch (what) {
    case SceneAction::Do::gravity_on: gravity_ = scene_.gravity, gravity_on_ = true; break;
    case SceneAction::Do::gravity_off: gravity_ = zero3<double>(), gravity_on_ = false; break;
    case SceneAction::Do::vacuum_off: vacuum_.assign(motions_.size(), Wrench<double>{}), vacuum_on_ = false; break;
    case SceneAction::Do::vacuum_on: start_vacuum(), vacuum_on_ = true; break;
  }
  ledger_.energy.switched += potential() - before;
}
void World::set_method(const std::string& name) {
  const Method* found = find_method(name);
  promise(found != nullptr, "a method is set by one of its names");
  method_ = found;
  still_.assign(motions_.size(), false);
  scene_.method = name;
}
// A constant pull towards the mean of the centres, upwards in y, at a small fixed offset: assignment/interface.md.
void World::start_vacuum() {
  V mean = zero3<double>();
  for (const Motion& m : motions_) mean += m.state.p_WB / double(motions_.size());
  for (std::size_t i = 0; i < motions_.size(); ++i) {
    const V to = mean - motions_[i].state.p_WB;
    const double length = norm<double>(to), pull = 10 * shape(i).mass();
    V force = length > 0 ? V(pull / length * to) : zero3<double>();
    force[1] = pull;
    vacuum_[i] = add_force<double>({}, V(0.1 * upward_direction(random_)), force);
  }
}
void World::sum_forces(double t) {
  ledger_.skips.loads_of += long(motions_.size());
  if (skips_.loads && steady_) {
    ledger_.skips.loads += long(motions_.size());
    return;
  }
  steady_ = scene_.forces.empty() && !hand_;
  still_.assign(motions_.size(), false);
  for (std::size_t i = 0; i < motions_.size(); ++i) {
    Wrench<double> sum = add_force<double>({}, zero3<double>(), V(shape(i).mass() * gravity_));
    loads_[i] = {V(sum.f_W + vacuum_[i].f_W), V(sum.tau_W + vacuum_[i].tau_W)};
  }
  for (const SceneForce& f : scene_.forces) {
    if (!(f.from <= t && t < f.to)) continue;
    const std::size_t i = std::size_t(f.body);
    const V arm = f.at_turns ? apply<double>(motions_[i].state.R_WB, f.at) : f.at;
    add_load(i, arm, f.force);
  }
  if (hand_) {
    const State<double>& s = motions_[hand_->body].state;
    const double m = shape(hand_->body).mass(), stiffness = 30 * m;
    const V arm = apply<double>(s.R_WB, hand_->at_B), v_WC = s.v_WB + cross<double>(s.w_WB, arm);
    add_load(hand_->body, arm, V(stiffness * (hand_->to_W - s.p_WB - arm) - 2 * std::sqrt(stiffness * m) * v_WC));
  }
}
void World::add_load(std::size_t i, const V& arm, const V& force) {
  const Wrench<double> sum = add_force<double>({loads_[i].f_W, loads_[i].tau_W}, arm, force);
  loads_[i] = {sum.f_W, sum.tau_W};
}

void World::note(int A, std::size_t B, const V& p_WC, const ImpactReport<double>& report) {
  if (on_impact_) on_impact_({A, int(B), p_WC, report.j_W});
  ++ledger_.impacts;
  ledger_.energy.restitution_loss += report.restitution_loss;
  ledger_.energy.friction_loss += report.friction_loss;
  ledger_.energy_rises += report.energy_rose;
}
void World::move(std::size_t i, const V& shift) {
  State<double>& s = motions_[i].state;
  ledger_.energy.correction -= shape(i).mass() * dot<double>(gravity_, shift);
  ledger_.angular.external += cross<double>(shift, V(shape(i).mass() * s.v_WB));
  s.p_WB += shift;
  still_[i] = false;  // nothing is hit without being moved first
  if (i < shifted_.size()) worst_shift_ = std::fmax(worst_shift_, shifted_[i] += norm<double>(shift));
}
// Contact laws know the state alone. A method that carries an L beside a spin not quite of it (euler-momentum) loses the difference.
void World::keep_state_alone(std::size_t i) {
  const Motion kept = motion_of(shape(i), motions_[i].state);
  const V lost = motions_[i].L_W - kept.L_W;
  ledger_.energy.stepper -= dot<double>(kept.state.w_WB, lost) / 2;
  ledger_.angular.stepper -= lost;
  motions_[i] = kept;
}
void World::against_plane(std::size_t i, const Plane<double>& plane) {
  const State<double> before = motions_[i].state;
  ++ledger_.skips.planes_of;
  if (skips_.planes && plane.gap(before.p_WB) > norm<double>(shape(i).size()) / 2 * 1.000001) {  // no corner reaches it
    ++ledger_.skips.planes;
    return;
  }
  const PlaneResponse<double> response = respond_to_plane<double>(shape(i), before, plane, scene_.surface, scene_.friction_law, loads_[i].f_W);
  if (response.corners == 0) return;
  ledger_.deepest_penetration = std::fmax(ledger_.deepest_penetration, norm<double>(response.shift));
  keep_state_alone(i);
  const V L_before = motions_[i].L_W;
  move(i, response.shift);
  State<double>& s = motions_[i].state;
  s.p_WB = response.after.p_WB;
  s.v_WB = response.after.v_WB;
  s.w_WB = response.after.w_WB;
  for (int k = 0; k < 8; ++k)
    if (const ImpactReport<double>& report = response.reports[k]; !report.separating)
      note(-1, i, V(s.p_WB + apply<double>(s.R_WB, shape(i).corner(k))), report), ++ledger_.plane_impacts;
  const V push = shape(i).mass() * (s.v_WB - before.v_WB);
  ledger_.linear.external += push;
  motions_[i] = motion_of(shape(i), s);
  ledger_.angular.external += cross<double>(s.p_WB, push) + motions_[i].L_W - L_before;
}
// Every pair i < j in order; those far apart are left out. Who is near was found with a margin to spare: it is found anew when
// somebody has gone half of what two may share of it. Position corrections may bring bodies nearer while the pairs are gone
// through; where the margin does not suffice the rest of the step looks at everybody.
void World::pairs() {
  const std::size_t n = motions_.size();
  ledger_.skips.pairs_of += long(n) * (long(n) - 1) / 2;
  std::size_t i = 0, j = 0;
  if (skips_.pairs) {
    double gone = strayed();
    if (!(4 * gone <= margin_)) {
      seen_at_.clear();
      for (const Motion& m : motions_) seen_at_.push_back(m.state.p_WB);
      near_.find(seen_at_, reach_, margin_);
      gone = 0;
    }
    shifted_.assign(n, 0);
    worst_shift_ = 0;
    const NearPairs::Pairs& near = near_.found();
    std::size_t looked = 0;
    for (; looked < near.size() && 2 * (gone + worst_shift_) <= margin_; ++looked) {
      i = near[looked].first, j = near[looked].second;
      against_each_other(i, j);
    }
    if (2 * (gone + worst_shift_) <= margin_) {
      ledger_.skips.pairs += long(n) * (long(n) - 1) / 2 - long(near.size());
      return;
    }
  }
  for (; i < n; ++i, j = i)
    for (j = j < i ? i + 1 : j + 1; j < n; ++j) against_each_other(i, j);
}
// How far anybody is from where he was when near_ was found, m; NaN where nothing was found yet or a centre is no number.
double World::strayed() const {
  if (seen_at_.empty()) return std::numeric_limits<double>::quiet_NaN();
  double farthest = 0;
  for (std::size_t i = 0; i < motions_.size(); ++i) {
    const V d = motions_[i].state.p_WB - seen_at_[i];
    const double squared = dot<double>(d, d);
    farthest = squared > farthest || squared != squared ? squared : farthest;
    if (farthest != farthest) break;
  }
  return std::sqrt(farthest);
}
void World::against_each_other(std::size_t i, std::size_t j) {
  const State<double>&a = motions_[i].state, &b = motions_[j].state;
  const double reach = reach_[i] + reach_[j];
  const V between = b.p_WB - a.p_WB;
  if (dot<double>(between, between) > reach * reach) return;
  V point, n;
  double depth;
  if (scene_.pair_detection == PairDetection::handed_out) {
    const auto found = handed_out_pair(shape(i), a, shape(j), b);
    if (!found) return;
    point = found->p_WC, n = found->n_AB_W, depth = found->depth;
  } else {
    const Manifold found = box_box(shape(i), a, shape(j), b);
    if (!found.touches()) return;
    point = found.centroid(), n = found.n_AB_W, depth = found.depth;
  }
  ledger_.deepest_penetration = std::fmax(ledger_.deepest_penetration, depth);
  move(i, V(-depth / 2 * n));
  move(j, V(depth / 2 * n));
  Contact<double> contact;
  contact.n_AB_W = n;
  for (auto [side, k] : {std::pair{&contact.A, i}, std::pair{&contact.B, j}})
    *side = {shape(k).inverse_mass(), world_inverse_inertia<double>(motions_[k].state.R_WB, shape(k).inverse_inertia()), V(point - motions_[k].state.p_WB)};
  const auto frictionless = *Surface<double>::make(scene_.surface.restitution(), 0, 0);
  const ImpactResult<double> result = resolve_impact<double>(contact, {{a.v_WB, a.w_WB}, {b.v_WB, b.w_WB}}, frictionless, scene_.friction_law);
  if (result.report.separating) return;
  keep_state_alone(i), keep_state_alone(j);
  note(int(i), j, point, result.report), ++ledger_.pair_impacts;
  for (auto [k, after] : {std::pair{i, result.after.A}, std::pair{j, result.after.B}}) {
    State<double> s = motions_[k].state;
    s.v_WB = after.v_WB;
    s.w_WB = after.w_WB;
    motions_[k] = motion_of(shape(k), s);
  }
}
void World::advance(std::size_t i, double h) {
  ++ledger_.skips.rest_of;
  if (skips_.rest && still_[i]) {
    ++ledger_.skips.rest;
    return;
  }
  const Load& load = loads_[i];
  const Motion moving = motions_[i];
  const State<double>& before = moving.state;
  motions_[i] = method_->step(shape(i), moving, load, h);
  const State<double>& after = motions_[i].state;
  if (!skips_.monitors) account(i, moving, h);
  // A step is a map of motion and load, and of h times rates: where those are zeros and it changed no bit, it never will; nor will its accounts.
  const auto zero = [](const V& x) { return x[0] == 0 && x[1] == 0 && x[2] == 0; };
  still_[i] = zero(after.v_WB) && zero(after.w_WB) && zero(load.f_W) && zero(load.tau_W) && zero(before.v_WB) && zero(before.w_WB) && after.p_WB == before.p_WB && after.R_WB == before.R_WB;
}
// What the step from `moving` to where body i is now gave and took.
void World::account(std::size_t i, const Motion& moving, double h) {
  const State<double>&before = moving.state, &after = motions_[i].state;
  const Load& load = loads_[i];
  const V weight = shape(i).mass() * gravity_, moved = after.p_WB - before.p_WB;
  const V moment = h * (cross<double>(before.p_WB, load.f_W) + load.tau_W);
  const double turned = h * dot<double>(load.tau_W, V((before.w_WB + after.w_WB) / 2));
  ledger_.energy.work += dot<double>(V(load.f_W - weight), moved) + turned;
  ledger_.energy.stepper += kinetic(i, motions_[i]) - kinetic(i, moving) - dot<double>(load.f_W, moved) - turned;
  ledger_.linear.external += h * load.f_W;
  ledger_.angular.external += moment;
  ledger_.angular.stepper += angular(i, motions_[i]) - angular(i, moving) - moment;
  ledger_.worst_orthonormality = std::fmax(ledger_.worst_orthonormality, orthonormality_defect<double>(after.R_WB));
}

double World::potential() const {
  double sum = 0;
  for (std::size_t i = 0; i < motions_.size(); ++i) sum -= shape(i).mass() * dot<double>(gravity_, motions_[i].state.p_WB);
  return sum;
}
double World::energy() const {
  double sum = potential();
  for (std::size_t i = 0; i < motions_.size(); ++i) sum += kinetic(i, motions_[i]);
  return sum;
}
double World::kinetic(std::size_t i, const Motion& m) const {
  return (shape(i).mass() * dot<double>(m.state.v_WB, m.state.v_WB) + dot<double>(m.state.w_WB, m.L_W)) / 2;
}
V World::angular(std::size_t i, const Motion& m) const {
  return cross<double>(m.state.p_WB, V(shape(i).mass() * m.state.v_WB)) + m.L_W;
}
V World::linear() const {
  V sum = zero3<double>();
  for (std::size_t i = 0; i < motions_.size(); ++i) sum += linear_momentum<double>(shape(i).mass(), motions_[i].state.v_WB);
  return sum;
}
V World::angular() const {
  V sum = zero3<double>();
  for (std::size_t i = 0; i < motions_.size(); ++i) sum += angular(i, motions_[i]);
  return sum;
}
void World::audit() {
  Ledger::Energy& e = ledger_.energy;
  e.end = energy();
  ledger_.linear.end = linear();
  ledger_.angular.end = angular();
  if (ledger_.skips.monitors > 0) return forget_steps();
  e.worst_drift = std::fmax(e.worst_drift, std::fabs(e.end - e.start - e.work - e.correction - e.switched - e.stepper + e.restitution_loss + e.friction_loss));
  e.worst_stepper = std::fmax(e.worst_stepper, std::fabs(e.stepper));
  for (Ledger::Momentum* m : {&ledger_.linear, &ledger_.angular}) {
    m->worst_drift = std::fmax(m->worst_drift, norm<double>(V(m->end - m->start - m->external - m->stepper)));
    m->worst_stepper = std::fmax(m->worst_stepper, norm<double>(m->stepper));
  }
}
// Sums over steps, some of which were left out, are not known: no number rather than one with holes.
void World::forget_steps() {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  Ledger::Energy& e = ledger_.energy;
  e.work = e.stepper = e.worst_stepper = e.worst_drift = ledger_.worst_orthonormality = unknown;
  for (Ledger::Momentum* m : {&ledger_.linear, &ledger_.angular}) {
    m->external = m->stepper = V::Constant(unknown);
    m->worst_stepper = m->worst_drift = unknown;
  }
}

}  // namespace rigor
