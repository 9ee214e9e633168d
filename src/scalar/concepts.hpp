#pragma once
#include <cmath>
#include <concepts>
#include <rigor/base/float_environment.hpp>  // refuses -ffast-math

namespace rigor {

/// + − × ÷ and order, and integers convert: all that most rigid-body formulas need. A formula on a Field runs
/// in double, in exact rationals and in recording scalars alike.
template <class T>
concept Field = requires(const T& a, const T& b) {
  T(1);
  { a + b } -> std::convertible_to<T>;
  { a - b } -> std::convertible_to<T>;
  { a* b } -> std::convertible_to<T>;
  { a / b } -> std::convertible_to<T>;
  { -a } -> std::convertible_to<T>;
  { a < b } -> std::convertible_to<bool>;
  { a == b } -> std::convertible_to<bool>;
};

namespace detail {
using std::cos, std::sin, std::sqrt;
template <class T>
concept HasSqrt = requires(const T& a) { { sqrt(a) } -> std::convertible_to<T>; };
template <class T>
concept HasAngles = requires(const T& a) {
  { sin(a) } -> std::convertible_to<T>;
  { cos(a) } -> std::convertible_to<T>;
};
}  // namespace detail

/// A Field with square roots: norms, Gram-Schmidt. (Rational has a square root that refuses non-squares.)
template <class T>
concept Rooted = Field<T> && detail::HasSqrt<T>;

/// Roots and angles.
template <class T>
concept Real = Rooted<T> && detail::HasAngles<T>;

}  // namespace rigor
