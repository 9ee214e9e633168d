#pragma once
#include <cmath>
#include <limits>
#include <rigor/scalar/concepts.hpp>

namespace rigor {

/// Arithmetic-geometric mean of two positive numbers. Source: DLMF 19.8.1.
template <Real T>
T agm(T a, T b) {
  using std::sqrt;
  const T eps = std::numeric_limits<T>::epsilon();
  for (int i = 0; i < 60; ++i) {  // quadratic: 60 is out of reach
    const T mean = (a + b) / T(2), root = sqrt(a * b);
    a = mean, b = root;
    const T gap = a < b ? b - a : a - b;
    if (gap <= T(4) * eps * a) break;
  }
  return (a + b) / T(2);
}

/// Carlson's symmetric integral R_F(x, y, z) = ½ ∫₀^∞ dt / √((t+x)(t+y)(t+z)), x, y, z ≥ 0, at most one of them 0.
/// Duplication until the seventh-order series is exact to rounding. Source: DLMF 19.36.1.
template <Real T>
T carlson_rf(T x, T y, T z) {
  using std::pow, std::sqrt;
  const auto size = [](const T& a) { return a < T(0) ? -a : a; };
  T mean = (x + y + z) / T(3), shrink = T(1);
  const T dx = mean - x, dy = mean - y;
  T spread = size(dx);
  for (const T& d : {size(dy), size(T(mean - z))})
    if (spread < d) spread = d;
  spread = spread / pow(std::numeric_limits<T>::epsilon() / T(4), T(1) / T(8));
  for (int i = 0; i < 400 && !(shrink * spread < size(mean)); ++i) {
    const T rx = sqrt(x), ry = sqrt(y), rz = sqrt(z), lambda = rx * ry + rx * rz + ry * rz;
    mean = (mean + lambda) / T(4);
    x = (x + lambda) / T(4), y = (y + lambda) / T(4), z = (z + lambda) / T(4);
    shrink = shrink / T(4);
  }
  const T X = dx * shrink / mean, Y = dy * shrink / mean, Z = -X - Y;
  const T e2 = X * Y - Z * Z, e3 = X * Y * Z;
  const T series = T(1) - e2 / T(10) + e3 / T(14) + e2 * e2 / T(24) - T(3) * e2 * e3 / T(44) -
                   T(5) * e2 * e2 * e2 / T(208) + T(3) * e3 * e3 / T(104) + e2 * e2 * e3 / T(16);
  return series / sqrt(mean);
}

}  // namespace rigor
