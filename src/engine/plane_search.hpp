#pragma once
#include <array>
#include <rigor/bodies/plane.hpp>
#include <rigor/engine/flight.hpp>

namespace rigor {

/// The eight corners of a cuboid over a plane at one moment: distances and their rates.
struct CornerGaps {
  std::array<double, 8> gap, rate;  ///< m, m/s; index as Cuboid::corner
  double rounding;                  ///< a gap up to this size is touching: 16 u of the absolute sum of its terms
  double still;                     ///< a rate up to this size is none: 16 u of the speeds in it

  bool touches(int k) const { return gap[k] <= rounding; }
};
CornerGaps corner_gaps(const Cuboid<double>& shape, const State<double>& s, const Plane<double>& plane);

/// Acceleration of corner k of a cuboid in torque-free motion whose centre accelerates by a_W; m/s², world axes.
Vec3<double> corner_acceleration(const Cuboid<double>& shape, const State<double>& s, int k, const Vec3<double>& a_W);

/// What a search along a flight found.
struct PlaneContact {
  enum class Kind {
    none,      ///< no corner reaches the plane before the limit
    impact,    ///< at `tau` a corner touches and approaches
    tangled,   ///< a corner stays within rounding of the plane: no time to name
    endless,   ///< a million advances did not settle it
  };
  Kind kind = Kind::none;
  double tau = 0;   ///< s from the flight's start
  long advances = 0;
};

/// The first τ > from at which a corner touches the plane and approaches it.
///
/// By conservative advancement with a bound on the second derivative: a corner with gap s and rate r stays in front of
/// the plane for as long as s + r δ + (n·a − Ω) δ²/2 > 0, Ω = Flight::acceleration_bound. The search goes from safe
/// point to safe point and cannot step over an impact; near one its steps converge quadratically, because what the
/// bound gives away is of second order. Without spin the first step ends at the root itself.
///
/// A corner that touches (within rounding) and leaves, like one just processed, counts as gap 0: its safe time
/// 2r/(Ω − n·a) is positive, so the same contact is not found again. One that touches with no rate at all but is
/// accelerated away by b stays in front for 3b/J, J = 5 |r| W³ a bound on the third derivative; without spin, rate or
/// acceleration along the normal it stays as it is. A graze, where the corner comes within
/// rounding of the plane with rate ≥ 0, is no impact.
///
/// errors    time within rounding/|rate| of the root
PlaneContact next_plane_contact(const Cuboid<double>& shape, const Flight& flight, const Plane<double>& plane, double from, double limit);

}  // namespace rigor
