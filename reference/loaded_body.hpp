#pragma once
#include <reference/free_body.hpp>
#include <reference/jet.hpp>
#include <reference/precise.hpp>
#include <vector>

namespace rigor::reference {

/// A body that spins under what the frozen table of loaded flights knows. Nothing here pushes its centre.
struct LoadedBody {
  FreeBody at_start;
  Vec3<double> arm_B = zero3<double>();   ///< m: where a weight of 1 N acts, along −z of the world
  Vec3<double> tau_B = zero3<double>();   ///< N·m, held in body axes
  Vec3<double> push_W = zero3<double>();  ///< N·m, in world axes, times cos(rate t)
  double rate = 0;                        ///< rad/s
};

/// Taylor series of ω_B and the quaternion since the start, in 60 digits, steps no longer than `step` s.
/// errors    about (step/r)^order a step, r the distance of the nearest singularity in the complex plane of t, 0.3 s and more at spins up to 3
///           rad/s: below 1e-35 at the defaults there
Attitude<Precise> taylor_loaded_body(const LoadedBody& body, double t, int order = 32, double step = 0.02);

/// Vectors (three) and quaternions (four) of series.
using Jets = std::vector<Jet<Precise>>;
Jets cross(const Jets& a, const Jets& b);
/// q' = q (0, ω)/2, ω in body axes.
Jets quaternion_rate(const Jets& q, const Jets& w_B);
/// Rᵀx of a unit quaternion.
Jets turned_back(const Jets& q, const Jets& x);

}  // namespace rigor::reference
