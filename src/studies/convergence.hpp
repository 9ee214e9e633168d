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
  int used = 0;            ///< points in the window: see Fit
};

/// Steps of one method: `steps` equal steps to the problem's end, the load taken as `advance` takes it.
State<double> integrate(const Problem& problem, const Method& method, long steps);

/// Halves the step `rungs` times from `coarsest` steps. Stops early when interrupted.
Ladder converge(const Problem& problem, const Method& method, long coarsest, int rungs, int repeats = 1);

/// Where each run of a ladder, coarse to fine, lies. The ladder has come to rounding where its smallest error is below 1e-12,
/// or where, below 1e-8, a finer step gains less than half an order. Then a run within `margin` times that smallest error (of u at
/// least) is at the floor, and so is every finer one: roundings grow with the steps. Else an error of 0.1 and more is too coarse, and,
/// where the finest three or more agree within 0.3 on the order from one to the next, so is what comes before them; not of errors that
/// are not `smooth` in the step, as those through impacts are not.
enum class Place { used, too_coarse, at_floor, failed };  ///< failed: the error is NaN
std::vector<Place> places(const std::vector<double>& h, const std::vector<double>& error, double margin = 300, bool smooth = true);

/// Least-squares slope of log error against log h over the points that are used; NaN with fewer than three, and, of `smooth` errors, where
/// they are on no line: where the slope's standard error is above 0.3, the room an order has (on the standard problems it is 0.21 at most).
struct Fit {
  double order;
  int used, too_coarse, at_floor, failed;  ///< points, by their place
};
Fit fit_order(const std::vector<double>& h, const std::vector<double>& error, bool smooth = true);
double fitted_order(const std::vector<Run>& runs, int& used);

/// Pairwise order, extrapolated value and grid convergence index of three systematically refined results (ASME V&V 20).
struct Gci {
  double order, extrapolated;
  double fine, coarse;       ///< 1.25 |f1 − f2|/|f1|/(r^p − 1), and the same one level up
  double asymptotic;         ///< near 1 when the three are in the asymptotic range
};
Gci grid_convergence(double finest, double medium, double coarsest, double ratio);

}  // namespace rigor::studies
