#include <algorithm>
#include <cmath>
#include <rigor/contact/plane_response.hpp>
#include <rigor/engine/located_world.hpp>

namespace rigor {

using V = Vec3<double>;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double u = 0x1p-53;
constexpr int calm_steps = 10;  // before a body flies again

}  // namespace

void LocatedWorld::hand_over(std::size_t i, const Moment& now, const State<double>& s, const char* why) {
  LocatedBody& b = bodies_[i];
  summary_.finite = summary_.finite && is_finite(s);
  b.phase = LocatedBody::Phase::stepping;
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

double LocatedWorld::next_step() const {
  double t = infinity;
  for (const LocatedBody& b : bodies_)
    if (b.handed) t = std::min(t, (std::floor(b.start.value() / scene_.dt * (1 + 4 * u)) + 1) * scene_.dt);
  return t;
}

void LocatedWorld::step_all(double t) {
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
    LocatedBody& b = bodies_[i];
    const double h = b.start.until(t);
    const V weight = shape(i).mass() * gravity_;
    ledger_.linear.external += h * weight;
    ledger_.angular.external += h * cross<double>(b.motion.state.p_WB, weight);
    b.motion = find_method("sheet")->step(shape(i), b.motion, {weight, zero3<double>()}, h);
    summary_.finite = summary_.finite && is_finite(b.motion.state);
    b.start = Moment{t, 0};
    b.calm = met[i] ? 0 : b.calm + 1;
    ++summary_.steps;
  }
  if (!summary_.finite) return;
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

bool LocatedWorld::clear(std::size_t i) const {
  const State<double>& s = bodies_[i].motion.state;
  for (std::size_t j = 0; j < bodies_.size(); ++j) {
    if (j == i) continue;
    const State<double> other = state_at(bodies_[j], bodies_[i].start.value());
    if (norm<double>(V(other.p_WB - s.p_WB)) <= (size(i) + size(j)) / 2 && separation(shape(i), s, shape(j), other).gap <= 0) return false;
  }
  return true;
}

bool LocatedWorld::respond(std::size_t i, const Plane<double>& plane) {
  LocatedBody& b = bodies_[i];
  const V weight = shape(i).mass() * gravity_;
  const PlaneResponse<double> response = respond_to_plane<double>(shape(i), b.motion.state, plane, scene_.surface, scene_.friction_law, weight);
  if (response.corners == 0) return false;
  moved(i, response.shift);
  ledger_.linear.external += shape(i).mass() * (response.after.v_WB - b.motion.state.v_WB);
  ledger_.angular.external += angular(i, response.after) - angular(i, b.motion.state);
  for (const ImpactReport<double>& report : response.reports)
    if (!report.separating) ++ledger_.plane_impacts, note(report);
  b.motion = motion_of(shape(i), response.after);
  return true;
}

bool LocatedWorld::push_apart(std::size_t i, std::size_t j) {
  State<double> a = bodies_[i].motion.state, b = bodies_[j].motion.state;
  if (norm<double>(V(b.p_WB - a.p_WB)) > (size(i) + size(j)) / 2) return false;
  const Manifold found = box_box(shape(i), a, shape(j), b);
  if (!found.touches()) return false;
  const V point = found.centroid(), shift = found.depth / 2 * found.n_AB_W;
  Contact<double> contact;
  contact.n_AB_W = found.n_AB_W;
  a.p_WB -= shift, b.p_WB += shift;
  moved(i, V(-shift)), moved(j, shift);
  ledger_.angular.external += cross<double>(shift, V(shape(j).mass() * b.v_WB - shape(i).mass() * a.v_WB));
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

void LocatedWorld::moved(std::size_t i, const V& shift) {
  ledger_.energy.correction -= shape(i).mass() * dot<double>(gravity_, shift);
  ledger_.deepest_penetration = std::fmax(ledger_.deepest_penetration, norm<double>(shift));
}

}  // namespace rigor
