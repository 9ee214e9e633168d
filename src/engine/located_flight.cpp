#include <algorithm>
#include <cmath>
#include <rigor/contact/impact.hpp>
#include <rigor/engine/first_root.hpp>
#include <rigor/engine/located_world.hpp>
#include <rigor/engine/plane_search.hpp>
#include <rigor/formulas/world_inverse_inertia.hpp>

namespace rigor {

using V = Vec3<double>;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double u = 0x1p-53;
constexpr double smallest_bounce = 1e-14;  // height over size below which bounces end
constexpr long most_impacts = 10000000;    // of one run

// The body axis nearest to the plane's normal: that of the face which lies on it.
int facing(const State<double>& s, const Plane<double>& plane) {
  int axis = 0;
  apply_transposed<double>(s.R_WB, plane.normal()).cwiseAbs().maxCoeff(&axis);
  return axis;
}

}  // namespace

void LocatedWorld::begin(std::size_t i, const Moment& now, State<double> s) {
  if (!is_finite(s)) return hand_over(i, now, s, "a number left the range of double");
  for (const Plane<double>& plane : scene_.planes) {
    const CornerGaps c = corner_gaps(shape(i), s, plane);
    const double deepest = *std::min_element(c.gap.begin(), c.gap.end()), allowed = 1e-9 * size(i) + c.rounding, rounding = bodies_[i].rounding;
    if (deepest < -allowed - rounding) return hand_over(i, now, s, "begins inside a plane");
    if (deepest < -allowed && rounding > coarse * shape(i).size().minCoeff()) return hand_over(i, now, s, too_coarse);
  }
  for (int round = 0;; ++round) {
    bool any = false;
    for (const Plane<double>& plane : scene_.planes) any = hit(i, s, plane) || any;
    if (!any) break;
    if (!is_finite(s)) return hand_over(i, now, s, "a number left the range of double");
    if (round == 100) return hand_over(i, now, s, "impacts of one moment do not end");
  }
  int support = -1, supports = 0;
  double tail = 0;
  for (std::size_t p = 0; p < scene_.planes.size(); ++p)
    if (persists(i, s, scene_.planes[p], tail)) support = int(p), ++supports;
  if (supports == 0) return fly(i, now, s, gravity_, -1, LocatedBody::Phase::flying, infinity);
  if (supports > 1) return hand_over(i, now, s, "rests on more than one plane");
  if (!lie(i, now, s, support)) return hand_over(i, now, s, "a persistent contact that no exact phase knows");
  if (tail > 0) summary_.accumulations.push_back({i, now.value(), tail});
}

bool LocatedWorld::hit(std::size_t i, State<double>& s, const Plane<double>& plane) {
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
  linear_.external += result.report.j_W;
  angular_.external += cross<double>(whole ? s.p_WB : V(s.p_WB + arm), result.report.j_W);
  return true;
}

bool LocatedWorld::pressure_inside(std::size_t i, const State<double>& s, const Plane<double>& plane, const V& f) const {
  const V f_B = apply_transposed<double>(s.R_WB, f), half = shape(i).size() / 2;
  const int axis = facing(s, plane);
  for (int k = 0; k < 3; ++k)
    if (k != axis && half[axis] * std::fabs(f_B[k]) > half[k]) return false;
  return true;
}

bool LocatedWorld::persists(std::size_t i, const State<double>& s, const Plane<double>& plane, double& tail) const {
  const CornerGaps c = corner_gaps(shape(i), s, plane);
  const bool lies = flat(i, s, plane);
  bool any = false;
  for (int k = 0; k < 8; ++k) {
    if (c.gap[k] > 64 * c.rounding) continue;
    // spin about the normal turns a corner in the plane: no part of what presses it
    const double press = -dot<double>(plane.normal(), lies ? gravity_ : corner_acceleration(shape(i), s, k, gravity_)), leave = std::fmax(0, c.rate[k]);
    if (press == 0 && lies && norm<double>(s.w_WB) > 0 && leave <= c.still) any = true;
    if (press > 0 && leave * leave <= 2 * press * smallest_bounce * size(i)) {
      any = true;
      const double e = scene_.surface.restitution();
      if (leave > 0 && e < 1) tail = std::fmax(tail, 2 * leave / (press * (1 - e)));
    }
  }
  return any;
}

bool LocatedWorld::flat(std::size_t i, const State<double>& s, const Plane<double>& plane) const {
  const CornerGaps c = corner_gaps(shape(i), s, plane);
  const V n = plane.normal(), tilting = s.w_WB - dot<double>(s.w_WB, n) * n;
  return std::count_if(c.gap.begin(), c.gap.end(), [&](double gap) { return gap <= 64 * c.rounding; }) == 4 && norm<double>(tilting) * size(i) <= 1e-12 * pace(i, s);
}

double LocatedWorld::pace(std::size_t i, const State<double>& s) const {
  return norm<double>(s.v_WB) + norm<double>(s.w_WB) * size(i) + std::sqrt(norm<double>(gravity_) * size(i));
}

