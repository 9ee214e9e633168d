// The closed form against a 60-digit Taylor series, which shares nothing with it.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <reference/taylor.hpp>
#include <rigor/engine/exact_flight.hpp>
#include <rigor/engine/flight_constants.hpp>
#include <rigor/linalg/rotation.hpp>
#include <tests/engine/flight_cases.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;
using Precision = ExactFlight::Precision;

struct Errors {
  double attitude, momentum;  // rad; relative
};
struct Compared {
  Errors plain, extended;
};
// The series is good to (1/5)^40 = 1e-28 a step.
Compared errors(const V& I, const V& w, double t) {
  const auto exact = reference::taylor_free_body<reference::Precise>({I, w, generic}, reference::Precise(t), 40, 0.2 / norm<double>(w));
  const auto off = [&](Precision precision) {
    const Attitude got = ExactFlight::make(I, w, generic, precision)->at(t);
    // the difference is taken in extended precision: near agreement, rounding the reference to double would show
    Mat3<double> R_off;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) R_off(i, k) = double(reference::Precise(got.R_WB(i, k)) - exact.R_WB(i, k));
    V L_off;
    for (int i = 0; i < 3; ++i) L_off[i] = double(reference::Precise(got.L_B[i]) - reference::Precise(I[i]) * exact.w_B[i]);
    return Errors{R_off.norm() / std::sqrt(2.0), norm<double>(L_off) / norm<double>(V(I.cwiseProduct(w)))};
  };
  return {off(Precision::plain), off(Precision::extended)};
}

// Bars: 1e-13 with double constants, 5e-15 with extended ones; measured 2.2e-14 and 4.5e-16.
TEST(ExactFlight, MeetsItsBarsOnTheThreeCases) {
  for (const V& w : spins) {
    const Compared forwards = errors(moments, w, 10);
    EXPECT_LT(forwards.plain.attitude, 1e-13);
    EXPECT_LT(forwards.extended.attitude, 5e-15);
    EXPECT_LT(forwards.extended.momentum, 1e-14);
    EXPECT_LT(errors(moments, w, -7.3).extended.attitude, 5e-15) << "backwards in time";
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
    const Compared off = errors(I, w, 2);
    plain = std::fmax(plain, off.plain.attitude);
    extended = std::fmax(extended, off.extended.attitude);
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
      {"in principal planes, at 1 rad/s", {1, 2, 2.5}, {0, 1, 1.5}},
      {"in principal planes, at 1 rad/s", {1, 2, 2.5}, {1, 0, 1.5}},
      {"in principal planes, at 1 rad/s", {1, 2, 2.5}, {1, 1.5, 0}},
      {"negative spins", {1, 2, 2.5}, {-0.3, -0.4, -2}},
  };
  for (const auto& d : degenerate) {
    const auto [plain, extended] = errors(d.I, d.w, 5);
    EXPECT_LT(extended.attitude, 1e-14) << d.what;
    EXPECT_LT(extended.momentum, 1e-14) << d.what;
    EXPECT_LT(plain.attitude, 1e-9) << d.what;  // nearly on the separatrix D has lost five digits
  }
}

// On the separatrix itself the spin tends to the middle axis, w_2 to |L|/I_2, as sech(t times a rate near 1): after 100 s
// within e^-50 of it, and still there for ever.
TEST(ExactFlight, SettlesOnTheUnstableAxisFromTheSeparatrix) {
  const V I(1, 3, 6), w(1.5, 0.7, 0.5);
  const auto flight = ExactFlight::make(I, w, generic);
  const double L = norm<double>(V(I.cwiseProduct(w)));
  for (const double t : {100.0, 1e3, -1e3, 1e6, 1e9, 1e19, -1e19}) {  // no period, not even one of 1e18
    const Attitude a = flight->at(t);
    EXPECT_NEAR(a.L_B[1], t > 0 ? L : -L, 1e-14 * L) << t << ": I_2 w_2' = (I_3 - I_1) w_3 w_1 > 0";
    EXPECT_LT(orthonormality_defect<double>(a.R_WB), 1e-14) << t;
    EXPECT_LT(norm<double>(V(apply<double>(a.R_WB, a.L_B) - apply<double>(generic, V(I.cwiseProduct(w))))), 1e-13 * L) << t;
  }
}

