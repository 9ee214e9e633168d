// Bounds that carry a condition number: impacts with friction, and Gram-Schmidt. The exact value comes from the same
// template over the rationals (or long double, where a root occurs: 2^-11 of the unit used here).
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <rigor/bodies/cuboid.hpp>
#include <rigor/formulas/effective_mass.hpp>
#include <rigor/formulas/friction_coulomb.hpp>
#include <rigor/formulas/friction_stronge_planar.hpp>
#include <rigor/formulas/friction_tangent.hpp>
#include <rigor/formulas/gram_schmidt.hpp>
#include <rigor/formulas/world_inverse_inertia.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/scalar/rational.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;
using M = Mat3<double>;
constexpr double u = 0x1p-53;
// A part of the cases by default; all with RIGOR_ALL=1.
const bool all = std::getenv("RIGOR_ALL") != nullptr;

struct Draw {
  std::mt19937_64 random;
  double in(double low, double high) { return low + (high - low) * (double(random() >> 11) * 0x1p-53); }
  double scale(double low, double high) { return std::exp(in(std::log(low), std::log(high))); }
  V vector() {
    std::normal_distribution<double> N;
    return V(N(random), N(random), N(random));
  }
  V unit() {
    const V v = vector();
    return v / norm<double>(v);
  }
  M rotation() {
    std::normal_distribution<double> N;
    return rotation_of<double>(Vec4<double>(N(random), N(random), N(random), N(random)));
  }
};

// The worst ratio seen must lie between a tenth of the bound (else the bound is idle) and the bound.
void expect_tight(const char* what, double worst) {
  std::printf("%-30s worst %.3f of its bound\n", what, worst);
  EXPECT_LE(worst, 1) << what;
  EXPECT_GE(worst, 0.1) << what << ": the bound is idle";
}

template <class To>
Vec3<To> as(const V& v) {
  if constexpr (std::is_same_v<To, Rational>) return Vec3<To>(To::exactly(v[0]), To::exactly(v[1]), To::exactly(v[2]));
  else return Vec3<To>(v[0], v[1], v[2]);
}

// A corner of a random cuboid (edges over three decades) against an immovable plane.
M corner_mass(Draw& draw) {
  const Cuboid<double> box = *Cuboid<double>::make(draw.scale(0.1, 10), {draw.scale(0.03, 3), draw.scale(0.03, 3), draw.scale(0.03, 3)});
  const M R = draw.rotation();
  ImpactBody<double> A{}, B{box.inverse_mass(), world_inverse_inertia<double>(R, box.inverse_inertia()), V(R * (box.size() / 2))};
  return effective_inverse_mass<double>(A, B);
}

