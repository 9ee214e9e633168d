#pragma once
#include <type_traits>

namespace rigor {

/// A sum as floating point gives it, and what it lost: a + b = sum + error exactly, unless it overflows (Knuth). T: double, or a
/// vector of them, each by itself.
template <typename T>
struct TwoSum {
  T sum, error;
};
template <typename T>
TwoSum<T> two_sum(const T& a, const T& b) {
  const T sum = a + b, part = sum - a, rest = sum - part;
  return {sum, (a - rest) + (b - part)};
}

/// A sum of many terms with their roundings carried: off by one rounding of its value and n² u² of the sum of absolute values.
template <typename T>
struct Carried {
  T sum = zero(), carry = zero();
  void operator+=(const T& x) {
    const TwoSum<T> next = two_sum<T>(sum, x);
    sum = next.sum, carry += next.error;
  }
  void operator-=(const T& x) { *this += T(-x); }
  T value() const { return sum + carry; }

 private:
  static T zero() {
    if constexpr (std::is_arithmetic_v<T>) return 0;
    else return T::Zero();
  }
};

}  // namespace rigor
