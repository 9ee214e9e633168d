// The closed form against a 60-digit Taylor series, which shares nothing with it.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <reference/taylor.hpp>
#include <rigor/engine/exact_flight.hpp>
#include <rigor/linalg/rotation.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;
using Precision = ExactFlight::Precision;
const V moments(13 / 12., 10 / 12., 5 / 12.);  // cuboid 1 x 2 x 3 m, 1 kg
const Mat3<double> generic = rotation_of<double>(Vec4<double>(1, 2, -1, 3));

struct Errors {
  double attitude, momentum;  // rad; relative
};
Errors errors(const V& I, const V& w, double t, Precision precision, double step = 0.02) {
  const auto exact = reference::taylor_free_body<reference::Precise>({I, w, generic}, reference::Precise(t), 40, step);
  const auto flight = ExactFlight::make(I, w, generic, precision);
  const Attitude got = flight->at(t);
  // the difference is taken in extended precision: near agreement, rounding the reference to double would show
  Mat3<double> off;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) off(i, k) = double(reference::Precise(got.R_WB(i, k)) - exact.R_WB(i, k));
  V L_off;
  for (int i = 0; i < 3; ++i) L_off[i] = double(reference::Precise(got.L_B[i]) - reference::Precise(I[i]) * exact.w_B[i]);
  return {off.norm() / std::sqrt(2.0), norm<double>(L_off) / norm<double>(V(I.cwiseProduct(w)))};
}

const V spins[3] = {{0.3, 2, 0.2}, {5, 0.01, 0.01}, {1e-6, 2, 1e-6}};  // cases A, B, C of free-flight

// Bars: 1e-13 with double constants, 5e-15 with extended ones; measured 2.2e-14 and 4.5e-16.
TEST(ExactFlight, MeetsItsBarsOnTheThreeCases) {
  for (const V& w : spins) {
    EXPECT_LT(errors(moments, w, 10, Precision::plain).attitude, 1e-13);
    EXPECT_LT(errors(moments, w, 10, Precision::extended).attitude, 5e-15);
    EXPECT_LT(errors(moments, w, 10, Precision::extended).momentum, 1e-14);
    EXPECT_LT(errors(moments, w, -7.3, Precision::extended).attitude, 5e-15) << "backwards in time";
  }
}

// case FB-04 over bodies of aspect up to 100:1. Bars 1e-9 and 1e-13; measured 1e-11 and 2e-14.
TEST(ExactFlight, HoldsForRandomCuboids) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> U(0, 1);
  std::normal_distribution<double> N;
  double plain = 0, extended = 0;
  for (int k = 0; k < 12; ++k) {
    const double a = 1, b = std::pow(100, U(random)), c = std::pow(100, U(random));
    const V I(b * b + c * c, a * a + c * c, a * a + b * b), w{N(random), N(random), N(random)};
    plain = std::fmax(plain, errors(I, w, 2, Precision::plain).attitude);
    extended = std::fmax(extended, errors(I, w, 2, Precision::extended).attitude);
  }
  std::printf("random cuboids, aspect to 100, t = 2: worst %.1e (plain), %.1e (extended)\n", plain, extended);
  EXPECT_LT(plain, 1e-9);
  EXPECT_LT(extended, 1e-13);
}

// Orthogonality, energy and the world's angular momentum at any time: bars 1e-14.
TEST(ExactFlight, KeepsItsInvariantsAtAnyTime) {
  for (const V& w : spins) {
    const auto flight = ExactFlight::make(moments, w, generic);
    const V L = moments.cwiseProduct(w), L_W = apply<double>(generic, L);
    const double energy = L.cwiseProduct(w).sum();
    for (double t = 1e-3; t < 2e6; t *= 3.7) {
      const Attitude a = flight->at(t);
      EXPECT_LT(orthonormality_defect<double>(a.R_WB), 1e-14);
      EXPECT_LT(norm<double>(V(apply<double>(a.R_WB, a.L_B) - L_W)), 1e-14 * norm<double>(L));
      EXPECT_NEAR(a.L_B.cwiseProduct(a.L_B).cwiseQuotient(moments).sum(), energy, 1e-14 * energy);
    }
  }
}

