// Taylor series of any load by arithmetic on series, against closed forms, invariants and CVODE.
#include <gtest/gtest.h>

#include <cmath>
#include <reference/jet.hpp>
#include <reference/precise.hpp>
#include <reference/sundials.hpp>

namespace rigor::reference {
namespace {

using P = Precise;
using J = Jet<P>;

TEST(Jet, FunctionsHaveTheirSeries) {
  const int n = 20;
  std::vector<P> t(std::size_t(n + 1), P(0));
  t[1] = 1;
  const J x(t), e = exp(x), s = sin(x), c = cos(x), r = sqrt(J(P(1)) + x), geometric = J(P(1)) / (J(P(1)) - x), one = s * s + c * c;
  P factorial = 1, binomial = 1;
  for (int k = 0; k <= n; ++k) {
    const std::size_t i = std::size_t(k);
    EXPECT_LT(double(abs(P(e[i] - 1 / factorial))), 1e-58);
    EXPECT_LT(double(abs(P(s[i] - (k % 2 == 0 ? P(0) : P((k % 4 == 1 ? 1 : -1) / factorial))))), 1e-58);
    EXPECT_EQ(geometric[i], P(1));
    EXPECT_LT(double(abs(P(r[i] - binomial))), 1e-57) << "binomial series of (1 + x)^(1/2)";
    EXPECT_LT(double(abs(P(one[i] - (k == 0 ? 1 : 0)))), 1e-57);
    factorial *= k + 1;
    binomial *= (P(1) / 2 - k) / (k + 1);
  }
}

// case D-15 with digits from elsewhere.
TEST(Jet, FollowsKroghsProblem) {
  const auto f = [](const J&, const std::vector<J>& y) { return std::vector<J>{y[1] * y[2], -y[0] * y[2], J(-P(51) / 100) * y[0] * y[1]}; };
  const std::vector<P> y = taylor<P>(f, {0, 1, 1}, P(0), P(12), 24, 60);
  EXPECT_LT(double(abs(P(y[0] - P("-0.7053978095225717430")))), 1e-18);
  EXPECT_LT(double(abs(P(y[1] - P("-0.7088116324671580851")))), 1e-18);
  EXPECT_LT(double(abs(P(y[2] - P("0.8638466903702221007")))), 1e-18);
}

// case F-06: Kovalevskaya's top, whose fourth invariant, energy and L.gamma are constant. In 60 digits nothing is left to chance:
// a law with a torque that depends on the attitude.
TEST(Jet, KeepsKovalevskayasInvariants) {
  const P I1 = 2, I3 = 1, p = P(3) / 2;  // P along axis 1, torque P x (-gamma)
  const auto f = [&](const J&, const std::vector<J>& y) {
    const J &a = y[0], &b = y[1], &c = y[2], &g = y[3], &k = y[4], &l = y[5];
    return std::vector<J>{J((I1 - I3) / I1) * b * c, J((I3 - I1) / I1) * c * a + J(p / I1) * l, J(-p / I3) * k, k * c - l * b, l * a - g * c, g * b - k * a};
  };
  const auto invariants = [&](const std::vector<P>& y) {
    const P re = y[0] * y[0] - y[1] * y[1] - p / I3 * y[3], im = 2 * y[0] * y[1] - p / I3 * y[4];
    const P energy = (I1 * (y[0] * y[0] + y[1] * y[1]) + I3 * y[2] * y[2]) / 2 + p * y[3];
    return std::vector<P>{re * re + im * im, energy, I1 * (y[0] * y[3] + y[1] * y[4]) + I3 * y[2] * y[5]};
  };
  const std::vector<P> start{P(1) / 2, P(-6) / 5, P(2), P(2) / 3, P(-1) / 3, P(2) / 3}, end = taylor<P>(f, start, P(0), P(4), 30, 100);
  const auto before = invariants(start), after = invariants(end);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_LT(double(abs(P(after[i] - before[i]))), 1e-25) << i;
  const Rhs plain = [](double, std::span<const double> y, std::span<double> d) {
    d[0] = 0.5 * y[1] * y[2], d[1] = -0.5 * y[2] * y[0] + 0.75 * y[5], d[2] = -1.5 * y[4];
    d[3] = y[4] * y[2] - y[5] * y[1], d[4] = y[5] * y[0] - y[3] * y[2], d[5] = y[3] * y[1] - y[4] * y[0];
  };
  const auto cvode_end = cvode(plain, {0.5, -1.2, 2, 2 / 3., -1 / 3., 2 / 3.}, 0, 4, 1e-14);
  ASSERT_TRUE(cvode_end);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(double(end[i]), cvode_end->y[i], 1e-11);
}

// A load that depends on time and speed through every function there is, with a closed form: v' = -v cos t, x' = exp(-sin t)/sqrt(1 + t).
TEST(Jet, FollowsALoadInTime) {
  const auto f = [](const J& t, const std::vector<J>& y) { return std::vector<J>{-y[0] * cos(t), exp(-sin(t)) / sqrt(J(P(1)) + t) - y[0] / sqrt(J(P(1)) + t)}; };
  const std::vector<P> y = taylor<P>(f, {1, 3}, P(0), P(2), 30, 20);
  EXPECT_LT(double(abs(P(y[0] - exp(P(-sin(P(2))))))), 1e-25);
  EXPECT_LT(double(abs(P(y[1] - 3))), 1e-25) << "the two parts cancel";
}

}  // namespace
}  // namespace rigor::reference
