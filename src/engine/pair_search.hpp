#pragma once
#include <rigor/collision/box_index.hpp>
#include <rigor/engine/flight.hpp>

namespace rigor {

/// What a search along two flights found; times in s after the common moment the search counts from.
struct PairContact {
  enum class Kind {
    none,      ///< they stay apart until the limit
    touch,     ///< at `time` they are within rounding of touching
    endless,   ///< a hundred thousand advances did not settle it
    blurred,   ///< at `time` they come within reach, and places are rounded by more than half the thinnest edge
  };
  Kind kind = Kind::none;
  double time = 0;
  long advances = 0;
};

/// The first time in (from, limit] at which two cuboids touch and approach there. `since_A`, `since_B`: how long each flight has lasted
/// at the search's time 0. `slack`, m: a gap up to it is touching, for roundings the places had before.
///
/// Conservative advancement along moving axes N(t): a face normal of either, or the cross product of an edge of each,
/// turning with them. As long as F = N·(corner of B − corner of A) > 0 for every pair of corners they are apart, and
///
///     |F''| ≤ |N''| D + 2 |N'| V + Ω_A + Ω_B + |a_B − a_A|,   |N'| ≤ W_A + W_B,   |N''| ≤ k W_A² + 2 W_A W_B + k W_B²
///
/// with W the bound on a spin, k = 1 + 1/√3 (Flight::acceleration_bound), D and V bounds on distance and relative speed
/// of any two corners during the advance. F' at contact is the approach of the material points there, so the steps
/// converge quadratically and a contact that separates is left behind. Nothing is stepped over.
///
/// errors    time within rounding of the gap over its rate
PairContact next_pair_contact(const Cuboid<double>& A, const Flight& flight_A, double since_A, const Cuboid<double>& B, const Flight& flight_B,
                              double since_B, double from, double limit, double slack = 0);

/// A gap up to this size is touching, m: 16 u of the terms in it.
double touching_gap(const Cuboid<double>& A, const State<double>& a, const Cuboid<double>& B, const State<double>& b);

/// A box along the world's axes that holds the sphere of `radius` around the centre of a flight for τ in [from, to]: by its
/// parabolas, with a thousandth of the radius and what rounding may do to places and times to spare, so that spheres which
/// touch in next_pair_contact have boxes that overlap. `t`: the time at which the flight began, s.
AxisBox swept_box(const Flight& flight, double radius, double from, double to, double t);

}  // namespace rigor
