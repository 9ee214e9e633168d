#include <algorithm>
#include <cmath>
#include <limits>
#include <rigor/contact/impact.hpp>
#include <rigor/engine/first_root.hpp>
#include <rigor/engine/located_world.hpp>
#include <rigor/engine/pair_search.hpp>
#include <rigor/formulas/world_inverse_inertia.hpp>

namespace rigor {

using V = Vec3<double>;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double u = 0x1p-53;
constexpr std::size_t most_in_a_box = 4;  // not searched yet: beyond it a shorter part of the flight is looked at

}  // namespace

void LocatedWorld::look(std::size_t i) {
  LocatedBody& b = bodies_[i];
  const double from = b.looked, end = std::max(from, std::min(b.next, b.start.until(scene_.until)));
  const V& a = b.flight->acceleration();
  const double speed = norm<double>(V(b.flight->start().v_WB + from * a));
  Partners& mine = partners_[i];
  forget_void(mine);
  known_[i] = true;
  for (const Partner& p : mine.known) known_[p.body] = true;
  double to = end;
  for (;;) {
    // a millionth of what is left at least, so that looks end
    if (skips_.pairs) to = std::min(end, from + std::fmax(first_root(b.stride, -speed, -norm<double>(a)), 1e-6 * (end - from)));
    boxes_.put(std::uint32_t(i), swept_box(*b.flight, size(i) / 2, from, to, b.start.value()));
    near(boxes_.box(std::uint32_t(i)), found_);
    fresh_.clear();
    for (const std::uint32_t j : found_)
      if (!known_[j] && bodies_[j].flight) fresh_.push_back(j);
    if (fresh_.size() <= most_in_a_box || b.stride <= size(i) || !skips_.pairs) break;
    b.stride /= 2;
  }
  if (fresh_.empty() && to < end) b.stride *= 2;
  known_[i] = false;
  for (const Partner& p : mine.known) known_[p.body] = false;

  for (const std::uint32_t j : fresh_) {
    const std::uint32_t self = std::uint32_t(i), low = std::min(self, j), high = std::max(self, j);
    const PairEvent event = search_pair(low, high);
    if (event.at.value() < infinity) push({event.at, Event::Kind::meeting, event.found, low, high, bodies_[low].flights, bodies_[high].flights});
    mine.known.push_back({j, bodies_[j].flights});
    Partners& theirs = partners_[j];
    if (theirs.known.size() > 2 * theirs.kept + 16) forget_void(theirs);
    theirs.known.push_back({std::uint32_t(i), b.flights});
  }
  if (!stepping_.empty()) unwatched_.push_back(std::uint32_t(i));
  b.looked = to;
  if (to < end) push({b.start.after(to), Event::Kind::look, PairContact::Kind::none, std::uint32_t(i), std::uint32_t(i), b.flights, b.flights});
}

void LocatedWorld::forget_void(Partners& partners) const {
  std::erase_if(partners.known, [&](const Partner& p) { return bodies_[p.body].flights != p.flight; });
  partners.kept = partners.known.size();
}

void LocatedWorld::near(const AxisBox& box, std::vector<std::uint32_t>& found) const {
  found.clear();
  if (skips_.pairs) {
    boxes_.overlapping(box, found);
    std::sort(found.begin(), found.end());
  } else {
    for (std::uint32_t j = 0; j < bodies_.size(); ++j) found.push_back(j);
  }
}

