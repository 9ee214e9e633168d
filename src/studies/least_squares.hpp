#pragma once
#include <cmath>
#include <numeric>
#include <vector>

namespace rigor::studies {

/// The line of least squares through points: its slope, and the standard error of that by the points' distances from it.
struct Line {
  double slope, standard_error;
};
/// Precondition: at least three points, not all of one x.
inline Line least_squares(const std::vector<double>& x, const std::vector<double>& y) {
  const double n = double(x.size()), x_mean = std::accumulate(x.begin(), x.end(), 0.0) / n, y_mean = std::accumulate(y.begin(), y.end(), 0.0) / n;
  double xx = 0, xy = 0, left = 0;
  for (std::size_t i = 0; i < x.size(); ++i) xx += (x[i] - x_mean) * (x[i] - x_mean), xy += (x[i] - x_mean) * (y[i] - y_mean);
  const double slope = xy / xx;
  for (std::size_t i = 0; i < x.size(); ++i) left += std::pow(y[i] - y_mean - slope * (x[i] - x_mean), 2);
  return {slope, std::sqrt(left / (n - 2) / xx)};
}

}  // namespace rigor::studies
