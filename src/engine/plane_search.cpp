#include <cmath>
#include <limits>
#include <rigor/engine/first_root.hpp>
#include <rigor/engine/plane_search.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double u = 0x1p-53;
constexpr long most_advances = 1000000;

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
  c.still = 16 * u * (norm<double>(s.v_WB) + norm<double>(s.w_WB) * norm<double>(shape.size()));
  return c;
}

V corner_acceleration(const Cuboid<double>& shape, const State<double>& s, int k, const V& a_W) {
  const V w_B = apply_transposed<double>(s.R_WB, s.w_WB), r = apply<double>(s.R_WB, shape.corner(k));
  const V L_B = w_B.cwiseProduct(shape.inertia());
  const V alpha = apply<double>(s.R_WB, V(-cross<double>(w_B, L_B).cwiseProduct(shape.inverse_inertia())));
  return a_W + cross<double>(alpha, r) + cross<double>(s.w_WB, cross<double>(s.w_WB, r));
}

PlaneContact next_plane_contact(const Cuboid<double>& shape, const Flight& flight, const Plane<double>& plane, double from, double limit) {
  const double radius = norm<double>(shape.size()) / 2, n_a = dot<double>(plane.normal(), flight.acceleration());
  const double c = n_a - flight.acceleration_bound(radius), jerk = 5 * radius * flight.spin_bound() * flight.spin_bound() * flight.spin_bound();
  PlaneContact found;
  double tau = from;
  for (;;) {
    const State<double> s = flight.at(tau);
    const CornerGaps corners = corner_gaps(shape, s, plane);
    double safe = infinity;
    for (int k = 0; k < 8; ++k) {
      if (!corners.touches(k)) {
        safe = std::fmin(safe, first_root(corners.gap[k], corners.rate[k], c));
      } else if (corners.rate[k] < -corners.still) {
        return {PlaneContact::Kind::impact, tau, found.advances};
      } else if (corners.rate[k] > corners.still) {
        safe = std::fmin(safe, first_root(0, corners.rate[k], c));
      } else {
        const double away = dot<double>(plane.normal(), corner_acceleration(shape, s, k, flight.acceleration()));
        safe = std::fmin(safe, jerk > 0 ? 3 * std::fmax(0, away) / jerk : away >= 0 ? infinity : 0);
      }
    }
    // far away: nothing can touch before the sphere around the cuboid does, and that moves on a parabola
    const double clear = plane.gap(s.p_WB) - radius - corners.rounding;
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
    if (++found.advances > most_advances) return {PlaneContact::Kind::endless, tau, found.advances};
  }
}

}  // namespace rigor
