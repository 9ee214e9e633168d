#include <algorithm>
#include <cmath>
#include <rigor/contact/plane_response.hpp>
#include <rigor/engine/flow_methods.hpp>
#include <rigor/engine/located_world.hpp>
#include <rigor/engine/pair_search.hpp>
#include <rigor/formulas/gram_schmidt.hpp>

namespace rigor {

using V = Vec3<double>;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double u = 0x1p-53;
constexpr int calm_steps = 10;  // before a body flies again
constexpr int most_parts = 16;         // of one step
constexpr long most_steps = 10000000;  // of one run; all bodies in the stepper step together

}  // namespace

void LocatedWorld::hand_over(std::size_t i, const Moment& now, const State<double>& s, const char* why) {
  LocatedBody& b = bodies_[i];
  summary_.finite = summary_.finite && is_finite(s);
  b.phase = LocatedBody::Phase::stepping;
  b.start = now;
  land(i);
  b.state = s;
  b.rounding = 0;  // it is put against what it touches
  b.calm = 0;
  b.next = infinity;
  if (!b.handed) {
    b.handed = true;
    if (b.reported == LocatedBody::nowhere || summary_.handed_over[b.reported].why != why) {
      b.reported = summary_.handed_over.size();
      summary_.handed_over.push_back({i, 0, now.value(), infinity, why});
    }
    ++summary_.handed_over[b.reported].times;
    stepping_.insert(std::lower_bound(stepping_.begin(), stepping_.end(), i), std::uint32_t(i));
  }
  whole_step_ = std::min(whole_step_, step_after(now));
  next_step_ = std::min(next_step_, whole_step_);
  unwatched_.push_back(std::uint32_t(i));
  boxes_.remove(std::uint32_t(i));
  settle(i);
}

double LocatedWorld::step_after(const Moment& start) const {
  return (std::floor(start.value() / scene_.dt * (1 + 4 * u)) + 1) * scene_.dt;
}

bool LocatedWorld::settle(std::size_t i) {
  const State<double>& s = bodies_[i].state;
  const double reach = size(i) / 2 * 1.001, room = size(i) / 4;
  if (!is_finite(s)) return false;  // the run ends
  const auto around = [&](double r) { return AxisBox{V(s.p_WB - V::Constant(r)), V(s.p_WB + V::Constant(r))}; };
  const AxisBox needs = around(reach);
  if (boxes_.has(std::uint32_t(i)) && holds(boxes_.box(std::uint32_t(i)), needs)) return false;
  boxes_.put(std::uint32_t(i), around(reach + room));
  return true;
}

void LocatedWorld::step_all(double t) {
  static const Method& exact = flow_methods().front();
  if (++steps_ > most_steps) summary_.stopped = "ten million steps of cuboids handed over; a larger dt takes fewer";
  std::vector<std::uint32_t>& in = step_of_;
  in = stepping_;
  for (const std::uint32_t i : in) {
    LocatedBody& b = bodies_[i];
    const double h = b.start.until(t);
    const V weight = shape(i).mass() * gravity_;
    linear_.external += h * weight;
    angular_.external += h * cross<double>(V(b.state.p_WB + h / 2 * b.state.v_WB), weight);
    b.state = exact.step(shape(i), motion_of(shape(i), b.state), {weight, zero3<double>()}, h).state;
    b.state.R_WB = gram_schmidt<double>(b.state.R_WB);
    b.start = Moment{t, 0};
    met_[i] = false;
    for (const Plane<double>& plane : scene_.planes) met_[i] = respond(i, plane) || met_[i];
    summary_.finite = summary_.finite && is_finite(b.state);
    settle(i);
    ++summary_.steps;
  }
  const bool whole = t >= whole_step_;
  parts_ = whole ? 0 : parts_ + 1;
  whole_step_ = infinity;
  for (const std::uint32_t i : in) whole_step_ = std::min(whole_step_, step_after(bodies_[i].start));
  next_step_ = whole_step_;
  if (!summary_.finite) return;
  // who flies into one of them joins them
  flown_into_.clear();
  for (const std::uint32_t i : in) {
    near(boxes_.box(i), found_);
    for (const std::uint32_t j : found_)
      if (bodies_[j].flight) flown_into_.push_back({j, i});
  }
  std::sort(flown_into_.begin(), flown_into_.end());
  for (const auto& [j, i] : flown_into_) {
    if (!bodies_[j].flight) continue;  // it has joined
    const State<double> s = bodies_[j].flight->at(bodies_[j].start.until(t));
    const State<double>& other = bodies_[i].state;
    if (spheres_apart(i, other, j, s) || separation(shape(i), other, shape(j), s).gap > 0) continue;
    const State<double> there = arrive(j, bodies_[j].start.until(t));
    hand_over(j, Moment{t, 0}, there, "met a cuboid in the stepper");
  }
  in = stepping_;
  for (const std::uint32_t i : in) {
    near(boxes_.box(i), found_);
    for (std::size_t k = 0; k < found_.size(); ++k) {
      const std::uint32_t j = found_[k];
      if (j <= i || !bodies_[j].handed || !push_apart(i, j)) continue;
      met_[i] = met_[j] = true;
      settle(j);
      if (!settle(i)) continue;
      near(boxes_.box(i), found_);  // it was pushed out of its box: others may be near now
      k = std::size_t(std::upper_bound(found_.begin(), found_.end(), j) - found_.begin()) - 1;
    }
  }
  for (const std::uint32_t i : in) bodies_[i].calm = met_[i] ? 0 : bodies_[i].calm + whole;
  for (const std::uint32_t i : in)
    if (bodies_[i].calm >= calm_steps && clear(i)) begin(i, bodies_[i].start, bodies_[i].state);
  if (stepping_.empty()) next_step_ = whole_step_ = infinity;
  unwatched_.insert(unwatched_.end(), stepping_.begin(), stepping_.end());
}

