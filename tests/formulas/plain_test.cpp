#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <limits>
#include <random>
#include <rigor/formulas/apply_pair_impulse.hpp>
#include <rigor/formulas/cuboid_inertia.hpp>
#include <rigor/formulas/cuboid_inverse_inertia.hpp>
#include <rigor/formulas/normal_effective_mass.hpp>
#include <rigor/formulas/normal_impulse.hpp>
#include <rigor/formulas/point_velocity.hpp>
#include <rigor/formulas/semi_implicit_step.hpp>
#include <rigor/formulas/world_inverse_inertia.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/scalar/gamma.hpp>

// The plain formulas in double, where exactness (tests/exact) and rounding bounds (rigor verify) say nothing:
// sizes, orders, extremes.
namespace rigor {
namespace {

constexpr double u = unit_roundoff<double>();

struct Random {
  std::mt19937_64 bits{20260414};
  double number(double low, double high) { return low + (high - low) * (double(bits() >> 11) * 0x1p-53); }
  Vec3<double> vector(double reach) {
    return {number(-reach, reach), number(-reach, reach), number(-reach, reach)};
  }
  Mat3<double> rotation() {
    Vec4<double> q(number(-1, 1), number(-1, 1), number(-1, 1), number(-1, 1));
    return rotation_of<double>(q);
  }
};

double infinity_norm(const Mat3<double>& M) { return M.cwiseAbs().rowwise().sum().maxCoeff(); }

/// log2 of the ratios of successive errors.
std::vector<double> orders(const std::vector<double>& errors) {
  std::vector<double> p;
  for (std::size_t i = 1; i < errors.size(); ++i) p.push_back(std::log2(errors[i - 1] / errors[i]));
  return p;
}

}  // namespace

// case I-01 (T0): sizes that are powers of two and m = 12·2^k: every operation is exact.
TEST(CuboidInertia, IsExactForPowersOfTwo) {
  EXPECT_EQ(cuboid_inertia<double>(12, {1, 2, 4}), Vec3<double>(20, 17, 5));
  EXPECT_EQ(cuboid_inertia<double>(0.75, {0.5, 8, 0.125}),
            Vec3<double>(0.0625 * (64 + 0x1p-6), 0.0625 * (0.25 + 0x1p-6), 0.0625 * 64.25));
  // The public yardstick's box, 0.1 × 0.4 × 0.9 m, 10 kg, by hand: 10/12 · (0.97, 0.82, 0.17).
  const Vec3<double> I = cuboid_inertia<double>(10, {0.1, 0.4, 0.9});
  EXPECT_NEAR(I[0], 9.7 / 12, 4 * u * 9.7 / 12);
  EXPECT_NEAR(I[1], 8.2 / 12, 4 * u * 8.2 / 12);
  EXPECT_NEAR(I[2], 1.7 / 12, 4 * u * 1.7 / 12);
}

// case I-02, S-02 (plates 1 : 1e6, needles): the triangle inequalities, up to the 4u of each moment.
TEST(CuboidInertia, KeepsTheTriangleInequalitiesForPlatesAndNeedles) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    Vec3<double> s;
    for (int k = 0; k < 3; ++k) s[k] = std::exp(random.number(-7, 7));
    const Vec3<double> I = cuboid_inertia<double>(random.number(1, 3), s);
    for (int k = 0; k < 3; ++k) EXPECT_GE(I[(k + 1) % 3] + I[(k + 2) % 3], I[k] * (1 - 8 * u));
  }
  EXPECT_EQ(cuboid_inertia<double>(12, {1, 1, 0}), Vec3<double>(1, 1, 2));  // equality: no thickness
}

// case I-06: Gauss's two-point rule per axis, ±s/(2√3), eight equal masses: exact for quadratics.
TEST(CuboidInertia, AgreesWithTheGaussProductRule) {
  Random random;
  for (int i = 0; i < 100; ++i) {
    const double m = random.number(1, 3), g = 1 / (2 * std::sqrt(3.0));
    const Vec3<double> s(random.number(0.1, 3), random.number(0.1, 3), random.number(0.1, 3));
    Vec3<double> I(0, 0, 0);
    for (int c = 0; c < 8; ++c) {
      const Vec3<double> p((c & 1 ? g : -g) * s[0], (c & 2 ? g : -g) * s[1], (c & 4 ? g : -g) * s[2]);
      for (int k = 0; k < 3; ++k) I[k] += m / 8 * (p.dot(p) - p[k] * p[k]);
    }
    const Vec3<double> ours = cuboid_inertia<double>(m, s);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(ours[k], I[k], gamma_bound(24) * (m * s.dot(s)));
  }
}

