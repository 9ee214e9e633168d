#pragma once
#include <limits>

namespace rigor {

/// u: the largest relative error of one rounding to nearest (2^-53 for double).
template <class T>
constexpr T unit_roundoff() {
  return std::numeric_limits<T>::epsilon() / 2;
}

/// γ(k) = k u / (1 − k u): the relative error that k roundings in a row can add up to.
/// Source: Higham, Accuracy and Stability of Numerical Algorithms, section 3.1.
template <class T = double>
constexpr T gamma_bound(int k) {
  const T ku = T(k) * unit_roundoff<T>();
  return ku / (1 - ku);
}

}  // namespace rigor
