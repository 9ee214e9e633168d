#pragma once
#include <cmath>
#include <functional>
#include <optional>
#include <rigor/base/outcome.hpp>
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
  /// No torque and this constant acceleration, m/s²: what exact flight and other engines can be asked for. Else nothing.
  std::optional<Vec3<double>> falls = std::nullopt;
  std::string content{};   ///< of a scene file: a hash of body, start, gravity and T as they were read; "" in the catalogue

  Load load_at(double t, const State<double>& s) const { return load ? load(t, s) : Load{}; }
};

/// A cuboid of the catalogue: m > 0 kg, edges > 0 m.
inline Cuboid<double> cuboid(double m, const Vec3<double>& size) { return *Cuboid<double>::make(m, size); }

/// The catalogue: free flights, the public box, a thrown body, forced bodies.
std::vector<std::string> problem_names();
/// Those of them that `falls`.
std::vector<std::string> free_flight_names();
/// nullptr when there is none of that name. The reference is computed at the first call (up to a second). From any thread.
const Problem* find_problem(const std::string& name);

/// A problem of the catalogue, or the flight of the one cuboid of a scene file, up to `until` s where that is not 0.
/// Faults: unknown_key, with a suggestion; out_of_range (until); what the scene file brings; unsupported (a scene that
/// has more than one cuboid, planes, forces or actions: studies of contact take those).
Outcome<const Problem*> open_problem(const std::string& name, double until = 0);

/// Ids of src/studies/problems.tsv: the laws of motion of a problem, and its load where it has one.
std::vector<std::string> laws(const Problem& problem);
/// What the laws start from, for the problem's page: body, gravity, the state at t = 0. One a line.
std::vector<std::string> givens(const Problem& problem);

/// Distance of a computed end from the reference.
struct Errors {
  double attitude;  ///< rad
  double momentum;  ///< angular, relative to its size at the start or the end, whichever is larger
  double energy;    ///< relative to the kinetic energy at the start or the end
  double position;  ///< m
};
/// Whether an energy is no number any more, or above 2^53 times the one it should be: that one is then lost in its roundings.
inline bool left_the_numbers(double relative_energy) { return !(std::fabs(relative_energy) <= 0x1p53); }

Errors errors_of(const Problem& problem, const State<double>& end);

}  // namespace rigor::studies
