#pragma once
#include <rigor/studies/cell.hpp>
#include <rigor/studies/problem.hpp>
#include <string>
#include <vector>

namespace rigor::studies {

/// A rate, and the half width of its interval of 95 % confidence.
struct Slope {
  double value, half_width;
};
/// Least squares of y over equally spaced x = 1 ... n, the spread of the residuals taken for independent (Student's t).
/// NaN below three points.
Slope slope_of(const std::vector<double>& y);

/// What a method loses over a long free flight, at one step.
struct Drift {
  const Method* method;
  double h;                 ///< s
  long steps;
  double energy;            ///< worst |E/E0 − 1| of the rotation
  double energy_jitter;     ///< standard deviation of its change from one step to the next, over |E0|
  double momentum;          ///< worst |L − L0|/|L0| of L in world axes as the method carries it (Motion::L_W)
  double orthonormality;    ///< worst max|RᵀR − 1|
  bool finite;              ///< false: after `steps` steps it left the numbers (`left_the_numbers`), the rest says what was seen until then
  double position = 0;      ///< worst distance of the centre from its straight line, over the way it has gone
  Slope rate{0, 0};         ///< of E/E0 a second, from the means of forty equal stretches
};
/// `steps` steps of h of the problem's body without load, for one method; the centre goes straight on at (0.3, -0.2, 0.1) m/s.
/// `compensated`: each step starts from the origin, and the ways are summed with a carry (Neumaier). Stops early when
/// interrupted.
Drift drift_of(const Problem& problem, const Method& method, double h, long steps, bool compensated = false);

/// The largest step, as an angle |ω| h in radians, up to which a method stays stable over 10⁴ steps: finite, with its energy
/// within a tenth. By bisection between 2⁻¹⁰ and 2⁶ rad on a grid of 2^(1/4); 0 when not even the smallest is stable.
double stable_angle(const Problem& problem, const Method& method);

/// A cell of "drift": `steps` steps of `x` s of a problem that `falls` and spins. One that fails has no number but NaN.
Row drift(const Cell& cell);

/// What a step does to a flight.
enum class Verdict { stable, inaccurate, unstable };
/// One cell of a map: `steps` steps of |ω| h = `x` rad. Unstable: it leaves the numbers, or its energy leaves a tenth.
/// Inaccurate: stable, but the attitude is off by more than 0.1 rad after one turn. The problem says what `y` is:
///   "spin"    the tilt of the spin from the middle axis of a cuboid 1 x 2 x 3 m, degrees
///   "aspect"  the aspect ratio of a cuboid 1 x 1.5 x y m that tumbles near its middle axis
///   "mass"    a stack: the mass of the upper of two cubes over that of the lower, let go in contact on a floor; `x` is the
///             step in s. Unstable: something flies off or falls through; inaccurate: an overlap above 1 cm
/// A problem that `falls` and spins instead: its `stable_angle`.
Row stability(const Cell& cell);
struct Map {
  std::string name, says, x, y;
  std::vector<double> xs, ys;
};
const std::vector<Map>& maps();
/// nullptr when there is none of that name.
const Map* find_map(const std::string& name);

}  // namespace rigor::studies
