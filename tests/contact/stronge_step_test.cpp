// The inner parts of stronge_impulse against what they are copied from: Dormand and Prince's published table, the law
// dv/dp = K (n - mu s), and the definition of a settled direction.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <rigor/formulas/friction_stronge.hpp>
#include <rigor/linalg/rotation.hpp>

namespace rigor {
namespace {

using detail::ImpactAxes;
using detail::SlipState;
using Seven = std::array<double, 7>;  // log r, psi, p, j1, j2, v_n, work

// The process in coordinates (t1, t2, n), from K itself: with s = (cos psi, sin psi) and a = K (-mu s, 1), on the clock dp = r dtau,
// r' = r a_t·s, psi' = a_t·(-sin psi, cos psi), p' = r, j' = -mu s r, v_n' = r a_n, work' = r v_n.
Seven law(const Mat3<double>& K, double mu, const Seven& x) {
  const double c = std::cos(x[1]), s = std::sin(x[1]), r = std::exp(x[0]);
  const Vec3<double> a = K * Vec3<double>(-mu * c, -mu * s, 1);
  return {a[0] * c + a[1] * s, a[1] * c - a[0] * s, r, -mu * c * r, -mu * s * r, r * a[2], r * x[5]};
}

// Dormand and Prince 1980, table 2: the stages, the solution of order 5 and the embedded one of order 4.
const double A[7][6] = {{},
                        {1.0 / 5},
                        {3.0 / 40, 9.0 / 40},
                        {44.0 / 45, -56.0 / 15, 32.0 / 9},
                        {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
                        {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
                        {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
const double fourth[7] = {5179.0 / 57600, 0, 7571.0 / 16695, 393.0 / 640, -92097.0 / 339200, 187.0 / 2100, 1.0 / 40};

struct Step {
  Seven y, difference;
};
Step dormand_prince(const Mat3<double>& K, double mu, const Seven& x, double h) {
  std::array<Seven, 7> k;
  Step step{};
  for (int i = 0; i < 7; ++i) {
    Seven at = x;
    for (int j = 0; j < i; ++j)
      for (int q = 0; q < 7; ++q) at[q] += h * A[i][j] * k[j][q];
    k[i] = law(K, mu, at);
    if (i == 6) step.y = at;
  }
  for (int q = 0; q < 7; ++q)
    for (int j = 0; j < 7; ++j) step.difference[q] += h * ((j < 6 ? A[6][j] : 0) - fourth[j]) * k[j][q];
  return step;
}

Mat3<double> positive_definite(std::mt19937_64& random) {
  std::uniform_real_distribution<double> any(-1, 1);
  Mat3<double> B;
  for (int i = 0; i < 9; ++i) B(i / 3, i % 3) = any(random);
  return B * B.transpose() + 0.1 * Mat3<double>::Identity();
}

ImpactAxes axes_of(const Mat3<double>& K, double mu, double v_n0) {
  return {K(2, 2), {K(0, 2), K(1, 2)}, {{{K(0, 0), K(0, 1)}, {K(1, 0), K(1, 1)}}}, mu, v_n0};
}

}  // namespace

// id: friction.stronge
TEST(StrongeStep, IsTheOneOfDormandAndPrincesTable) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  int led_by[4] = {};
  for (int i = 0; i < 400; ++i) {
    const Mat3<double> K = positive_definite(random);
    const double mu = 0.1 + 0.4 * (1 + any(random)), v_n0 = std::exp(3 * any(random)), h = 0.2;
    const Seven x{any(random), 3 * any(random), any(random), any(random), any(random), 4 * v_n0 * any(random), any(random)};
    const Step want = dormand_prince(K, mu, x, h);
    const double p_unit = v_n0 / K(2, 2);
    const double parts[4] = {std::fabs(want.difference[1]), std::fabs(want.difference[0]), std::fabs(want.difference[2]) / p_unit,
                             std::fabs(want.difference[6]) / (p_unit * v_n0)};
    const int leader = int(std::max_element(parts, parts + 4) - parts);
    ++led_by[leader];

    double error = 0;
    const SlipState got = detail::slip_step(axes_of(K, mu, v_n0), {x[0], x[1], x[2], x[3], x[4], x[5], x[6]}, h, error);
    const Seven y{got.log_r, got.psi, got.p, got.j1, got.j2, got.v_n, got.work};
    for (int q = 0; q < 7; ++q) EXPECT_NEAR(y[q], want.y[q], 1e-13 * (1 + std::fabs(want.y[q]))) << "component " << q;
    EXPECT_NEAR(error, parts[leader], 1e-13 * (1 + parts[leader]) * (1 + 1 / p_unit + 1 / (p_unit * v_n0))) << "component " << leader;
  }
  for (const int cases : led_by) EXPECT_GT(cases, 10);  // each of the four was the largest at times
}

// Built backwards: a direction psi, a pull along it, and a turning rate of a given part of the rate at which a deviation dies
// out. d turn/d psi is taken by the centred difference here.
// id: friction.stronge
TEST(StrongeStep, SettlesWithin1e13OfADirectionThatAttracts) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> any(-1, 1);
  int attracting = 0, repelling = 0;
  for (int i = 0; i < 400; ++i) {
    const Mat3<double> K = positive_definite(random);
    const double mu = 0.1 + 0.4 * (1 + any(random)), psi = 3 * any(random), along = 2 * any(random);
    const Eigen::Vector2d s(std::cos(psi), std::sin(psi)), t(-s[1], s[0]);
    const Eigen::Matrix2d K_tt = K.topLeftCorner<2, 2>();
    const auto axes = [&](double turn) {  // the coupling for which the pull at psi is along·s + turn·t
      const Eigen::Vector2d k_tn = mu * (K_tt * s) + along * s + turn * t;
      return ImpactAxes{K(2, 2), {k_tn[0], k_tn[1]}, {{{K_tt(0, 0), K_tt(0, 1)}, {K_tt(1, 0), K_tt(1, 1)}}}, mu, 7};
    };
    const auto turning = [&](double angle) {
      const Eigen::Vector2d c(std::cos(angle), std::sin(angle)), f = mu * (K_tt * s) + along * s - mu * (K_tt * c);
      return c[0] * f[1] - c[1] * f[0];
    };
    const double step = 1e-5, rate = -(turning(psi + step) - turning(psi - step)) / (2 * step);
    if (std::fabs(rate) < 0.5) continue;  // the numbers below lie within rounding of each other there
    ++(rate > 0 ? attracting : repelling);
    for (const double part : {-1.25, -0.8, 0.8, 1.25})
      EXPECT_EQ(detail::settled(axes(part * 1e-13 * rate), psi), rate > 0 && std::fabs(part) < 1) << i << ": " << part << " of " << rate;
  }
  EXPECT_GT(attracting, 100);
  EXPECT_GT(repelling, 30);
}

// In a plane that K keeps, the process is Routh's, whose end is a closed form (friction.stronge_planar, proved): every mode, every
// e, with and without a slip to begin with, in any frame. The header promises about 1e-11.
// id: friction.stronge
TEST(StrongeStep, IsRouthsClosedFormInAPlaneThatKKeeps) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  std::array<std::array<int, 2>, 3> seen{};
  for (int i = 0; i < 400; ++i) {
    PlanarImpact<double> impact;
    impact.k_nn = std::exp(any(random)), impact.k_tt = std::exp(any(random));
    impact.k_tn = 0.95 * any(random) * std::sqrt(impact.k_nn * impact.k_tt);
    impact.v_n = -std::exp(2 * any(random)), impact.v_t = i % 4 == 0 ? 0 : std::exp(3 * any(random));
    impact.e = i % 5 == 0 ? i % 2 : 0.5 * (1 + any(random));
    impact.mu_s = std::exp(1.5 * any(random)), impact.mu_d = i % 7 == 0 ? 0 : impact.mu_s * (0.7 + 0.3 * any(random));
    const PlanarImpulse<double> want = planar_impulse<double>(impact, Restitution::stronge);

    // without friction a slip meets zero on one line only, to the last bit in these axes
    const Mat3<double> R = impact.mu_d == 0 ? identity3<double>() : rotation_of<double>(Vec4<double>(any(random), any(random), any(random), any(random)));
    Mat3<double> K;
    K << impact.k_tt, impact.k_tn, 0, impact.k_tn, impact.k_nn, 0, 0, 0, std::exp(any(random));
    const Vec3<double> t = R.col(0), n = R.col(1);
    const FrictionImpact<double> got = stronge_impulse(R * K * R.transpose(), impact.v_n * n + impact.v_t * t, n, impact.e, impact.mu_s, impact.mu_d);
    const Vec3<double> j = want.j_n * n + want.j_t * t;
    const double condition = impact.k_nn * impact.k_tt / (impact.k_nn * impact.k_tt - impact.k_tn * impact.k_tn);
    EXPECT_LE(norm<double>(Vec3<double>(got.j_W - j)), 1e-11 * condition * norm<double>(j)) << i;
    EXPECT_TRUE(impact.mu_s == 0 || (got.outcome == FrictionOutcome::stuck) == (want.mode == PlanarMode::sticking)) << i;
    ++seen[std::size_t(want.mode)][impact.v_t == 0];
  }
  for (const auto& mode : seen) EXPECT_GT(mode[0], 10);
}

// k_nn = mu k_tn to the last bit: while it slips, the contact approaches at one speed; compression goes on after the stop.
// id: friction.stronge
TEST(StrongeStep, KeepsItsApproachOnALegWithoutNormalAcceleration) {
  const PlanarImpact<double> impact{1, 5, 2, -1, 1, 0.5, 0.5, 0.5};
  Mat3<double> K;
  K << 5, 2, 0, 2, 1, 0, 0, 0, 3;
  const PlanarImpulse<double> want = planar_impulse<double>(impact, Restitution::stronge);
  const FrictionImpact<double> got = stronge_impulse(K, Vec3<double>(1, -1, 0), Vec3<double>(0, 1, 0), 0.5, 0.5, 0.5);
  EXPECT_NEAR(got.j_W[0], want.j_t, 1e-12);
  EXPECT_NEAR(got.j_W[1], want.j_n, 1e-12);
  EXPECT_EQ(want.mode, PlanarMode::sticking);
}

// k_tn = mu k_tt to the last bit: the slip neither grows nor shrinks.
// id: friction.stronge
TEST(StrongeStep, KeepsASlipThatFeelsNoNetPull) {
  Mat3<double> K;
  K << 2, 1, 0, 1, 3, 0, 0, 0, 2;
  const FrictionImpact<double> got = stronge_impulse(K, Vec3<double>(1, -1, 0), Vec3<double>(0, 1, 0), 0.5, 0.5, 0.5);
  EXPECT_NEAR(got.j_W[1], 1.5 / 2.5, 1e-15);  // k_nn - mu k_tn = 5/2
  EXPECT_NEAR(got.j_W[0], -0.5 * 1.5 / 2.5, 1e-15);
  EXPECT_EQ(got.outcome, FrictionOutcome::slid);
}

// A slip that stops as the impact ends has slid: with restitution, and without.
// id: friction.stronge
TEST(StrongeStep, ASlipThatStopsAtTheEndHasSlid) {
  const Vec3<double> n(0, 1, 0);
  const FrictionImpact<double> bounces = stronge_impulse(identity3<double>(), Vec3<double>(1, -0.5, 0), n, 1, 1, 1);
  EXPECT_EQ(bounces.outcome, FrictionOutcome::slid);
  EXPECT_EQ(bounces.j_W, Vec3<double>(-1, 1, 0));
  const FrictionImpact<double> plastic = stronge_impulse(identity3<double>(), Vec3<double>(1, -1, 0), n, 0, 1, 1);
  EXPECT_EQ(plastic.outcome, FrictionOutcome::slid);
  EXPECT_EQ(plastic.j_W, Vec3<double>(-1, 1, 0));
}

// One straight leg of restitution: W(p) = v p + slope p^2/2 grows until v_n = 0 again, or, where an earlier leg has left v < 0, falls
// until v_n = 0. The impact ends on it if W reaches, on the way and within the limit, what is left to return; then at that
// work and still parting; else the leg ends at the limit.
// id: friction.stronge
TEST(StrongeStep, FollowsAStraightLegUntilTheWorkIsReturned) {
  int ends = 0, goes_on = 0;
  for (const double v : {-1.0, 0.0, 0.25, 1.0, 3.0})
    for (const double slope : {-2.0, -0.5, 0.0, 0.75, 4.0})
      for (const double left : {0.0, 0.125, 1.0, 2.0})
        for (const double limit : {0.1, 0.9, 1.1, 5.0, 50.0}) {
          detail::Progress leg{1, {0, 0, 0, 0, 0, v, -left}, -left, true};  // e = 1: all of it comes back
          leg.follow(ImpactAxes{slope, {0, 0}, {}, 0, 1}, 0, 0, limit);
          const double turn = slope < 0 ? std::fmax(0.0, -v / slope) : limit, p = std::fmin(turn, limit);
          const bool reaches = left == 0 || v * p + slope * p * p / 2 >= left;
          ++(reaches ? ends : goes_on);
          EXPECT_EQ(leg.ended, reaches) << v << ' ' << slope << ' ' << left << ' ' << limit;
          EXPECT_NEAR(leg.x.work, reaches ? 0 : v * limit + slope * limit * limit / 2 - left, 1e-12);
          EXPECT_NEAR(leg.x.v_n, v + slope * leg.x.p, 1e-12);
          EXPECT_GE(leg.x.v_n, reaches && left > 0 ? -1e-7 : -200);  // at the first of two solutions
          EXPECT_LE(leg.x.p, limit);
          EXPECT_TRUE(left > 0 || leg.x.p == 0);
        }
  EXPECT_GT(ends, 100);
  EXPECT_GT(goes_on, 100);
}

// Where friction cannot hold a stop, the slip starts again along the s with k_tn - mu K_tt s = kappa s, kappa > 0.
// id: friction.stronge
TEST(StrongeStep, StartsAgainAlongItsOwnPull) {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> any(-1, 1);
  int tried = 0;
  for (int i = 0; i < 2000; ++i) {
    const Mat3<double> K = positive_definite(random);
    const Eigen::Matrix2d K_tt = K.topLeftCorner<2, 2>();
    const Eigen::Vector2d k_tn(K(0, 2), K(1, 2));
    const double hold = (K_tt.inverse() * k_tn).norm(), mu = hold * (0.55 + 0.4 * any(random));
    if (mu > 1 || K_tt.determinant() < 0.05) continue;
    ++tried;
    const double psi = detail::restart_direction(axes_of(K, mu, 1));
    const Eigen::Vector2d s(std::cos(psi), std::sin(psi)), pull = k_tn - mu * (K_tt * s);
    EXPECT_NEAR(pull[0] * s[1] - pull[1] * s[0], 0, 1e-13) << i;
    EXPECT_GT(pull.dot(s), 0) << i;
  }
  EXPECT_GT(tried, 500);
}

// Without a slip to begin with the impact is one leg. Friction that holds it: v goes to -e v, so K j = -(1 + e) v. Friction that
// just does not: j on the cone of mu_d, against the slip it leaves, and Newton's e all the same.
// id: friction.stronge
TEST(StrongeStep, FromRestSidewaysSticksOrSlipsInOneLeg) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> any(-1, 1);
  const Vec3<double> n(0, 0, 1);
  for (int i = 0; i < 300; ++i) {
    const Mat3<double> K = positive_definite(random);
    const double e = 0.5 * (1 + any(random)), v_n = -1;
    const Vec3<double> sticks = -(1 + e) * v_n * Vec3<double>(K.inverse() * n);
    const double hold = std::hypot(sticks[0], sticks[1]) / sticks[2];
    const FrictionImpact<double> held = stronge_impulse(K, v_n * n, n, e, 1.01 * hold, 0.5 * hold);
    EXPECT_EQ(held.outcome, FrictionOutcome::stuck) << i;
    EXPECT_LE(norm<double>(Vec3<double>(held.j_W - sticks)), 1e-11 * norm<double>(sticks)) << i;

    const double mu_d = 0.6 * hold;
    const FrictionImpact<double> slid = stronge_impulse(K, v_n * n, n, e, 0.99 * hold, mu_d);
    const Vec3<double> v = v_n * n + K * slid.j_W, j = slid.j_W;
    EXPECT_EQ(slid.outcome, FrictionOutcome::slid) << i;
    EXPECT_NEAR(v[2], -e * v_n, 1e-11) << i;
    EXPECT_NEAR(std::hypot(j[0], j[1]), mu_d * j[2], 1e-11 * j[2]) << i;
    EXPECT_NEAR(j[0] * v[1] - j[1] * v[0], 0, 1e-11 * j[2]) << i;
    EXPECT_LT(j[0] * v[0] + j[1] * v[1], 0) << i;
  }
}

}  // namespace rigor
