#pragma once
#include <reference/precise.hpp>
#include <rigor/base/outcome.hpp>
#include <rigor/linalg/types.hpp>
#include <vector>

/// Two witnesses of a cuboid that is thrown among planes and bounces, one corner at a time: 60 digits from end to end, and
/// CVODE with root finding in double. Both restart at every impact with Newton's restitution and Coulomb friction, written
/// here; they share that law and the distances of corners, and neither a flight nor a search. Nothing of an engine.
///
/// Not for what has no corner of its own: edges and faces that land flat, contacts that last.
namespace rigor::reference {

/// Numbers in double, taken exactly; world axes, SI units.
struct Throw {
  struct Wall {
    Vec3<double> point, normal;  ///< unit normal, into the room
  };
  Vec3<double> size = zero3<double>();  ///< edges
  double mass = 0;
  Vec3<double> gravity = zero3<double>();
  std::vector<Wall> walls;
  double restitution = 0, friction = 0;
};

template <class T>
struct Thrown {
  Vec3<T> p_WB, v_WB, w_WB;
  Mat3<T> R_WB;
};

template <class T>
struct WallImpact {
  T t;               ///< since the start, s
  std::size_t wall;  ///< whose
  Thrown<T> before, after;
};

/// The first `count` impacts before `until`, in 60 digits: attitudes by Taylor's series of order 40, the parabola, the distance
/// of the lowest corner, its root by the secant rule (Newton's without derivatives) until it is below 1e-45 m. Where to look is
/// found by watching a flight in double every millisecond: a corner that dips and is out again within one is missed.
/// errors    calibrated on bounces in closed form to 1e-40 (tests/reference)
std::vector<WallImpact<Precise>> precise_impacts(const Throw& scene, Thrown<Precise> start, double until, std::size_t count);

/// The same by CVODE Adams, rtol = atol = tolerance, its root finding for approaching corners, the root polished (first_fall).
/// errors    calibrated on the same to 1e-12 a flight; a corner that dips and is out again within a step of CVODE is missed
/// Faults: those of cvode().
Outcome<std::vector<WallImpact<double>>> cvode_impacts(const Throw& scene, Thrown<double> start, double until, std::size_t count, double tolerance = 1e-14);

/// Free flight of the first witness for t s.
Thrown<Precise> precise_flight(const Throw& scene, const Thrown<Precise>& from, const Precise& t);

/// What an impact makes of a body whose corner at arm r from its centre is on the wall: T is double or Precise.
template <class T>
Thrown<T> struck(const Throw& scene, const Thrown<T>& before, const Vec3<double>& normal, const Vec3<T>& r);
extern template Thrown<double> struck<double>(const Throw&, const Thrown<double>&, const Vec3<double>&, const Vec3<double>&);
extern template Thrown<Precise> struck<Precise>(const Throw&, const Thrown<Precise>&, const Vec3<double>&, const Vec3<Precise>&);

}  // namespace rigor::reference
