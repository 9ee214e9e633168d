#pragma once
#include <Eigen/Core>
#include <boost/multiprecision/gmp.hpp>
#include <ostream>
#include <stdexcept>
#include <string>

namespace rigor {

/// An exact rational number (GMP). Programs that use it link gmp.
///
/// A wrapper rather than the bare Boost number, for three reasons: no conversion from double (a stray 0.5 in a
/// formula does not compile), a square root that refuses anything but perfect squares, and Boost 1.74's number
/// is a hard error inside some Eigen 3.4 expressions. Throws std::domain_error on division by zero.
class Rational {
 public:
  using Fraction =
      boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;
  using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

  Rational() : value_(0) {}
  Rational(int i) : value_(i) {}
  Rational(long i) : value_(i) {}
  /// Any sign; a zero denominator throws. (Boost 1.74's own two-argument constructor reads −4 as 2^64 − 4.)
  Rational(long numerator, long denominator) : value_(numerator) { *this /= Rational(denominator); }
  explicit Rational(Fraction value) : value_(std::move(value)) {}
  /// "3/7" or "-12".
  explicit Rational(const std::string& digits) : value_(digits) {}
  Rational(double) = delete;
  /// Exactly the value of a double, for comparing double results with exact ones.
  static Rational exactly(double x) { return Rational(Fraction(x)); }

  const Fraction& fraction() const { return value_; }
  explicit operator double() const { return value_.convert_to<double>(); }

  Rational& operator+=(const Rational& o) { return value_ += o.value_, *this; }
  Rational& operator-=(const Rational& o) { return value_ -= o.value_, *this; }
  Rational& operator*=(const Rational& o) { return value_ *= o.value_, *this; }
  Rational& operator/=(const Rational& o) {
    if (o.value_ == 0) throw std::domain_error("Rational: division by zero");
    return value_ /= o.value_, *this;
  }
  friend Rational operator+(Rational a, const Rational& b) { return a += b; }
  friend Rational operator-(Rational a, const Rational& b) { return a -= b; }
  friend Rational operator*(Rational a, const Rational& b) { return a *= b; }
  friend Rational operator/(Rational a, const Rational& b) { return a /= b; }
  friend Rational operator-(const Rational& a) { return Rational(Fraction(-a.value_)); }
  friend bool operator==(const Rational& a, const Rational& b) { return a.value_ == b.value_; }
  friend bool operator!=(const Rational& a, const Rational& b) { return a.value_ != b.value_; }
  friend bool operator<(const Rational& a, const Rational& b) { return a.value_ < b.value_; }
  friend bool operator>(const Rational& a, const Rational& b) { return b < a; }
  friend bool operator<=(const Rational& a, const Rational& b) { return !(b < a); }
  friend bool operator>=(const Rational& a, const Rational& b) { return !(a < b); }
  friend std::ostream& operator<<(std::ostream& out, const Rational& a) { return out << a.value_; }

 private:
  Fraction value_;
};

/// Exact, or std::domain_error: tests choose points whose roots exist; anything else would be a rounding.
inline Rational sqrt(const Rational& x) {
  using Integer = Rational::Integer;
  if (x < Rational(0)) throw std::domain_error("Rational: root of a negative number");
  const Integer n(numerator(x.fraction())), d(denominator(x.fraction()));
  const Integer root_n = boost::multiprecision::sqrt(n), root_d = boost::multiprecision::sqrt(d);
  if (root_n * root_n != n || root_d * root_d != d) throw std::domain_error("Rational: not a perfect square");
  return Rational(Rational::Fraction(root_n) / Rational::Fraction(root_d));
}

inline Rational abs(const Rational& x) { return x < Rational(0) ? -x : x; }

}  // namespace rigor

template <>
struct Eigen::NumTraits<rigor::Rational> : Eigen::GenericNumTraits<rigor::Rational> {
  using Real = rigor::Rational;
  using NonInteger = rigor::Rational;
  using Nested = rigor::Rational;
  using Literal = rigor::Rational;
  enum {
    IsComplex = 0, IsInteger = 0, IsSigned = 1, RequireInitialization = 1, ReadCost = 10, AddCost = 100, MulCost = 100
  };
  static Real epsilon() { return 0; }
  static Real dummy_precision() { return 0; }
  static int digits10() { return 0; }
};
