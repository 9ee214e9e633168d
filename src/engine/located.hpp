#pragma once
#include <rigor/scene/simulate.hpp>

namespace rigor {

/// An event of a body in flight: what it met, between the state it flew in with and the one it left with.
struct LocatedImpact {
  std::size_t body;
  double t;                  ///< s
  double tau;                ///< s since the flight began: known to rounding, also when t is large
  State<double> from;        ///< the beginning of that flight
  State<double> before, after;
};
using LocatedObserver = std::function<void(const LocatedImpact&)>;

/// Method "located": exact flight between impacts, every impact found at its time. No step enters: the result does not
/// depend on dt, and not on the output times, as long as `handed_over` stays empty.
///
/// Impacts: the corners of a cuboid within 64 roundings of the plane that approach it are one contact at their mean
/// point; repeated until none approaches. A face that lands without spin, with the centre of pressure inside it, is hit
/// as a mass point is (the joint solution for its corners). Bounces lower than 1e-14 of the size end: the contact then
/// persists. A face without spin on one plane slides with constant deceleration, stops, and rests, and one without friction
/// glides, exactly; any other persistent contact is handed to a stepper with the scene's dt (exact flight for a step, then
/// the contacts of the assignment's program), until ten steps in a row met nothing. The rules and their reasons:
/// docs/located-impacts.md.
///
/// `skips.pairs` and `skips.planes` leave out what cannot meet in a flight; the states have the same bits with and without.
///
/// Faults: unsupported, naming what the mode does not know (forces and the vacuum: they have torque).
Outcome<RunSummary> simulate_located(const Scene& scene, const Observer& observe, const LocatedObserver& observe_impact = {}, const Skips& skips = {});

}  // namespace rigor
