// The closed form from theta series, in four precisions, against the Taylor series: neither formula nor code in common.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <reference/gsl_flight.hpp>
#include <reference/taylor.hpp>
#include <reference/theta_flight.hpp>
#include <rigor/linalg/rotation.hpp>

namespace rigor::reference {
namespace {

using P = Precise;
using V = Vec3<double>;
const Mat3<double> generic = rotation_of<double>(Vec4<double>(1, 2, -1, 3));
const V moments(13 / 12., 10 / 12., 5 / 12.);
const V spins[3] = {{0.3, 2, 0.2}, {5, 0.01, 0.01}, {1e-6, 2, 1e-6}};  // cases A, B, C

// rad, the difference taken in 60 digits
template <class T>
double off(const Mat3<T>& R, const Mat3<P>& want) {
  P sum = 0;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      const P d = P(R(i, k)) - want(i, k);
      sum += d * d;
    }
  return std::sqrt(double(sum) / 2);
}
template <>
double off<Quad>(const Mat3<Quad>& R, const Mat3<P>& want) {  // 113 bits as a sum of two long doubles: exact
  Mat3<P> whole;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      const long double high = static_cast<long double>(R(i, k));
      whole(i, k) = P(high) + P(static_cast<long double>(Quad(R(i, k) - Quad(high))));
    }
  return off<P>(whole, want);
}
template <class T>
double error(const FreeBody& body, double t, const Attitude<P>& want) {
  return off<T>(ThetaFlight<T>(body).at(T(t)).R_WB, want.R_WB);
}

// Bars: a few tens of u each; measured 1.8e-15, 1.6e-17, 1.2e-32, 8.4e-59 on A and B.
TEST(ThetaFlight, AgreesWithTheSeriesInEveryPrecision) {
  std::printf("closed form by theta series against 60-digit Taylor at t = 10, rad\n%6s %10s %12s %10s %10s\n", "case", "double", "long double", "113 bits", "60 digits");
  for (int k = 0; k < 3; ++k) {
    const FreeBody body{moments, spins[k], generic};
    const auto want = taylor_free_body<P>(body, P(10));
    const double e[4] = {error<double>(body, 10, want), error<long double>(body, 10, want), error<Quad>(body, 10, want), error<P>(body, 10, want)};
    std::printf("%6c %10.1e %12.1e %10.1e %10.1e\n", "ABC"[k], e[0], e[1], e[2], e[3]);
    const double loss = k == 2 ? 1e4 : 1;  // next to the separatrix D cancels in double: 1e-12 of its relative size
    EXPECT_LT(e[0], 1e-13 * loss);
    EXPECT_LT(e[1], 1e-16 * loss);
    EXPECT_LT(e[2], 1e-31 * loss);
    EXPECT_LT(e[3], 1e-45);
    const Vec3<P> w = ThetaFlight<P>(body).at(P(10)).w_B;
    for (int i = 0; i < 3; ++i) EXPECT_LT(double(abs(P(w[i] - want.w_B[i]))), 1e-45);
  }
}

TEST(ThetaFlight, HoldsForEveryDegenerateMotion) {
  const struct {
    const char* what;
    V I, w;
  } degenerate[] = {
      {"sphere", {2, 2, 2}, {0.3, -1, 0.7}},
      {"symmetric top", {2, 2, 1}, {0.3, -1, 0.7}},
      {"symmetric top, flat", {1, 1, 1.9}, {0.3, -1, 0.7}},
      {"symmetric top, across", {2, 2, 1}, {0.3, -1, 0}},
      {"separatrix, exactly", {1, 3, 6}, {3, 1, 1}},
      {"nearly symmetric", {2, 2 + 2e-9, 1}, {0.3, -1, 0.2}},
      {"unstable axis", {1, 2, 2.5}, {0, 2, 0}},
      {"unstable axis but for 1e-15", {1, 2, 2.5}, {1e-15, 2, 1e-15}},
      {"stable axis", {1, 2, 2.5}, {0, 0, 3}},
      {"stable axis but for 1e-100", {1, 2, 2.5}, {1e-100, 0, 3}},
      {"principal plane", {1, 2, 2.5}, {0, 0.3, 2}},
      {"the other", {1, 2, 2.5}, {0.3, 0, 2}},
      {"negative spins", {1, 2, 2.5}, {-0.3, -0.4, -2}},
      {"at rest", {1, 2, 2.5}, {0, 0, 0}},
  };
  for (const auto& d : degenerate) {
    const FreeBody body{d.I, d.w, generic};
    const auto want = taylor_free_body<P>(body, P(2));
    EXPECT_LT(error<P>(body, 2, want), 1e-40) << d.what;
    EXPECT_LT(error<long double>(body, 2, want), 1e-13) << d.what;
  }
}

// What GSL's interface costs next to the separatrix: it takes m, and an ulp of m is u/(1 - m) of the quarter period. The theta series
// carry 1 - m, so in double they lose what the cancellation of D costs and no more. case C of free-flight and closer ones.
TEST(ThetaFlight, ShowsWhatGslLosesNextToTheSeparatrix) {
  std::printf("next to the separatrix, t = 10: error, rad\n%10s %10s %12s %12s\n", "w1 = w3", "1 - m", "GSL", "theta, double");
  double before = 0;
  for (const double small : {1e-2, 1e-4, 1e-6}) {
    const FreeBody body{moments, {small, 2, small}, generic};
    const auto want = taylor_free_body<P>(body, P(10));
    const double theta = error<double>(body, 10, want);
    const auto gsl = gsl_free_body(body, 10);
    ASSERT_TRUE(gsl);
    const double lost = off<double>(gsl->R_WB, want.R_WB);
    std::printf("%10.0e %10.1e %12.1e %12.1e\n", small, double(ThetaFlight<P>(body).complement()), lost, theta);
    EXPECT_GT(lost, before);
    before = lost;
    EXPECT_LT(theta, 1e-11);
  }
  EXPECT_GT(before, 1e-9);
  // closer still the library refuses, and the refusal arrives as a fault
  EXPECT_FALSE(gsl_free_body({moments, {1e-9, 2, 1e-9}, generic}, 10));
  EXPECT_LT(error<double>({moments, {1e-9, 2, 1e-9}, generic}, 10, taylor_free_body<P>(FreeBody{moments, {1e-9, 2, 1e-9}, generic}, P(10))), 1e-10);
}

}  // namespace
}  // namespace rigor::reference
