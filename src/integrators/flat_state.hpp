#pragma once
#include <rigor/integrators/method.hpp>

namespace rigor {

/// (p, v, q, ω_B) as one vector, for methods that do not care what it means. q need not be a unit quaternion: its rate is
/// linear in it and the rotation it stands for does not depend on its length.
using FlatState = Eigen::Matrix<double, 13, 1>;

FlatState flat_of(const State<double>& s);
State<double> state_of(const FlatState& y);

/// Newton and Euler: p' = v, v' = f/m, q' = q (0, ω_B)/2, ω_B' = I⁻¹ (τ_B − ω × Iω).
FlatState flat_rate(const Cuboid<double>& body, const LoadAt& load, double t, const FlatState& y);

}  // namespace rigor