// case I-04, I-05: symmetric to the bit, trace kept, inverse with an error of κ(I) u.
TEST(WorldInertia, IsSymmetricAndItsInverseIsGoodToItsCondition) {
  Random random;
  double worst = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3<double> s(random.number(0.5, 2.5), random.number(0.5, 2.5), std::exp(random.number(-7, 1)));
    const Vec3<double> I = cuboid_inertia<double>(random.number(2, 3), s);
    const Mat3<double> R = random.rotation(), I_W = world_inertia<double>(R, I);
    const Mat3<double> inverse = world_inverse_inertia<double>(R, cuboid_inverse_inertia<double>(I));
    EXPECT_EQ(I_W, Mat3<double>(I_W.transpose()));
    EXPECT_EQ(inverse, Mat3<double>(inverse.transpose()));
    EXPECT_NEAR(I_W.trace(), I.sum(), 24 * u * I.sum());  // R within a few u of orthogonal: |RᵀR − 1| ≤ 16u
    const double condition = I.maxCoeff() / I.minCoeff();
    worst = std::max(worst, infinity_norm(I_W * inverse - Mat3<double>::Identity()) / (condition * u));
  }
  EXPECT_LE(worst, 3 * 24);  // three terms a row, each with γ₅ + γ₅ + γ₃ and twice R's 5u
  EXPECT_GT(worst, 0.5);
}

// case K-06: the central difference of x + R r over ±h has error h²/6 · (third derivative): order 2.
TEST(PointVelocity, IsTheLimitOfCentralDifferencesOfOrderTwo) {
  Random random;
  const Vec3<double> v = random.vector(2), w = random.vector(2), r_B = random.vector(1);
  const Mat3<double> R = random.rotation();
  const Vec3<double> expected = point_velocity<double>(v, w, R * r_B);
  std::vector<double> errors;
  for (int k = 4; k <= 8; ++k) {
    const double h = std::ldexp(1, -k);
    const auto at = [&](double t) { return Vec3<double>(t * v + exp_so3<double>(t * w) * R * r_B); };
    errors.push_back(((at(h) - at(-h)) / (2 * h) - expected).norm());
  }
  for (const double p : orders(errors)) EXPECT_NEAR(p, 2, 0.02);
  EXPECT_GT(errors.back(), 1e3 * u / std::ldexp(1, -8));  // still truncation, not rounding
}

// case K-07: N naive steps at constant ω: the vector across ω has grown by (1 + θ²)^{N/2} and turned by N
// atan θ.
TEST(NaiveRotationStep, GrowsAndTurnsAsItsClosedFormSays) {
  const Vec3<double> w(0.2, -0.3, 0.6);
  const double h = 0.125, theta = h * norm<double>(w);
  const Vec3<double> axis = w / norm<double>(w), across = axis.cross(Vec3<double>(1, 0, 0)).normalized();
  const int n = 1000;
  Mat3<double> R = identity3<double>();
  for (int i = 0; i < n; ++i) R = naive_rotation_step<double>(h, w, R);
  const double growth = std::pow(1 + theta * theta, n / 2.0);
  const Vec3<double> end = R * across;
  const double bound = n * 8 * u;  // each step within γ₄ of a map of norm √(1 + θ²), both columns
  EXPECT_NEAR(end.norm() / growth, 1, bound);
  EXPECT_NEAR((R * axis).norm(), 1, bound * growth);
  EXPECT_NEAR(R.determinant() / (growth * growth), 1, 3 * bound);
  const double turned = std::fmod(n * std::atan(theta), 2 * M_PI);
  const double angle = std::atan2(axis.dot(across.cross(end)), across.dot(end));
  EXPECT_NEAR(std::remainder(angle - turned, 2 * M_PI), 0, bound);
  EXPECT_GT(std::abs(std::remainder(angle - n * theta, 2 * M_PI)), 0.1);  // and not by N θ
}

