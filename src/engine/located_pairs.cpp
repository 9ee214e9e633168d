#include <algorithm>
#include <cmath>
#include <rigor/contact/impact.hpp>
#include <rigor/engine/located_world.hpp>
#include <rigor/engine/pair_search.hpp>
#include <rigor/formulas/world_inverse_inertia.hpp>

namespace rigor {

using V = Vec3<double>;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double u = 0x1p-53;

}  // namespace

const PairEvent& LocatedWorld::nearest_event(std::size_t i) const {
  static const PairEvent none;
  return nearest_[i] > i ? pairs_[i * bodies_.size() + nearest_[i]] : none;
}

void LocatedWorld::search_partners(std::size_t i) {
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

PairEvent LocatedWorld::search_pair(std::size_t i, std::size_t j) {
  const LocatedBody &a = bodies_[i], &b = bodies_[j];
  if (!a.flight || !b.flight || (a.phase == LocatedBody::Phase::resting && b.phase == LocatedBody::Phase::resting)) return {};
  const Moment base = a.start.since(b.start) > 0 ? a.start : b.start;
  // Out of reach: the spheres around them do not meet before the run, or one of the flights, is over; the next flight is
  // searched when it begins. A thousandth to spare is far more than the rounding of positions of 1e9 sizes.
  const auto centre = [&](const LocatedBody& body) {
    const double tau = base.since(body.start);
    return V(body.flight->start().p_WB + tau * (body.flight->start().v_WB + tau / 2 * body.flight->acceleration()));
  };
  const auto speed = [&](const LocatedBody& body) { return V(body.flight->start().v_WB + base.since(body.start) * body.flight->acceleration()); };
  const double longest = std::min({base.until(scene_.until), a.next - base.since(a.start), b.next - base.since(b.start)});
  const double travel = longest * (norm<double>(V(speed(b) - speed(a))) + longest / 2 * norm<double>(V(b.flight->acceleration() - a.flight->acceleration())));
  if (longest >= 0 && norm<double>(V(centre(b) - centre(a))) - travel > 1.001 * (size(i) + size(j)) / 2 + 1e-3 * travel) return {};
  const PairContact found = next_pair_contact(shape(i), *a.flight, base.since(a.start), shape(j), *b.flight, base.since(b.start), 0, base.until(scene_.until));
  summary_.steps += found.advances;
  if (found.kind == PairContact::Kind::none) return {};
  return {base.after(found.time), found.kind == PairContact::Kind::tangled};
}

void LocatedWorld::meet(std::size_t i, std::size_t j) {
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

double LocatedWorld::last_meeting_at(std::size_t i, std::size_t j) const {
  const auto it = last_meeting_.find({i, j});
  return it == last_meeting_.end() ? -infinity : it->second;
}

bool LocatedWorld::hit_pair(std::size_t i, State<double>& a, std::size_t j, State<double>& b, const Separation& apart, double smallest) {
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

}  // namespace rigor
