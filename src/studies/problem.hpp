#pragma once
#include <functional>
#include <rigor/integrators/method.hpp>
#include <string>
#include <vector>

namespace rigor::studies {

/// A smooth initial value problem with a known end, by name.
struct Problem {
  std::string name;        ///< "case-A"
  std::string says;        ///< one sentence, with the numbers
  std::string reference;   ///< how the reference is made and its own error
  Cuboid<double> body;
  State<double> start;
  std::function<Load(double t, const State<double>&)> load;  ///< zero when empty
  double until;            ///< s
  State<double> end;       ///< the reference at `until`

  Load load_at(double t, const State<double>& s) const { return load ? load(t, s) : Load{}; }
};

/// The catalogue: free flight A, B, C, the public box FB-05, a thrown body, a forced body.
std::vector<std::string> problem_names();
/// nullptr when there is none of that name. The reference is computed at the first call (up to a second).
const Problem* find_problem(const std::string& name);

/// Distance of a computed end from the reference.
struct Errors {
  double attitude;  ///< rad
  double momentum;  ///< angular, relative to its size at the start (the loss of L where there is no torque)
  double energy;    ///< relative to the kinetic energy at the start
  double position;  ///< m
};
Errors errors_of(const Problem& problem, const State<double>& end);

}  // namespace rigor::studies