// case K-09: repaired by Gram-Schmidt, the angle lags by θ − atan θ ~ θ³/3 a step where the stretch is even
// (spin about a body axis): order 2 though the method has order 1. About a skew axis Gram-Schmidt errs by
// O(θ²) a step: order 1.
TEST(SemiImplicitStep, HasOrderTwoInTheAngleAboutABodyAxisAndOrderOneOtherwise) {
  Random random;
  const Mat3<double> R = random.rotation();
  const double T = 1;
  const auto error = [&](const Vec3<double>& w, int n) {
    State<double> s;
    s.R_WB = R, s.w_WB = w;
    for (int i = 0; i < n; ++i) s = semi_implicit_step<double>(T / n, s, zero3<double>(), zero3<double>());
    return angle_between<double>(s.R_WB, exp_so3<double>(T * w) * R);
  };
  std::vector<double> about_axis, skew_axis;
  for (int n = 32; n <= 512; n *= 2) {
    about_axis.push_back(error(Vec3<double>(2 * R.col(1)), n));
    skew_axis.push_back(error(R * Vec3<double>(1.2, -0.8, 1.4), n));
    const double theta = 2 * T / n;
    // sizes, not only orders: n (θ − atan θ); the rounding of n steps and of angle_between
    EXPECT_NEAR(about_axis.back(), n * (theta - std::atan(theta)), 8 * u * n);
  }
  for (const double p : orders(about_axis)) EXPECT_NEAR(p, 2, 0.05);
  for (const double p : orders(skew_axis)) EXPECT_NEAR(p, 1, 0.1);
}

// case S-05: e at its ends. The law is exact at 0 (v_n' = 0 wanted) and 1; −0 is 0; a denormal e is no e.
TEST(NormalImpulse, TakesRestitutionAtItsEnds) {
  const double v_n = -1.7, k = 0.9, denormal = 0x1p-1074;
  EXPECT_EQ(normal_impulse<double>(0, v_n, k), 1.7 / 0.9);
  EXPECT_EQ(normal_impulse<double>(-0.0, v_n, k), 1.7 / 0.9);
  EXPECT_EQ(normal_impulse<double>(denormal, v_n, k), 1.7 / 0.9);
  EXPECT_EQ(normal_impulse<double>(1, v_n, k), 2 * 1.7 / 0.9);
  EXPECT_LE(normal_impulse<double>(1 - u, v_n, k), 2 * 1.7 / 0.9);
}

// case S-06: mass ratios up to 1e±300. k_nn is dominated by the light body and nothing overflows on the way.
TEST(NormalEffectiveMass, SurvivesMassRatiosOf1e300) {
  for (const double ratio : {1e-300, 1e-6, 1.0, 1e6, 1e300}) {
    const auto body = [](double m) {
      const Vec3<double> I = cuboid_inertia<double>(m, {1, 2, 3});
      return ImpactBody<double>{
          1 / m,
          world_inverse_inertia<double>(identity3<double>(), cuboid_inverse_inertia<double>(I)),
          {0, 0, 0}};
    };
    const ImpactBody<double> A = body(1), B = body(ratio);
    const double k = normal_inverse_mass<double>(A, B, {0, 0, 1}), expected = 1 + 1 / ratio;
    EXPECT_NEAR(k / expected, 1, 4 * u);
    const PairVelocity<double> before{{{0, 0, 1}, zero3<double>()}, {}};
    const double j = normal_impulse<double>(1, -1, k);
    EXPECT_TRUE(std::isfinite(j));
    const auto after = apply_pair_impulse<double>(A, B, before, {0, 0, j});
    // One-dimensional elastic impact: v_A' = (1 − r)/(1 + r), v_B' = 2/(1 + r), r = m_B/m_A.
    const double r = ratio;
    EXPECT_NEAR(after.A.v_WB[2], r > 1 ? (1 / r - 1) / (1 / r + 1) : (1 - r) / (1 + r), 8 * u);
    EXPECT_NEAR(after.B.v_WB[2] / (2 / (1 + r)), 1, 8 * u);
  }
}

// case BB-01, BB-04: central impact of a mass ratio r → ∞ converges to the wall's answer like 1/r.
TEST(PairImpulse, ApproachesTheWallLikeTheInverseMassRatio) {
  std::vector<double> errors;
  const double e = 0.75;
  for (int k = 4; k <= 12; k += 2) {
    const double M = std::ldexp(1, k);
    const ImpactBody<double> A{1 / M, zero33<double>(), zero3<double>()},
        B{1, zero33<double>(), zero3<double>()};
    const PairVelocity<double> before{{}, {{0, 0, -1}, zero3<double>()}};
    const double j = normal_impulse<double>(e, -1, normal_inverse_mass<double>(A, B, {0, 0, 1}));
    errors.push_back(e - apply_pair_impulse<double>(A, B, before, {0, 0, j}).B.v_WB[2]);
  }
  for (std::size_t i = 1; i < errors.size(); ++i)
    EXPECT_NEAR(std::log2(errors[i - 1] / errors[i]) / 2, 1, 0.05);
}

}  // namespace rigor
