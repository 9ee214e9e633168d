#pragma once
#include <cmath>
#include <random>
#include <rigor/linalg/types.hpp>

namespace rigor {

/// Uniform in [low, high) from 53 random bits: the same on every platform, as std::uniform_real_distribution need not be.
inline double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * (double(random() >> 11) * 0x1p-53);
}

/// A random unit vector with y made non-negative, as the assignment's program draws directions.
inline Vec3<double> upward_direction(std::mt19937_64& random) {
  for (;;) {
    const double x = uniform(random, -1, 1), y = uniform(random, -1, 1), z = uniform(random, -1, 1);
    const Vec3<double> a(x, y, z);
    const double length = norm<double>(a);
    if (length <= 1 && length >= 1e-3) return Vec3<double>(x / length, std::fabs(y) / length, z / length);
  }
}

}  // namespace rigor