// The pitfalls of the closed form: each against the Taylor series, or where that is exact already, against rotation.
TEST(ExactFlight, HandlesEveryDegenerateMotion) {
  const double tiny = std::numeric_limits<double>::epsilon();
  const struct {
    const char* what;
    V I, w;
  } degenerate[] = {
      {"sphere", {2, 2, 2}, {0.3, -1, 0.7}},
      {"sphere but for an ulp", {2, 2, 2 * (1 + tiny)}, {0.3, -1, 0.7}},
      {"sphere but for 1e-12", {2, 2 + 2e-12, 2 - 1e-12}, {0.3, -1, 0.7}},
      {"symmetric top", {2, 2, 1}, {0.3, -1, 0.7}},
      {"symmetric top, flat", {1, 1, 1.9}, {0.3, -1, 0.7}},
      {"symmetric top spinning across its axis", {2, 2, 1}, {0.3, -1, 0}},
      {"nearly symmetric, across", {2, 2 + 2e-9, 1}, {0.3, -1, 0}},
      {"separatrix, exactly", {1, 3, 6}, {1.5, 0.7, 0.5}},
      {"separatrix, nearly", {1, 3, 6}, {1.5, 0.7, 0.5 * (1 + 1e-12)}},
      {"separatrix, nearly, other side", {1, 3, 6}, {1.5, 0.7, 0.5 * (1 - 1e-12)}},
      {"about the unstable axis", {1, 2, 2.5}, {0, 2, 0}},
      {"about the unstable axis but for 1e-15", {1, 2, 2.5}, {1e-15, 2, 1e-15}},
      {"about a stable axis", {1, 2, 2.5}, {0, 0, 3}},
      {"about a stable axis but for 1e-200", {1, 2, 2.5}, {1e-200, 0, 3}},
      {"in a principal plane", {1, 2, 2.5}, {0, 0.3, 2}},
      {"in the other principal plane", {1, 2, 2.5}, {0.3, 0, 2}},
      {"negative spins", {1, 2, 2.5}, {-0.3, -0.4, -2}},
  };
  for (const auto& d : degenerate) {
    const Errors e = errors(d.I, d.w, 5, Precision::extended);
    EXPECT_LT(e.attitude, 1e-14) << d.what;
    EXPECT_LT(e.momentum, 1e-14) << d.what;
  }
}

// On the separatrix itself the spin tends to the middle axis, w_2 to |L|/I_2, as sech(t times a rate near 1): after 100 s
// within e^-50 of it, and still there for ever.
TEST(ExactFlight, SettlesOnTheUnstableAxisFromTheSeparatrix) {
  const V I(1, 3, 6), w(1.5, 0.7, 0.5);
  const auto flight = ExactFlight::make(I, w, generic);
  const double L = norm<double>(V(I.cwiseProduct(w)));
  for (const double t : {100.0, 1e3, -1e3, 1e6, 1e9}) {
    const Attitude a = flight->at(t);
    EXPECT_NEAR(std::fabs(a.L_B[1]), L, 1e-14 * L) << t;
    EXPECT_LT(orthonormality_defect<double>(a.R_WB), 1e-14) << t;
    EXPECT_LT(norm<double>(V(apply<double>(a.R_WB, a.L_B) - apply<double>(generic, V(I.cwiseProduct(w))))), 1e-13 * L) << t;
  }
}

TEST(ExactFlight, DoesNotCareForScale) {
  const V w = spins[0];
  for (const double scale : {1e-160, 1e-100, 1e-8, 1e8, 1e100, 1e150}) {
    const auto slow = ExactFlight::make(moments, w, generic), fast = ExactFlight::make(V(moments * 1e-3), V(scale * w), generic);
    const Attitude a = slow->at(10), b = fast->at(10 / scale);
    EXPECT_LT(angle_between<double>(a.R_WB, b.R_WB), 1e-14) << scale;
  }
}

TEST(ExactFlight, AtRestStays) {
  const auto flight = ExactFlight::make(moments, zero3<double>(), generic);
  EXPECT_EQ(flight->at(1e9).R_WB, generic);
}

TEST(ExactFlight, RefusesWhatIsNoBody) {
  EXPECT_EQ(ExactFlight::make({1, -1, 1}, {0, 0, 1}, generic).fault().where, "inertia[1]");
  EXPECT_EQ(ExactFlight::make({1, 1, 1}, {0, NAN, 1}, generic).fault().where, "spin[1]");
}

}  // namespace
}  // namespace rigor