PairEvent LocatedWorld::search_pair(std::size_t i, std::size_t j) {
  const LocatedBody &a = bodies_[i], &b = bodies_[j];
  const Moment base = a.start.since(b.start) > 0 ? a.start : b.start;
  if (a.phase == LocatedBody::Phase::resting && b.phase == LocatedBody::Phase::resting) {  // they stay as they are; told only if one is inside the other
    const State<double>&s_a = a.flight->start(), &s_b = b.flight->start();
    if (spheres_apart(i, s_a, j, s_b)) return {};
    const double rounding = rounding_at(a, base) + rounding_at(b, base), allowed = allowed_overlap(i, s_a, j, s_b);
    if (allowed + rounding > std::min(shape(i).size().minCoeff(), shape(j).size().minCoeff()) / 2) return {base, PairContact::Kind::blurred};
    if (separation(shape(i), s_a, shape(j), s_b).gap >= -allowed - rounding) return {};
    return {base, PairContact::Kind::touch};
  }
  // until the run, or one of the flights, is over: the next flight is searched when it begins
  const double longest = std::min({base.until(scene_.until), a.next - base.since(a.start), b.next - base.since(b.start)});
  if (skips_.pairs) {
    // Out of reach: the spheres around them do not meet before then. A thousandth to spare, and what places are rounded by.
    const auto centre = [&](const LocatedBody& body) {
      const double tau = base.since(body.start);
      return V(body.flight->start().p_WB + tau * (body.flight->start().v_WB + tau / 2 * body.flight->acceleration()));
    };
    const auto speed = [&](const LocatedBody& body) { return V(body.flight->start().v_WB + base.since(body.start) * body.flight->acceleration()); };
    const double travel = longest * (norm<double>(V(speed(b) - speed(a))) + longest / 2 * norm<double>(V(b.flight->acceleration() - a.flight->acceleration())));
    const auto rounding = [&](const LocatedBody& body) { return body.rounding + body.flight->rounding(base.since(body.start) + longest); };
    const double rounded = rounding(a) + rounding(b);
    if (longest >= 0 && norm<double>(V(centre(b) - centre(a))) - travel > 1.001 * (size(i) + size(j)) / 2 + 1e-3 * travel + rounded) return {};
    --ledger_.skips.pairs;
  }
  const PairContact found = next_pair_contact(shape(i), *a.flight, base.since(a.start), shape(j), *b.flight, base.since(b.start), 0, longest, a.rounding + b.rounding);
  summary_.steps += found.advances;
  if (found.kind == PairContact::Kind::none) return {};
  return {base.after(found.time), found.kind};
}

double LocatedWorld::rounding_at(const LocatedBody& body, const Moment& now) {
  return std::fmax(body.rounding, body.flight->rounding(now.since(body.start)));
}

double LocatedWorld::allowed_overlap(std::size_t i, const State<double>& a, std::size_t j, const State<double>& b) const {
  return 1e-9 * std::min(shape(i).size().minCoeff(), shape(j).size().minCoeff()) + touching_gap(shape(i), a, shape(j), b);
}

void LocatedWorld::meet(const Event& event) {
  const std::size_t i = event.i, j = event.j;
  const Moment now = event.at;
  State<double> a = arrive(i, now.since(bodies_[i].start)), b = arrive(j, now.since(bodies_[j].start));
  LocatedImpact seen_a{i, now.value(), now.since(bodies_[i].start), bodies_[i].flight->start(), a, a}, seen_b{j, now.value(), now.since(bodies_[j].start), bodies_[j].flight->start(), b, b};
  const Separation apart = separation(shape(i), a, shape(j), b);
  const double smallest = std::min(shape(i).size().minCoeff(), shape(j).size().minCoeff());
  const double rounding = bodies_[i].rounding + bodies_[j].rounding, allowed = allowed_overlap(i, a, j, b);
  const char* trouble = event.found == PairContact::Kind::endless ? "a search of a hundred thousand advances found no end"
                        : event.found == PairContact::Kind::blurred ? too_coarse
                        : apart.gap < -allowed - rounding ? "begins inside another cuboid"
                        : apart.gap < -allowed && rounding > coarse * smallest ? too_coarse
                                                                               : nullptr;
  bool any = false;
  for (int round = 0; trouble == nullptr; ++round) {
    if (!hit_pair(i, a, j, b, apart, smallest)) break;
    any = true;
    if (round == 100) trouble = "impacts of one moment do not end";
  }
  if (!any && trouble == nullptr) trouble = "two cuboids touch and neither approach nor part";
  // bounces between two that have become too fast to follow: a persistent contact
  const double speed = norm<double>(V(a.v_WB - b.v_WB)) + norm<double>(a.w_WB) * size(i) + norm<double>(b.w_WB) * size(j) + std::sqrt(norm<double>(gravity_) * smallest);
  if (trouble == nullptr && (now.value() - last_meeting_at(i, j)) * speed < 1e-6 * smallest) trouble = "a persistent contact of two cuboids";
  last_meeting_[{i, j}] = now.value();
  if (trouble != nullptr) {
    hand_over(i, now, a, trouble);
    hand_over(j, now, b, trouble);
  } else {
    land(j);  // no partner for the search of i until it has begun anew
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
  // the manifold is that of the smallest overlap there is: B moved into A by 1e-10 of the smallest edge, or by what places can tell
  State<double> pushed = b;
  const double push = apart.gap + std::fmax(1e-10 * smallest, 2 * touching_gap(shape(i), a, shape(j), b));
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