// About one axis the attitude is R_0 exp(w t) and nothing else has a part in it: seen 0; by the series of other spins up to 4e-7.
TEST(ExactFlight, AboutOneAxisIsAPlainTurn) {
  for (const V& I : {V(1, 2, 2.5), V(10001, 1.5, 10001.5), V(13 / 12., 10 / 12., 5 / 12.)})
    for (int axis = 0; axis < 3; ++axis)
      for (const double spin : {3., -0.7}) {
        V w = zero3<double>();
        w[axis] = spin;
        const auto flight = ExactFlight::make(I, w, generic, Precision::plain);
        EXPECT_EQ((flight->at(0).R_WB - generic).norm(), 0);
        for (const double t : {1., 3., 10., -8.}) {
          const Attitude a = flight->at(t);
          EXPECT_LT(angle_between<double>(a.R_WB, Mat3<double>(generic * exp_so3<double>(V(w * t)))), 1e-14) << I.transpose() << ", axis " << axis << ", t = " << t;
          EXPECT_EQ(a.L_B, V(I.cwiseProduct(w)));
        }
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

// The coefficients of the six cubics from the theta functions themselves: each series of four terms over its first harmonic, in 60
// digits at four places, is a cubic in y. θ on one side of m = 1/2 and θ' on the other, where the fourth term is largest.
TEST(ExactFlight, FoldsItsSeriesToTheLastBit) {
  using P = reference::Precise;
  const auto cubic_through = [](const std::function<P(const P&)>& f) {  // Newton's divided differences, expanded
    std::array<P, 4> x, d;
    for (int k = 0; k < 4; ++k) x[std::size_t(k)] = P(2 * k - 3) / 4, d[std::size_t(k)] = f(x[std::size_t(k)]);
    for (std::size_t order = 1; order < 4; ++order)
      for (std::size_t k = 3; k >= order; --k) d[k] = (d[k] - d[k - 1]) / (x[k] - x[k - order]);
    std::array<P, 4> c{d[3], 0, 0, 0};
    for (std::size_t k = 3; k-- > 0;) {
      for (std::size_t power = 3; power > 0; --power) c[power] = c[power - 1] - x[k] * c[power];
      c[0] = d[k] - x[k] * c[0];
    }
    return c;
  };
  const auto expect_same = [&](const double (&got)[4], const char* what, const std::function<P(const P&)>& f) {
    const std::array<P, 4> want = cubic_through(f);
    for (int k = 0; k < 4; ++k) EXPECT_LT(std::fabs(double(P(got[k]) / want[std::size_t(k)] - 1)), 1.1 * 0x1p-53) << what << ", y^" << k;  // rounded once, from long double
  };
  int seen[2] = {0, 0};
  for (const V& w : {V(1, 1, 1.5), V(1, 1, 1.45)}) {  // m = 0.479 and 0.506
    const V I(1, 2, 2.5);
    const auto flight = ExactFlight::make(I, w, generic);
    const auto& n = flight->tuned().numbers;
    const bool prime = flight->tuned().kind == ExactFlight::Tuned::Kind::theta_prime;
    ++seen[prime];
    const FlightConstants<P> c = flight_constants<P>(I.cast<P>(), w.cast<P>());
    const P q = c.q, q4 = q * q * q * q, q9 = q4 * q4 * q, z2 = 1 + pow(q, 2) + pow(q, 6) + pow(q, 12);
    ASSERT_GT(double(q), 0.04) << "not idle";
    const P z3 = 1 + 2 * q + 2 * q4 + 2 * q9, z4 = 1 - 2 * q + 2 * q4 - 2 * q9;
    // sin(av)/sin v and cos(av)/cos v as polynomials of X = cos 2v; of cosh 2w they are sinh(aw)/sinh w and cosh(aw)/cosh w
    const auto sine = [](int a, const P& X) { return a == 1 ? P(1) : a == 3 ? P(1 + 2 * X) : a == 5 ? P(4 * X * X + 2 * X - 1) : P(8 * X * X * X + 4 * X * X - 4 * X - 1); };
    const auto cosine = [](int a, const P& X) { return a == 1 ? P(1) : a == 3 ? P(2 * X - 1) : a == 5 ? P(4 * X * X - 2 * X - 1) : P(8 * X * X * X - 4 * X * X - 4 * X + 1); };
    const auto odd = [&](const P& X, int sign, bool sines, const std::function<P(int)>& weight) {
      P sum = 0;
      for (int k = 0; k < 4; ++k) sum += (k % 2 == 1 ? sign : 1) * pow(q, k * (k + 1)) * weight(2 * k + 1) * (sines ? sine(2 * k + 1, X) : cosine(2 * k + 1, X));
      return sum;
    };
    const auto even = [&](const P& X, int sign) { return P(1 + sign * 2 * q * X + 2 * q4 * (2 * X * X - 1) + sign * 2 * q9 * (4 * X * X * X - 3 * X)); };
    const auto one = [](int) { return P(1); };
    const P scale = prime ? q : P(1);
    const auto at = [&](const std::function<P(const P&)>& f) { return [f, scale](const P& y) { return f(y / scale); }; };
    if (!prime) {
      expect_same(n.sn, "sn", at([&](const P& X) { return P(z3 / z2 * odd(X, -1, true, one)); }));
      expect_same(n.cn, "cn", at([&](const P& X) { return P(z4 / z2 * odd(X, 1, false, one)); }));
      expect_same(n.dn, "dn", at([&](const P& X) { return P(z4 / z3 * even(X, 1)); }));
      expect_same(n.denominator, "denominator", at([&](const P& X) { return even(X, -1); }));
      expect_same(n.arg_x, "arg_x", at([&](const P& X) { return odd(X, -1, true, [&](int a) { return P(cosh(a * c.beta) / cosh(c.beta)); }); }));
      expect_same(n.arg_y, "arg_y", at([&](const P& X) { return P(-odd(X, -1, false, [&](int a) { return P(sinh(a * c.beta) / cosh(c.beta)); })); }));
    } else {
      expect_same(n.sn, "sn", at([&](const P& X) { return P(z3 / z4 * odd(X, -1, true, one)); }));
      expect_same(n.cn, "cn", at([&](const P& X) { return P(z2 / z4 * even(X, -1)); }));
      expect_same(n.dn, "dn", at([&](const P& X) { return P(z2 / z3 * even(X, 1)); }));
      expect_same(n.denominator, "denominator", at([&](const P& X) { return odd(X, 1, false, one); }));
      expect_same(n.arg_x, "arg_x", at([&](const P& X) { return odd(X, -1, false, [&](int a) { return P(sin(a * c.beta)); }); }));
      expect_same(n.arg_y, "arg_y", at([&](const P& X) { return odd(X, -1, true, [&](int a) { return P(cos(a * c.beta)); }); }));
    }
  }
  EXPECT_EQ(seen[0], 1);
  EXPECT_EQ(seen[1], 1);
}

TEST(ExactFlight, AtRestStays) {
  const auto flight = ExactFlight::make(moments, zero3<double>(), generic);
  EXPECT_EQ(flight->at(1e9).R_WB, generic);
}

TEST(ExactFlight, RefusesWhatIsNoBody) {
  for (int i = 0; i < 3; ++i) {
    V bad = V(1, 1, 1);
    for (const double value : {-1.0, 0.0, double(INFINITY), double(NAN), -double(INFINITY)}) {
      bad[i] = value;
      EXPECT_EQ(ExactFlight::make(bad, {0, 0, 1}, generic).fault().where, "inertia[" + std::to_string(i) + "]") << value;
      EXPECT_EQ(bool(ExactFlight::make({1, 1, 1}, bad, generic)), std::isfinite(value));
    }
    EXPECT_EQ(ExactFlight::make({1, 1, 1}, bad, generic).fault().where, "spin[" + std::to_string(i) + "]");
  }
}

}  // namespace
}  // namespace rigor
