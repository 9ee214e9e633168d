#pragma once
#include <cmath>
#include <limits>

namespace rigor {

/// First δ > 0 with s + r δ + c δ²/2 = 0, for s ≥ 0; infinity when there is none. s = 0 with r ≥ 0 starts in front, s = 0 with
/// r < 0 gives 0.
inline double first_root(double s, double r, double c) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (c >= 0) {
    if (r >= 0) return infinity;
    const double disc = r * r - 2 * c * s;
    return disc < 0 ? infinity : 2 * s / (-r + std::sqrt(disc));
  }
  const double root = std::sqrt(r * r - 2 * c * s);
  return r > 0 ? (r + root) / -c : s > 0 ? 2 * s / (root - r) : 0;
}

}  // namespace rigor
