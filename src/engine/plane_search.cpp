#include <cmath>
#include <limits>
#include <rigor/engine/plane_search.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double u = 0x1p-53;
constexpr long most_advances = 1000000;

/// First δ > 0 with s + r δ + c δ²/2 = 0 for s ≥ 0; infinity when there is none. s = 0 with r ≥ 0 starts in front.
double first_root(double s, double r, double c) {
  if (c >= 0) {
    if (r >= 0) return infinity;
    const double disc = r * r - 2 * c * s;
    return disc < 0 ? infinity : 2 * s / (-r + std::sqrt(disc));
  }
  const double root = std::sqrt(r * r - 2 * c * s);
  return r > 0 ? (r + root) / -c : s > 0 ? 2 * s / (root - r) : 0;
}

}  // namespace

CornerGaps corner_gaps(const Cuboid<double>& shape, const State<double>& s, const Plane<double>& plane) {
  const V n = apply_transposed<double>(s.R_WB, plane.normal()), w = apply_transposed<double>(s.R_WB, s.w_WB);
  const V turn = cross<double>(n, w);  // n·(ω×r) = r·(n×ω), body axes
  const double centre = plane.gap(s.p_WB), rate = dot<double>(plane.normal(), s.v_WB);
  CornerGaps c;
  for (int k = 0; k < 8; ++k) {
    const V r = shape.corner(k);
    c.gap[k] = centre + dot<double>(n, r);
    c.rate[k] = rate + dot<double>(turn, r);
  }
  double terms = norm<double>(shape.size()) / 2;
  for (int i = 0; i < 3; ++i) terms += std::fabs(plane.normal()[i]) * (std::fabs(s.p_WB[i]) + std::fabs(plane.point()[i]));
  c.rounding = 16 * u * terms;
  return c;
}

PlaneContact next_plane_contact(const Cuboid<double>& shape, const Flight& flight, const Plane<double>& plane, double from, double limit) {
  const double radius = norm<double>(shape.size()) / 2, n_a = dot<double>(plane.normal(), flight.acceleration());
  const double c = n_a - flight.acceleration_bound(radius);
  PlaneContact found;
  double tau = from;
  for (;;) {
    const State<double> s = flight.at(tau);
    const CornerGaps corners = corner_gaps(shape, s, plane);
    double safe = infinity;
    for (int k = 0; k < 8; ++k) {
      if (corners.touches(k) && corners.rate[k] < 0) return {PlaneContact::Kind::impact, tau, found.advances};
      safe = std::fmin(safe, first_root(corners.touches(k) ? 0 : corners.gap[k], corners.rate[k], c));
    }
    // far away: nothing can touch before the sphere around the cuboid does, and that moves on a parabola
    const double clear = plane.gap(s.p_WB) - radius;
    if (clear > 0) safe = std::fmax(safe, first_root(clear, dot<double>(plane.normal(), s.v_WB), n_a));
    if (!(safe <= limit - tau)) return {PlaneContact::Kind::none, limit, found.advances};
    const double next = tau + safe;
    if (next <= tau) {
      // less than one rounding of time: a corner that touches at rest, or the last bit before an impact
      for (int k = 0; k < 8; ++k)
        if (corners.touches(k)) return {PlaneContact::Kind::tangled, tau, found.advances};
      tau = std::nextafter(tau, infinity);
    } else {
      tau = next;
    }
    if (++found.advances > most_advances) return {PlaneContact::Kind::tangled, tau, found.advances};
  }
}

}  // namespace rigor
