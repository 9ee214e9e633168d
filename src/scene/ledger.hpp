#pragma once
#include <rigor/linalg/types.hpp>

namespace rigor {

/// Accounts over a run. What is not explained by loads, impacts and corrections is the method's own error: `drift`.
struct Ledger {
  struct Energy {
    double start = 0, end = 0;      ///< kinetic + potential, J
    double work = 0;                ///< by forces other than gravity
    double restitution_loss = 0, friction_loss = 0;  ///< in impacts
    double correction = 0;          ///< potential energy given by pushing bodies out of planes and each other
    double switched = 0;            ///< potential energy that came or went with the gravity switch
    double worst_drift = 0;
  } energy;
  struct Momentum {
    Vec3<double> start = zero3<double>(), end = start;
    Vec3<double> external = start;  ///< given by gravity, forces, planes (and, for L, by position corrections)
    double worst_drift = 0;
  } linear, angular;                ///< N s; kg m²/s about the world's origin
  struct Skips {
    long pairs = 0, pairs_of = 0;     ///< pairs no step looked at, being far apart; of all pairs in all steps
    long planes = 0, planes_of = 0;   ///< cuboids against planes settled by the sphere around the cuboid; of all
    long loads = 0, loads_of = 0;     ///< sums of forces on a cuboid kept from the step before; of all
    long rest = 0, rest_of = 0;       ///< steps of a cuboid at rest without load, which change no bit; of all
    long monitors = 0, monitors_of = 0;  ///< steps after which no accounts were made up; of all
  } skips;
  long impacts = 0, plane_impacts = 0, pair_impacts = 0;
  long energy_rises = 0;            ///< impacts after which there was more kinetic energy than before
  double worst_orthonormality = 0;  ///< max |RᵀR − 1| seen
  double deepest_penetration = 0;   ///< m, before correction
};

}  // namespace rigor