TEST(ConditionedBounds, CoulombsImpulse) {
  Draw draw{std::mt19937_64(5)};
  double worst_stuck = 0, worst_slid = 0;
  int other_branch = 0;
  const int cases = all ? 1000000 : 20000;
  for (int c = 0; c < cases; ++c) {
    const V n = draw.unit();
    const M K = corner_mass(draw);
    V v_r = draw.vector();
    if (dot<double>(v_r, n) > 0) v_r = -v_r;
    const double e = draw.in(0, 1), mu_s = draw.scale(0.05, 2), mu_d = mu_s * draw.in(0.5, 1);
    const V t = friction_tangent<double>(v_r, zero3<double>(), n);
    const auto got = coulomb_impulse<double>(K, v_r, n, t, e, mu_s, mu_d);
    using Q = Rational;
    Mat3<Q> KQ;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) KQ(i, j) = Q::exactly(K(i, j));
    const auto want = coulomb_impulse<Q>(KQ, as<Q>(v_r), as<Q>(n), as<Q>(t), Q::exactly(e), Q::exactly(mu_s), Q::exactly(mu_d));
    if (got.outcome != want.outcome) {
      ++other_branch;
      continue;
    }
    if (got.outcome == FrictionOutcome::jammed) continue;
    V j;
    for (int i = 0; i < 3; ++i) j[i] = double(want.j_W[i]);
    double error = 0;
    for (int i = 0; i < 3; ++i) error = std::fmax(error, std::fabs(double(Q::exactly(got.j_W[i]) - want.j_W[i])));
    if (got.outcome == FrictionOutcome::stuck) {
      const Vec3<double> eigen = Eigen::SelfAdjointEigenSolver<M>(K).eigenvalues();
      worst_stuck = std::fmax(worst_stuck, error / (8 * u * eigen[2] / eigen[0] * norm<double>(j)));
    } else {
      const V Kn = K * n;
      const double denominator = dot<double>(n, Kn) - mu_d * dot<double>(t, Kn);
      const double condition = (1 + mu_d) * norm<double>(Kn) / denominator + norm<double>(v_r) / std::fabs(dot<double>(v_r, n));
      worst_slid = std::fmax(worst_slid, error / (8 * u * condition * norm<double>(j)));
    }
  }
  EXPECT_LE(other_branch, cases / 10000) << "a case in ten thousand may lie on the border of its cone";
  expect_tight("friction.coulomb, stuck", worst_stuck);
  expect_tight("friction.coulomb, sliding", worst_slid);
}

TEST(ConditionedBounds, PlanarImpulse) {
  Draw draw{std::mt19937_64(6)};
  double worst = 0;
  for (int c = 0, cases = all ? 1000000 : 100000; c < cases; ++c) {
    const double k_nn = draw.scale(0.3, 3), k_tt = draw.scale(0.3, 3), k_tn = std::sqrt(k_nn * k_tt) * draw.in(-0.99, 0.99);
    const double mu_s = draw.scale(0.05, 2);
    const PlanarImpact<double> p{k_nn, k_tt, k_tn, -draw.scale(0.1, 10), draw.scale(0.01, 10), draw.in(0, 1), mu_s, mu_s * draw.in(0.5, 1)};
    using L = long double;
    const PlanarImpact<L> q{p.k_nn, p.k_tt, p.k_tn, p.v_n, p.v_t, p.e, p.mu_s, p.mu_d};
    for (const Restitution r : {Restitution::stronge, Restitution::poisson, Restitution::newton}) {
      const auto got = planar_impulse<double>(p, r);
      const auto want = planar_impulse<L>(q, r);
      if (got.mode != want.mode) continue;
      const double size = double(std::hypot(want.j_n, want.j_t)), det = k_nn * k_tt - k_tn * k_tn;
      const double error = double(std::fmax(std::fabs(got.j_n - want.j_n), std::fabs(got.j_t - want.j_t)));
      worst = std::fmax(worst, error / (32 * u * size * k_nn * k_tt / det));
    }
  }
  expect_tight("friction.stronge_planar", worst);
}

TEST(ConditionedBounds, GramSchmidt) {
  Draw draw{std::mt19937_64(7)};
  for (const double off : {0.0, 1e-8, 1e-3, 1e-1, 0.5}) {
    double worst = 0;
    for (int c = 0, cases = all ? 1000000 : 100000; c < cases; ++c) {
      M A = draw.rotation();
      for (int i = 0; i < 9; ++i) A.data()[i] += off * draw.in(-1, 1);
      const M Q = gram_schmidt<double>(A);
      double defect = 0;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          long double s = i == j ? -1 : 0;
          for (int k = 0; k < 3; ++k) s += (long double)Q(k, i) * Q(k, j);
          defect = std::fmax(defect, double(std::fabs(s)));
        }
      const Vec3<double> s = Eigen::SelfAdjointEigenSolver<M>(M(A.transpose() * A)).eigenvalues();
      worst = std::fmax(worst, defect / (12 * u * std::sqrt(s[2] / s[0])));
    }
    expect_tight("rotation.gram_schmidt", worst);
  }
}

}  // namespace
}  // namespace rigor