bool LocatedWorld::lie(std::size_t i, const Moment& now, State<double> s, int support) {
  const Plane<double>& plane = scene_.planes[std::size_t(support)];
  if (!flat(i, s, plane)) return false;
  const double mu_s = scene_.surface.static_friction(), mu_d = scene_.surface.dynamic_friction(), scale = pace(i, s);
  const V n = plane.normal(), downhill = gravity_ - dot<double>(gravity_, n) * n;
  const double press = -dot<double>(gravity_, n), slope = norm<double>(downhill);
  const double leave = dot<double>(s.v_WB, n);
  const bool spins = norm<double>(s.w_WB) * size(i) > 1e-12 * scale, rough = (mu_s > 0 || mu_d > 0) && press > 0;
  if (spins && rough) return false;
  s.w_WB = spins ? V(dot<double>(s.w_WB, n) * n) : zero3<double>();
  s.v_WB -= leave * n;
  linear_.external -= shape(i).mass() * leave * n;  // of the bounces left out
  angular_.external -= cross<double>(s.p_WB, V(shape(i).mass() * leave * n));
  energy_.restitution_loss += shape(i).mass() * leave * leave / 2;
  const double speed = norm<double>(s.v_WB);
  const auto at_rest = [&] {
    s.v_WB = zero3<double>();
    fly(i, now, s, zero3<double>(), support, LocatedBody::Phase::resting, infinity);
    return true;
  };
  if (!rough && (spins || speed > 16 * u * scale || slope > 0)) {
    fly(i, now, s, downhill, support, LocatedBody::Phase::gliding, infinity);
    return true;
  }
  if (speed <= 16 * u * scale && slope <= mu_s * press * (1 + 4 * u)) return pressure_inside(i, s, plane, V(-downhill / press)) && at_rest();
  const V along = speed > 16 * u * scale ? V(s.v_WB / speed) : V(downhill / slope);
  const double pull = dot<double>(downhill, along), rate = pull - mu_d * press;
  if (norm<double>(V(downhill - pull * along)) > 1e-12 * press) return false;  // friction turns with the slip
  if (!pressure_inside(i, s, plane, V(-mu_d * along))) return false;
  if (speed <= 16 * u * scale && rate <= 0) return at_rest();  // mu_d > mu_s, which the sheet's law allows
  fly(i, now, s, V(rate * along), support, LocatedBody::Phase::sliding, rate < 0 ? -speed / rate : infinity);
  return true;
}

void LocatedWorld::fly(std::size_t i, const Moment& now, const State<double>& s, const V& a, int support, LocatedBody::Phase phase, double ends) {
  LocatedBody& b = bodies_[i];
  if (b.handed) {
    summary_.handed_over[b.reported].to = now.value();
    b.handed = false;
    stepping_.erase(std::lower_bound(stepping_.begin(), stepping_.end(), i));
  }
  land(i);
  b.phase = phase;
  b.start = now;
  b.support = support;
  b.flight.emplace(shape(i), s, a, phase == LocatedBody::Phase::gliding ? std::optional(facing(s, scene_.planes[std::size_t(support)])) : std::nullopt);
  ++flying_;
  b.next = ends;
  const char* trouble = nullptr;
  const double horizon = now.until(scene_.until), radius = size(i) / 2;
  for (std::size_t p = 0; p < scene_.planes.size(); ++p) {
    if (int(p) == support) continue;
    const Plane<double>& plane = scene_.planes[p];
    const double limit = std::min(b.next, horizon);
    ++ledger_.skips.planes_of;
    if (skips_.planes) {  // the sphere around the cuboid stays clear of it
      const double clear = plane.gap(s.p_WB) - radius;
      if (clear > 0 && !(first_root(clear, dot<double>(plane.normal(), s.v_WB), dot<double>(plane.normal(), a)) <= limit)) {
        ++ledger_.skips.planes;
        continue;
      }
    }
    const PlaneContact found = next_plane_contact(shape(i), *b.flight, plane, 0, limit);
    summary_.steps += found.advances;
    if (found.kind == PlaneContact::Kind::none || found.tau >= b.next) continue;
    b.next = found.tau;
    trouble = found.kind == PlaneContact::Kind::tangled ? "a corner follows the plane within rounding"
              : found.kind == PlaneContact::Kind::endless ? "a search of a million advances found no end"
                                                          : nullptr;
  }
  b.trouble = trouble;
  const std::uint32_t index = std::uint32_t(i);
  if (b.next < infinity) push({now.after(b.next), Event::Kind::own, PairContact::Kind::none, index, index, b.flights, b.flights});
  ledger_.skips.pairs_of += long(flying_) - 1;
  if (skips_.pairs) ledger_.skips.pairs += long(flying_) - 1;
  look(i);
}

void LocatedWorld::land(std::size_t i) {
  LocatedBody& b = bodies_[i];
  if (b.flight) b.flight.reset(), --flying_;
  ++b.flights;
  b.looked = 0;
  partners_[i].known.clear();
}

void LocatedWorld::note(const ImpactReport<double>& report) {
  if (++ledger_.impacts >= most_impacts) summary_.stopped = "ten million impacts";
  energy_.restitution_loss += report.restitution_loss;
  energy_.friction_loss += report.friction_loss;
  ledger_.energy_rises += report.energy_rose;
}

}  // namespace rigor
