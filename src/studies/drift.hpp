#pragma once
#include <rigor/studies/problem.hpp>
#include <string>
#include <vector>

namespace rigor::studies {

/// What a method loses over a long free flight, at one step.
struct Drift {
  const Method* method;
  double h;                 ///< s
  long steps;
  double energy;            ///< worst |E/E0 − 1| of the rotation
  double energy_jitter;     ///< standard deviation of its change from one step to the next, over |E0|
  double momentum;          ///< worst |L − L0|/|L0|
  double orthonormality;    ///< worst max|RᵀR − 1|
  bool finite;              ///< false: a number stopped being finite on the way, the rest says what was seen until then
};
/// `steps` steps of h of the problem's body without load, for one method. Stops early when interrupted.
Drift drift_of(const Problem& problem, const Method& method, double h, long steps);

/// The largest step, as an angle |ω| h in radians, up to which a method stays stable over 10⁴ steps: finite, with its energy
/// within a tenth. By bisection between 2⁻¹⁰ and 2⁶ rad on a grid of 2^(1/4); 0 when not even the smallest is stable.
double stable_angle(const Problem& problem, const Method& method);

std::string drift_csv(const Problem& problem, const std::vector<Drift>& rows);
std::string drift_text(const Problem& problem, const std::vector<Drift>& rows);
std::string drift_html(const Problem& problem, const std::vector<Drift>& rows, const std::string& command);

struct Stability {
  const Method* method;
  double angle;  ///< rad
};
std::string stability_csv(const Problem& problem, const std::vector<Stability>& rows);
std::string stability_text(const Problem& problem, const std::vector<Stability>& rows);
std::string stability_html(const Problem& problem, const std::vector<Stability>& rows, const std::string& command);

}  // namespace rigor::studies
