#pragma once
#include <Eigen/Core>
#include <cmath>

namespace rigor {

/// A number together with the absolute sum of the terms it was made from: what rounding bounds of the form
/// γ_k · (absolute sum) are about. Run a formula on it, and `size` of the result is that sum.
///
///     |a ± b| ≤ size(a) + size(b),   size(ab) = size(a) size(b),   size(a/b) = size(a) size(b)/b²,  √: √size
///
/// A quotient or root of a number that has itself cancelled counts the cancellation (size(b)/|b| ≥ 1).
struct Magnitude {
  double value = 0, size = 0;

  Magnitude() = default;
  Magnitude(int i) : value(i), size(std::abs(double(i))) {}
  explicit Magnitude(double x) : value(x), size(std::abs(x)) {}
  Magnitude(double x, double s) : value(x), size(s) {}

  friend Magnitude operator+(const Magnitude& a, const Magnitude& b) { return {a.value + b.value, a.size + b.size}; }
  friend Magnitude operator-(const Magnitude& a, const Magnitude& b) { return {a.value - b.value, a.size + b.size}; }
  friend Magnitude operator*(const Magnitude& a, const Magnitude& b) { return {a.value * b.value, a.size * b.size}; }
  friend Magnitude operator/(const Magnitude& a, const Magnitude& b) {
    return {a.value / b.value, a.size * b.size / (b.value * b.value)};
  }
  friend Magnitude operator-(const Magnitude& a) { return {-a.value, a.size}; }
  friend Magnitude sqrt(const Magnitude& a) {
    const double root = std::sqrt(a.value);
    return {root, a.value > 0 ? a.size / root : std::sqrt(a.size)};
  }
  friend bool operator<(const Magnitude& a, const Magnitude& b) { return a.value < b.value; }
  friend bool operator>(const Magnitude& a, const Magnitude& b) { return a.value > b.value; }
  friend bool operator<=(const Magnitude& a, const Magnitude& b) { return a.value <= b.value; }
  friend bool operator>=(const Magnitude& a, const Magnitude& b) { return a.value >= b.value; }
  friend bool operator==(const Magnitude& a, const Magnitude& b) { return a.value == b.value; }
  Magnitude& operator+=(const Magnitude& o) { return *this = *this + o; }
  Magnitude& operator-=(const Magnitude& o) { return *this = *this - o; }
  Magnitude& operator*=(const Magnitude& o) { return *this = *this * o; }
  Magnitude& operator/=(const Magnitude& o) { return *this = *this / o; }
};

}  // namespace rigor

template <>
struct Eigen::NumTraits<rigor::Magnitude> : Eigen::GenericNumTraits<rigor::Magnitude> {
  using Real = rigor::Magnitude;
  using NonInteger = rigor::Magnitude;
  using Nested = rigor::Magnitude;
  using Literal = rigor::Magnitude;
  enum { IsComplex = 0, IsInteger = 0, IsSigned = 1, RequireInitialization = 1, ReadCost = 2, AddCost = 2, MulCost = 2 };
  static Real epsilon() { return Real(NumTraits<double>::epsilon()); }
  static Real dummy_precision() { return Real(NumTraits<double>::dummy_precision()); }
  static int digits10() { return 15; }
};
