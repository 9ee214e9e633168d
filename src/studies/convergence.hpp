#pragma once
#include <functional>
#include <rigor/base/outcome.hpp>
#include <rigor/studies/problem.hpp>
#include <string>
#include <vector>

namespace rigor::studies {

/// One run of the ladder. A run that went wrong has NaN errors and says why: failures are rows, not gaps.
struct Run {
  long steps;
  double h;  ///< s
  Errors error;
  double cpu_s = 0;  ///< median of the repeats, thread time
};

/// A method on a problem over a ladder of steps.
struct Ladder {
  const Method* method;
  const Problem* problem;
  std::vector<Run> runs;
  double order = 0;        ///< fitted to the attitude error over the window; NaN when too few points lie in it
  int used = 0;            ///< points in the window: error between 300 times the smallest seen and 1e-3 of a radian or less
};

/// Steps of one method: `steps` equal steps to the problem's end. The load is taken at the middle of each step.
State<double> integrate(const Problem& problem, const Method& method, long steps);

/// Halves the step `rungs` times from `coarsest` steps. Stops early when interrupted.
Ladder converge(const Problem& problem, const Method& method, long coarsest, int rungs, int repeats = 1);

/// Least-squares slope of log error against log h over the points in the asymptotic window.
double fitted_order(const std::vector<Run>& runs, int& used);

/// Pairwise order, extrapolated value and grid convergence index of three systematically refined results (ASME V&V 20).
struct Gci {
  double order, extrapolated;
  double fine, coarse;       ///< 1.25 |f1 − f2|/|f1|/(r^p − 1), and the same one level up
  double asymptotic;         ///< near 1 when the three are in the asymptotic range
};
Gci grid_convergence(double finest, double medium, double coarsest, double ratio);

std::string convergence_csv(const std::vector<Ladder>& ladders);
std::string convergence_json(const std::vector<Ladder>& ladders, const std::string& command);
/// `kind` "convergence" plots error against h, "work-precision" CPU time against error.
std::string convergence_html(const std::vector<Ladder>& ladders, const std::string& kind, const std::string& command);
std::string convergence_text(const std::vector<Ladder>& ladders);

}  // namespace rigor::studies