void LocatedWorld::watch_step() {
  if (stepping_.empty() || !summary_.finite) return unwatched_.clear();
  std::vector<std::uint32_t>& who = unwatched_;
  std::sort(who.begin(), who.end());
  who.erase(std::unique(who.begin(), who.end()), who.end());
  for (const std::uint32_t i : who) {
    if (!bodies_[i].handed) continue;
    // straight on, with the fall to spare
    const State<double>& s = bodies_[i].state;
    const double h = bodies_[i].start.until(whole_step_), reach = size(i) / 2 * 1.001 + h * h / 2 * norm<double>(gravity_);
    const V there = s.p_WB + h * s.v_WB;
    const AxisBox path{V(s.p_WB.cwiseMin(there) - V::Constant(reach)), V(s.p_WB.cwiseMax(there) + V::Constant(reach))};
    if (!holds(boxes_.box(i), path)) boxes_.put(i, path);
  }
  for (const std::uint32_t i : who) {
    near(boxes_.box(i), found_);
    for (const std::uint32_t j : found_) {
      if (j == i || !(bodies_[i].handed || bodies_[j].handed)) continue;
      if (j < i && std::binary_search(who.begin(), who.end(), j)) continue;  // seen from j
      watch_pair(std::min(i, j), std::max(i, j));
    }
  }
  who.clear();
}

void LocatedWorld::watch_pair(std::size_t i, std::size_t j) {
  const LocatedBody &a = bodies_[i], &b = bodies_[j];
  const Moment base = a.start.since(b.start) > 0 ? a.start : b.start;
  const double h = base.until(next_step_);
  if (!(h > 0)) return;
  struct Course {
    V p, v, a;
    double turning;  // m/s, of a corner
  };
  const auto course = [&](std::size_t k) {
    const LocatedBody& body = bodies_[k];
    const State<double>& s = body.flight ? body.flight->start() : body.state;
    const V pull = body.flight ? body.flight->acceleration() : gravity_;
    const double tau = base.since(body.start), W = body.flight ? body.flight->spin_bound() : Flight::spin_bound(shape(k), apply_transposed<double>(s.R_WB, s.w_WB));
    return Course{V(s.p_WB + tau * (s.v_WB + tau / 2 * pull)), V(s.v_WB + tau * pull), pull, W * size(k) / 2};
  };
  const Course A = course(i), B = course(j);
  const double thinnest = std::min(shape(i).size().minCoeff(), shape(j).size().minCoeff()), pull = norm<double>(V(B.a - A.a));
  const double centres = norm<double>(V(B.v - A.v)) + h * pull, fastest = centres + A.turning + B.turning;
  if (h * fastest <= thinnest / 2) return;  // overlapping they are found at its end, on the side they came from
  if (norm<double>(V(B.p - A.p)) > h * centres + 1.001 * (size(i) + size(j)) / 2) return;
  const auto flight = [&](std::size_t k) { return bodies_[k].flight ? *bodies_[k].flight : Flight(shape(k), bodies_[k].state, gravity_); };
  const PairContact found = next_pair_contact(shape(i), flight(i), base.since(a.start), shape(j), flight(j), base.since(b.start), 0, h);
  summary_.steps += found.advances;
  if (found.kind == PairContact::Kind::none) return;
  const double met = base.after(found.time).value(), end = met + thinnest / (4 * fastest);  // no deeper than a quarter of it
  if (end >= next_step_) return;
  if (parts_ < most_parts) {
    next_step_ = std::max(end, now_);
    return;
  }
  const auto [place, first] = missed_.insert({{i, j}, summary_.may_have_missed.size()});
  if (first) summary_.may_have_missed.push_back({i, j, 0, met, met});
  MayHaveMissed& missed = summary_.may_have_missed[place->second];
  ++missed.times, missed.to = met;
}

