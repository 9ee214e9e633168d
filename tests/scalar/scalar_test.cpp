#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <rigor/scalar/concepts.hpp>
#include <rigor/scalar/constants.hpp>
#include <rigor/scalar/cos_sinc.hpp>
#include <rigor/scalar/gamma.hpp>
#include <rigor/scalar/magnitude.hpp>
#include <rigor/scalar/rational.hpp>
#include <rigor/scalar/strict.hpp>
#include <type_traits>

namespace rigor {

using Q = Rational;

TEST(Rational, IsExactWhereDoublesAreNot) {
  EXPECT_EQ(Q(1, 10) + Q(2, 10), Q(3, 10));
  EXPECT_NE(Q::exactly(0.1) + Q::exactly(0.2), Q::exactly(0.3));
  EXPECT_EQ(Q::exactly(0.1), Q("3602879701896397/36028797018963968"));
  EXPECT_EQ(Q::exactly(-0x1p-1074) * Q(2), Q::exactly(-0x1p-1073));
  EXPECT_EQ(Q("-12"), Q(-12));
  EXPECT_EQ(Q(2, -4), Q(-1, 2));
  EXPECT_EQ(abs(Q(-3, 7)), Q(3, 7));
  EXPECT_LT(Q(1, 3), Q(334, 1000));
}

TEST(Rational, RefusesWhatWouldNotBeExact) {
  EXPECT_FALSE((std::is_constructible_v<Q, double>));
  EXPECT_THROW(Q(1) / Q(0), std::domain_error);
  EXPECT_THROW(Q(1, 0), std::domain_error);
  EXPECT_THROW(sqrt(Q(2)), std::domain_error);
  EXPECT_THROW(sqrt(Q(4, 3)), std::domain_error);
  EXPECT_THROW(sqrt(Q(-4)), std::domain_error);
  EXPECT_EQ(sqrt(Q(49, 36)), Q(7, 6));
  EXPECT_EQ(sqrt(Q(0)), Q(0));
}

TEST(Concepts, SayHowMuchAlgebraAScalarHas) {
  EXPECT_TRUE(Field<double> && Rooted<double> && Real<double>);
  EXPECT_TRUE(Field<Q> && Rooted<Q>);
  EXPECT_FALSE(Real<Q>);
  EXPECT_TRUE(Field<Strict>);
  EXPECT_FALSE(Rooted<Strict>);
  EXPECT_FALSE(Field<std::string>);
}

// γ(k) bounds k roundings in a row: (1 + u)^k − 1 ≤ γ(k), and it is not much more.
TEST(GammaBound, CoversKRoundingsAndLittleMore) {
  for (int k : {1, 2, 10, 100}) {
    Q product = 1;
    for (int i = 0; i < k; ++i) product = product * (Q(1) + Q::exactly(0x1p-53));
    const Q gamma = Q::exactly(gamma_bound(k));
    EXPECT_LT(product - Q(1), gamma);
    EXPECT_GT((product - Q(1)) * Q(1001, 1000), gamma);
  }
  EXPECT_EQ(unit_roundoff<double>(), 0x1p-53);
  EXPECT_EQ(unit_roundoff<float>(), 0x1p-24F);
}

TEST(Pi, IsTheNearestOfItsType) {
  EXPECT_EQ(pi<double>(), M_PI);
  EXPECT_LT(std::abs(std::sin((long double)pi<double>()) - ((long double)M_PIl - pi<double>())),
            1e-19L);  // sin(π − x) = x, to long double's 5e-20
  EXPECT_EQ(pi<float>(), float(M_PI));
}

// Against the C library in long double; angles from the joint of the two series at 1/2 to 1e12.
TEST(CosSinc, IsWithinWhatItSays) {
  std::mt19937_64 random(20260414);
  const double u = 0x1p-53;
  double near = 0, far = 0;
  for (const double top : {0.5, 0.51, 0.8, 1.6, 3.2, 10., 1e4, 1e8, 1e12})
    for (int k = 0; k < 20000; ++k) {
      const double x = top * (double(random() >> 11) * u), z = x * x;
      const long double exact = std::sqrt((long double)z);
      const CosSinc got = cos_sinc(z);
      const double off = double(std::fmax(std::fabs(got.cos - std::cos(exact)), std::fabs(got.sinc * exact - std::sin(exact))));
      if (z < 0.25) near = std::fmax(near, off / u);
      else far = std::fmax(far, off / (u * (1 + x)));
    }
  EXPECT_LT(near, 2);  // an ulp of cos there is 2^-53 or, near 1, less
  EXPECT_LT(far, 2);
  EXPECT_GT(far, 1) << "the bound is not idle";
}
TEST(CosSinc, HasAnAnswerForEveryNumber) {
  EXPECT_EQ(cos_sinc(0).cos, 1);
  EXPECT_EQ(cos_sinc(0).sinc, 1);
  EXPECT_EQ(cos_sinc(1e300).cos, 1);
  EXPECT_EQ(cos_sinc(1e300).sinc, 0);
  EXPECT_TRUE(std::isnan(cos_sinc(NAN).cos) && std::isnan(cos_sinc(NAN).sinc));
}

// size(x) is the sum of the absolute values of what was added up to x.
TEST(Magnitude, AddsAbsoluteValuesWhereTheNumberSubtracts) {
  const Magnitude a(3.0), b(5.0);
  EXPECT_EQ((a - b).value, -2);
  EXPECT_EQ((a - b).size, 8);
  EXPECT_EQ(((a - b) * b).size, 40);
  EXPECT_EQ((b / (a - b)).value, -2.5);
  EXPECT_EQ((b / (a - b)).size, 5.0 * 8 / 4);  // the cancelled divisor counts
  EXPECT_EQ((-a).size, 3);
}

}  // namespace rigor
