#pragma once
#include <rigor/linalg/types.hpp>
#include <rigor/scalar/rational.hpp>

namespace rigor {

/// a + b ε with ε² = 0 over the rationals: a formula run on it yields its exact derivative as the second
/// part.
struct Dual {
  Rational value, slope;

  Dual() = default;
  explicit Dual(int i) : value(i) {}
  Dual(Rational v, Rational s) : value(std::move(v)), slope(std::move(s)) {}
  friend Dual operator+(const Dual& a, const Dual& b) { return {a.value + b.value, a.slope + b.slope}; }
  friend Dual operator-(const Dual& a, const Dual& b) { return {a.value - b.value, a.slope - b.slope}; }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.slope * b.value + a.value * b.slope};
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    return {a.value / b.value, (a.slope * b.value - a.value * b.slope) / (b.value * b.value)};
  }
  friend Dual operator-(const Dual& a) { return {-a.value, -a.slope}; }
  friend bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend bool operator==(const Dual& a, const Dual& b) { return a.value == b.value && a.slope == b.slope; }
};

/// x + ε x_dot, component by component.
template <int N>
Eigen::Matrix<Dual, N, 1> moving(const Eigen::Matrix<Rational, N, 1>& x,
                                 const Eigen::Matrix<Rational, N, 1>& x_dot) {
  Eigen::Matrix<Dual, N, 1> both;
  for (int i = 0; i < N; ++i) both[i] = Dual(x[i], x_dot[i]);
  return both;
}

template <int N, int M>
Eigen::Matrix<Rational, N, M> slope_of(const Eigen::Matrix<Dual, N, M>& x) {
  Eigen::Matrix<Rational, N, M> slope;
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < M; ++j) slope(i, j) = x(i, j).slope;
  return slope;
}

}  // namespace rigor

template <>
struct Eigen::NumTraits<rigor::Dual> : Eigen::GenericNumTraits<rigor::Dual> {
  using Real = rigor::Dual;
  using NonInteger = rigor::Dual;
  using Nested = rigor::Dual;
  using Literal = rigor::Dual;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 20,
    AddCost = 200,
    MulCost = 300
  };
};
