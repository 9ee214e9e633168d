#pragma once
#include <Eigen/Core>
#include <compare>
#include <concepts>

namespace rigor {

/// A field and nothing more: a formula that compiles for Strict has no decimal literal and no hidden root.
/// Used for explicit instantiation only; the numbers mean nothing.
struct Strict {
  Strict() = default;
  explicit Strict(int) {}
  template <std::floating_point F>
  Strict(F) = delete;
  friend Strict operator+(Strict, Strict) { return Strict(0); }
  friend Strict operator-(Strict, Strict) { return Strict(0); }
  friend Strict operator*(Strict, Strict) { return Strict(0); }
  friend Strict operator/(Strict, Strict) { return Strict(0); }
  friend Strict operator-(Strict) { return Strict(0); }
  Strict& operator+=(Strict) { return *this; }
  Strict& operator-=(Strict) { return *this; }
  Strict& operator*=(Strict) { return *this; }
  Strict& operator/=(Strict) { return *this; }
  friend auto operator<=>(Strict, Strict) = default;
};

}  // namespace rigor

template <>
struct Eigen::NumTraits<rigor::Strict> : Eigen::GenericNumTraits<rigor::Strict> {
  using Real = rigor::Strict;
  using NonInteger = rigor::Strict;
  using Nested = rigor::Strict;
  using Literal = rigor::Strict;
  enum {
    IsComplex = 0, IsInteger = 0, IsSigned = 1, RequireInitialization = 1, ReadCost = 1, AddCost = 1, MulCost = 1
  };
};
