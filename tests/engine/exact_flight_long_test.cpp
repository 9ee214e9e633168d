// The closed form over many bodies and long times. The judge is the same formula in 60 digits from other code
// (reference/theta_flight.hpp), which the Taylor series has judged (tests/reference/theta_test.cpp): a series is too slow here.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <reference/sundials.hpp>
#include <reference/theta_flight.hpp>
#include <rigor/engine/exact_flight.hpp>
#include <rigor/linalg/rotation.hpp>
#include <tests/engine/flight_cases.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;
using P = reference::Precise;
using Precision = ExactFlight::Precision;

struct Pair {
  double plain, extended;  // attitude error, rad
};
Pair attitude_errors(const V& I, const V& w, double t) {
  const auto want = reference::ThetaFlight<P>(reference::FreeBody{I, w, generic}).at(P(t));
  const auto off = [&](Precision precision) {
    const Attitude got = ExactFlight::make(I, w, generic, precision)->at(t);
    double sum = 0;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) {
        const double d = double(P(got.R_WB(i, k)) - want.R_WB(i, k));
        sum += d * d;
      }
    return std::sqrt(sum / 2);
  };
  return {off(Precision::plain), off(Precision::extended)};
}

// Bars of the closed form: T = 10, random cuboids of aspect up to 100, 1e-9 and 1e-13.
TEST(ExactFlightLong, HoldsOnThreeHundredRandomCuboids) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> U(0, 1);
  std::normal_distribution<double> N;
  Pair worst{0, 0};
  for (int k = 0; k < 300; ++k) {
    const double a = 1, b = std::pow(100, U(random)), c = std::pow(100, U(random));
    const Pair e = attitude_errors(V(b * b + c * c, a * a + c * c, a * a + b * b), V{N(random), N(random), N(random)}, 10);
    worst = {std::fmax(worst.plain, e.plain), std::fmax(worst.extended, e.extended)};
  }
  std::printf("300 random cuboids, aspect to 100, t = 10: worst %.1e (plain), %.1e (extended)\n", worst.plain, worst.extended);
  EXPECT_LT(worst.plain, 1e-9);
  EXPECT_LT(worst.extended, 1e-13);
  EXPECT_GT(worst.plain, 1e-13) << "not idle: thin bodies cost digits";
}

// Long times: bars 1e-8 and 1e-11 at t = 1e6 s. Next to the separatrix the plain constants lose what the cancellation of D costs.
// Beside the cases, a wide motion with m < 1/2, of which they have none.
TEST(ExactFlightLong, HoldsAtAMillionSeconds) {
  const V wide(2, 0.7, 1.1);
  ASSERT_EQ(ExactFlight::make(moments, wide, generic)->tuned().kind, ExactFlight::Tuned::Kind::theta);
  for (int k = 0; k < 4; ++k)
    for (const double t : {1e3, 1e6 - 0.375, -1e6}) {
      const Pair e = attitude_errors(moments, k < 3 ? spins[k] : wide, t);
      std::printf("case %c, t = %10.1f: %.1e (plain), %.1e (extended)\n", "ABC-"[k], t, e.plain, e.extended);
      if (k != 2) {
        EXPECT_LT(e.plain, 1e-8);
      }
      EXPECT_LT(e.extended, 1e-11);
    }
}

// Against CVODE at tolerance 1e-14: bar 1e-11.
TEST(ExactFlightLong, AgreesWithCvode) {
  for (const V& w : spins) {
    const auto cvode = reference::cvode_free_body({moments, w, generic}, 10, 1e-14);
    ASSERT_TRUE(cvode);
    EXPECT_LT(angle_between<double>(cvode->R_WB, ExactFlight::make(moments, w, generic)->at(10).R_WB), 1e-11);
  }
}

}  // namespace
}  // namespace rigor