bool LocatedWorld::spheres_apart(std::size_t i, const State<double>& a, std::size_t j, const State<double>& b) const {
  return norm<double>(V(b.p_WB - a.p_WB)) > (size(i) + size(j)) / 2;
}

bool LocatedWorld::clear(std::size_t i) {
  const State<double>& s = bodies_[i].state;
  near(boxes_.box(std::uint32_t(i)), found_);
  for (const std::uint32_t j : found_) {
    if (j == i) continue;
    const State<double> other = state_at(bodies_[j], bodies_[i].start.value());
    if (!spheres_apart(i, s, j, other) && separation(shape(i), s, shape(j), other).gap <= 0) return false;
  }
  return true;
}

bool LocatedWorld::respond(std::size_t i, const Plane<double>& plane) {
  LocatedBody& b = bodies_[i];
  const V weight = shape(i).mass() * gravity_;
  const PlaneResponse<double> response = respond_to_plane<double>(shape(i), b.state, plane, scene_.surface, scene_.friction_law, weight);
  if (response.corners == 0) return false;
  moved(i, response.shift);
  linear_.external += shape(i).mass() * (response.after.v_WB - b.state.v_WB);
  angular_.external += angular(i, response.after) - angular(i, b.state);
  for (const ImpactReport<double>& report : response.reports)
    if (!report.separating) ++ledger_.plane_impacts, note(report);
  b.state = response.after;
  return true;
}

bool LocatedWorld::push_apart(std::size_t i, std::size_t j) {
  State<double> a = bodies_[i].state, b = bodies_[j].state;
  if (spheres_apart(i, a, j, b)) return false;
  const Manifold found = box_box(shape(i), a, shape(j), b);
  if (!found.touches()) return false;
  const V point = found.centroid(), shift = found.depth / 2 * found.n_AB_W;
  Contact<double> contact;
  contact.n_AB_W = found.n_AB_W;
  a.p_WB -= shift, b.p_WB += shift;
  moved(i, V(-shift)), moved(j, shift);
  angular_.external += cross<double>(shift, V(shape(j).mass() * b.v_WB - shape(i).mass() * a.v_WB));
  contact.A = {shape(i).inverse_mass(), world_inverse_inertia<double>(a.R_WB, shape(i).inverse_inertia()), V(point - a.p_WB)};
  contact.B = {shape(j).inverse_mass(), world_inverse_inertia<double>(b.R_WB, shape(j).inverse_inertia()), V(point - b.p_WB)};
  const auto frictionless = *Surface<double>::make(scene_.surface.restitution(), 0, 0);
  const ImpactResult<double> result = resolve_impact<double>(contact, {{a.v_WB, a.w_WB}, {b.v_WB, b.w_WB}}, frictionless, scene_.friction_law);
  if (!result.report.separating) {
    ++ledger_.pair_impacts, note(result.report);
    a.v_WB = result.after.A.v_WB, a.w_WB = result.after.A.w_WB;
    b.v_WB = result.after.B.v_WB, b.w_WB = result.after.B.w_WB;
  }
  bodies_[i].state = a;
  bodies_[j].state = b;
  return true;
}

void LocatedWorld::moved(std::size_t i, const V& shift) {
  energy_.correction -= shape(i).mass() * dot<double>(gravity_, shift);
  ledger_.deepest_penetration = std::fmax(ledger_.deepest_penetration, norm<double>(shift));
}

}  // namespace rigor
