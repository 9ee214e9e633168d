// The functions an exact flight is made of, against 60 digits.
#include <gtest/gtest.h>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/sin_pi.hpp>
#include <cmath>
#include <functional>
#include <random>
#include <reference/precise.hpp>
#include <rigor/engine/elliptic.hpp>
#include <rigor/engine/flight_lane.hpp>

namespace rigor {
namespace {

using P = reference::Precise;

// Worst error and mean error, in units of the last place of the result. Rounding has a mean near 0; a wrong last digit of a
// coefficient has not.
struct Error {
  double worst = 0, sum = 0;
  int count = 0;
  void add(double got, const P& want) {
    const double w = double(want), ulp = std::nextafter(std::fabs(w), INFINITY) - std::fabs(w), e = double((P(got) - want) / P(ulp));
    worst = std::fmax(worst, std::fabs(e)), sum += w < 0 ? -e : e, ++count;
  }
  double mean() const { return std::fabs(sum / count); }
};
struct Range {
  double low, high;
};
Error over(const Range& range, const std::function<double(double)>& f, const std::function<P(const P&)>& exact) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> U(range.low, range.high);
  Error error;
  for (int k = 0; k < 5000; ++k) {
    const double x = U(random);
    error.add(f(x), exact(P(x)));
  }
  return error;
}
// The mean: four sigmas of 5000 errors of 0.3 ulp are 0.02; the roundings of the leading coefficients give 0.065 for the sine and,
// with half of π² rounded by 0.3e-15, 0.19 for the cosine.
void expect_good(const Error& e, double worst, double mean, const char* what) {
  EXPECT_LT(e.worst, worst) << what;
  EXPECT_LT(e.mean(), mean) << what;
}

TEST(Elementary, SineAndCosineOfHalfTurnsAreGoodToAnUlp) {
  const auto sine = [](double x) { double s, c; return detail::sincospi(x, s, c), s; };
  const auto cosine = [](double x) { double s, c; return detail::sincospi(x, s, c), c; };
  const auto exact_sine = [](const P& x) { return P(sin(pi<P>() * x)); };
  const auto exact_cosine = [](const P& x) { return P(cos(pi<P>() * x)); };
  for (const Range& r : {Range{1e-9, 1e-8}, {0.01, 0.02}, {0.1, 0.13}, {0.2, 0.22}, {0.24, 0.25}}) {
    expect_good(over(r, sine, exact_sine), 1.1, 0.09, "sine");
    expect_good(over(r, cosine, exact_cosine), 1.1, 0.25, "cosine");
  }
  // every quarter, and far away: the argument is exact, so the result is as good
  for (const double turns : {0.5, 1.0, 1.5, 2.0, -0.5, -3.0, 1e6 + 0.5, -1e6, 0x1p29 + 1.5}) {
    expect_good(over({turns + 0.01, turns + 0.25}, sine, exact_sine), 1.1, 0.09, "sine");
    expect_good(over({turns - 0.25, turns - 0.01}, cosine, exact_cosine), 1.1, 0.25, "cosine");
  }
}

TEST(Elementary, TheExponentialIsGoodToAnUlp) {
  const auto exact = [](const P& x) { return P(exp(x)); };
  for (const Range& r : {Range{-0.05, 0.05}, {0.33, 0.3465}, {-0.3465, -0.33}, {0.35, 5}, {-5, -0.35}, {300, 690}, {-690, -300}})
    expect_good(over(r, detail::exp_of, exact), 1.1, 0.05, "exp");
}

TEST(Elementary, HyperbolicSineAndCosineAreGoodToThreeUlp) {
  const auto sine = [](double x) { double s, c; return detail::sinh_cosh(x, s, c), s; };
  const auto cosine = [](double x) { double s, c; return detail::sinh_cosh(x, s, c), c; };
  for (const Range& r : {Range{1e-9, 1e-8}, {0.1, 0.12}, {0.3, 0.34}, {-0.34, -0.3}, {0.36, 0.4}, {1, 2}, {-9, -3}, {200, 345}}) {
    const Error s = over(r, sine, [](const P& x) { return P(sinh(x)); }), c = over(r, cosine, [](const P& x) { return P(cosh(x)); });
    EXPECT_LT(s.worst, 3.5) << r.low;
    EXPECT_LT(c.worst, 2) << r.low;
    EXPECT_TRUE(std::fabs(r.low) > 0.35 || s.mean() < 0.06) << r.low << ": the series";
  }
}

// In 60 digits every coefficient of the series counts; in double and long double, what is rounded.
template <class T>
double worst_of_carlson() {
  using std::abs;
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> U(0, 1);
  double worst = 0;
  for (int k = 0; k < 400; ++k) {
    double v[3];  // from equal but for a part in 1e3 to a million to one, and 0
    for (double& x : v) x = k % 4 == 0 ? 1 + 1e-3 * U(random) : k % 4 == 1 ? 1 + 0.1 * U(random) : std::pow(10, 6 * U(random) - 3);
    if (k % 7 == 0) v[k % 3] = 0;
    const P want = boost::math::ellint_rf(P(v[0]), P(v[1]), P(v[2]));
    const P off = (P(carlson_rf<T>(T(v[0]), T(v[1]), T(v[2]))) - want) / want;
    worst = std::fmax(worst, double(abs(off)));
  }
  return worst;
}
TEST(Elementary, CarlsonsIntegralIsGoodToRounding) {
  EXPECT_LT(worst_of_carlson<double>(), 4 * 0x1p-52);
  EXPECT_LT(worst_of_carlson<long double>(), 4 * 0x1p-63);
  EXPECT_LT(worst_of_carlson<P>(), 1e-58);
}

// K(m) = π / 2 agm(1, √(1 − m)).
TEST(Elementary, TheMeanGivesTheQuarterPeriod) {
  using std::abs, std::sqrt;
  for (const double m : {0.0, 0.1, 0.5, 0.9, 1 - 1e-6, 1 - 1e-14}) {
    const P want = pi<P>() / 2 / boost::math::ellint_1(P(sqrt(P(m))));
    EXPECT_LT(double(abs(agm<P>(P(1), sqrt(P(1) - P(m))) / want - 1)), 1e-58 / (1 - m)) << m;  // what 1 - m loses in the witness
    EXPECT_LT(double(abs(agm<P>(sqrt(P(1) - P(m)), P(1)) / want - 1)), 1e-58 / (1 - m)) << m;  // what 1 - m loses in the witness
  }
}

}  // namespace
}  // namespace rigor
