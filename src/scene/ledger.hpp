#pragma once
#include <rigor/linalg/types.hpp>

namespace rigor {

/// Accounts over a run. A method's own error is an account too, `stepper`: what its free steps gave or took beside the work
/// of the loads. What no account explains, `drift`, is rounding.
struct Ledger {
  struct Energy {
    double start = 0, end = 0;      ///< kinetic + potential, J
    double work = 0;                ///< by forces other than gravity
    double restitution_loss = 0, friction_loss = 0;  ///< in impacts
    double correction = 0;          ///< potential energy given by pushing bodies out of planes and each other
    double switched = 0;            ///< potential energy that came or went with the gravity switch
    double stepper = 0;             ///< by free steps: after less before, less the work of the load
    double worst_stepper = 0;       ///< largest |stepper| on the way
    double worst_drift = 0;
  } energy;
  struct Momentum {
    Vec3<double> start = zero3<double>(), end = start;
    Vec3<double> external = start;  ///< given by gravity, forces, planes (and, for L, by position corrections)
    Vec3<double> stepper = start;   ///< as in energy; of L only, less the load's moment at the beginning of the step
    double worst_stepper = 0;
    double worst_drift = 0;
  } linear, angular;                ///< N s; kg m²/s about the world's origin
  struct Skips {
    long pairs = 0, pairs_of = 0;     ///< pairs no step looked at, being far apart; of all pairs in all steps
    long planes = 0, planes_of = 0;   ///< cuboids against planes settled by the sphere around the cuboid; of all
    long loads = 0, loads_of = 0;     ///< sums of forces on a cuboid kept from the step before; of all
    long rest = 0, rest_of = 0;       ///< steps of a cuboid at rest without load, which change no bit; of all
    long monitors = 0, monitors_of = 0;  ///< steps of which no accounts were kept; of all
  } skips;
  long impacts = 0, plane_impacts = 0, pair_impacts = 0;
  long energy_rises = 0;            ///< impacts after which there was more kinetic energy than before
  double worst_orthonormality = 0;  ///< max |RᵀR − 1| seen
  double deepest_penetration = 0;   ///< m, before correction
};

}  // namespace rigor
