#include <gtest/gtest.h>

#include <random>
#include <rigor/linalg/rotation.hpp>
#include <rigor/scalar/constants.hpp>
#include <rigor/scalar/rational.hpp>
#include <set>

namespace rigor {
namespace {

using Q = Rational;
constexpr double u = unit_roundoff<double>();

/// exp([θ]ₓ) by its power series over the rationals, θ exactly the doubles given: shares nothing with
/// Rodrigues. The remainder is below |θ|^80/80!: 1e-38 for |θ| = 13.
Mat3<Q> exponential(const Vec3<double>& theta) {
  const Mat3<Q> W = skew<Q>(Vec3<Q>(Q::exactly(theta[0]), Q::exactly(theta[1]), Q::exactly(theta[2])));
  Mat3<Q> sum = identity3<Q>(), term = sum;
  for (int k = 1; k <= 80; ++k) {
    term = Mat3<Q>(W * term) * (Q(1) / Q(k));
    sum += term;
  }
  return sum;
}

double largest_difference(const Mat3<double>& R, const Mat3<Q>& exact) {
  double worst = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) worst = std::max(worst, std::abs(double(Q::exactly(R(i, j)) - exact(i, j))));
  return worst;
}

double determinant(const Mat3<double>& R) { return dot<double>(cross<double>(R.col(0), R.col(1)), R.col(2)); }

Vec3<double> direction(std::mt19937_64& random) {
  const auto number = [&] { return double(random() >> 11) * 0x1p-52 - 1; };
  const Vec3<double> a(number(), number(), number());
  return a / norm<double>(a);
}

/// The 24 rotations that map the cube to itself, as integer quaternions: 1, quarter and half turns about the
/// axes, half turns about the edges' middles, third turns about the diagonals. One of q and −q each.
std::vector<Vec4<double>> cube_group() {
  std::vector<Vec4<double>> all;
  for (int w = 0; w <= 1; ++w)
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z) {
          const int size = w * w + x * x + y * y + z * z;
          const int first = x ? x : y ? y : z;
          if (size == 0 || size == 3 || (w == 0 && first < 0)) continue;
          all.push_back(Vec4<double>(w, x, y, z));
        }
  return all;
}

}  // namespace

// case K-01. Angle |θ| computed with relative error below 3u, hence 3u|θ| in the angle, and a few u in the
// entries: (8 + 4|θ|) u. A column's square sees |θ| in sin|θ|/|θ| · θ (2·3u), its entries' roundings (2·3u)
// and the dot's (3u): 16u.
TEST(ExpSo3, IsTheExponentialSeriesAndARotation) {
  std::mt19937_64 random(1);
  double worst = 0, worst_defect = 0;
  for (int i = 0; i < 200; ++i) {
    const double angle = 12.0 * i / 200;
    const Vec3<double> theta = angle * direction(random);
    const Mat3<double> R = exp_so3<double>(theta);
    worst = std::max(worst, largest_difference(R, exponential(theta)) / ((8 + 4 * angle) * u));
    worst_defect = std::max({worst_defect, orthonormality_defect<double>(R), std::abs(determinant(R) - 1)});
  }
  EXPECT_LE(worst, 1);
  EXPECT_GT(worst, 0.05);
  EXPECT_LE(worst_defect, 16 * u);
  EXPECT_GT(worst_defect, 2 * u);  // measured: 10 u
}

// case K-02: both sides of the branch at |θ|² = 2^-10, and down to the smallest double.
TEST(ExpSo3, AgreesWithTheSeriesOnBothSidesOfItsBranch) {
  const Vec3<double> axis(2.0 / 7, 3.0 / 7, 6.0 / 7);
  for (const double angle : {0x1p-5 * (1 - 1e-15), 0x1p-5, 0x1p-5 * (1 + 1e-15), 0x1p-5 * 1.01, 0x1p-5 * 0.99,
                             0x1p-10, 0x1p-20, 0x1p-27, 0x1p-40, 0x1p-500, 0x1p-1074, 0.0, 1.0})
    EXPECT_LE(largest_difference(exp_so3<double>(angle * axis), exponential(angle * axis)), 4 * u) << angle;
  // The small entries are right relatively: sin θ keeps its digits where 1 − cos θ vanishes.
  EXPECT_EQ(exp_so3<double>(Vec3<double>(0, 0, 0x1p-500))(1, 0), 0x1p-500);
}

// case K-03: R → q near and beyond the half turn. q = ±(cos θ/2, sin θ/2 a), w ≥ 0.
TEST(QuaternionOf, PassesTheHalfTurnWithoutLosingDigits) {
  std::mt19937_64 random(3);
  const double pi_ = pi<double>();
  double worst = 0;
  for (const double offset : {-1.0, -1e-3, -1e-8, -1e-15, 0.0, 1e-15, 1e-8, 1e-3, 1.0})
    for (int turns = 0; turns < 3; ++turns)
      for (int i = 0; i < 20; ++i) {
        const double angle = pi_ + offset + turns * 2 * pi_;
        const Vec3<double> a = direction(random);
        const Mat3<double> R = exp_so3<double>(angle * a);
        const Vec4<double> q = quaternion_of<double>(R);
        EXPECT_GE(q[0], 0);
        EXPECT_NEAR(q.norm(), 1, 4 * u);
        Vec4<double> expected(std::cos(angle / 2), 0, 0, 0);
        expected.tail<3>() = std::sin(angle / 2) * a;
        const double difference = std::min((q - expected).norm(), (q + expected).norm());
        worst = std::max(worst, difference / ((8 + 4 * angle) * u));
        EXPECT_LE((rotation_of<double>(q) - R).cwiseAbs().maxCoeff(), 16 * u);
      }
  EXPECT_LE(worst, 1);
  EXPECT_GT(worst, 0.05);
}

// case K-04: over integer quaternions the 24 rotations of the cube are exact in double, form a group, and
// come back.
TEST(RotationOf, GivesTheCubeGroupExactly) {
  const std::vector<Vec4<double>> group = cube_group();
  ASSERT_EQ(group.size(), 24u);
  std::set<std::vector<double>> matrices;
  const auto key = [](const Mat3<double>& R) { return std::vector<double>(R.data(), R.data() + 9); };
  for (const Vec4<double>& q : group) {
    const Mat3<double> R = rotation_of<double>(q) + zero33<double>();  // −0 + 0 = 0: one key each
    EXPECT_EQ(orthonormality_defect<double>(R), 0);
    EXPECT_EQ(determinant(R), 1);
    EXPECT_EQ(R.cwiseAbs().sum(), 3);  // nine entries, three of them ±1
    matrices.insert(key(R));
  }
  EXPECT_EQ(matrices.size(), 24u);
  for (const Vec4<double>& p : group)
    for (const Vec4<double>& q : group)
      EXPECT_EQ(matrices.count(key(rotation_of<double>(p) * rotation_of<double>(q) + zero33<double>())), 1u);
}

TEST(RotationOf, TurnsVectorsAsTheQuaternionProductDoes) {
  // q (0, x) q̄ / |q|², written out: x + 2/n (s v × x + v × (v × x)).
  const Vec4<Q> q(Q(1), Q(2), Q(-1), Q(3));
  const Vec3<Q> v(Q(2), Q(-1), Q(3)), x(Q(5), Q(7), Q(-4));
  const Vec3<Q> vx = cross<Q>(v, x), expected = x + (vx + cross<Q>(v, vx)) * (Q(2) / Q(15));
  EXPECT_EQ(Vec3<Q>(rotation_of<Q>(q) * x), expected);
  EXPECT_EQ(orthonormality_defect<Q>(rotation_of<Q>(q)), Q(0));
}

TEST(QuaternionOf, AgreesWithTheCubeGroupAndAxisAngle) {
  for (const Vec4<double>& q : cube_group()) {
    const Mat3<double> R = rotation_of<double>(q);
    EXPECT_LE((rotation_of<double>(quaternion_of<double>(R)) - R).cwiseAbs().maxCoeff(), 4 * u);
    const double s = q.tail<3>().norm(), angle = 2 * std::atan2(s, q[0]);
    const Vec3<double> theta = s == 0 ? zero3<double>() : Vec3<double>(q.tail<3>() * (angle / s));
    EXPECT_LE((exp_so3<double>(theta) - R).cwiseAbs().maxCoeff(), 16 * u);
  }
}

// case K-10: q and −q are one rotation, to the bit.
TEST(RotationOf, IsTheSameForTheOppositeQuaternion) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 100; ++i) {
    const Vec3<double> a = direction(random), b = direction(random);
    const Vec4<double> q(a[0], a[1], b[0], b[1]);
    EXPECT_EQ(rotation_of<double>(q), rotation_of<double>(-q));
  }
}

TEST(AngleBetween, KeepsItsDigitsForSmallAngles) {
  std::mt19937_64 random(6);
  for (const double angle : {1e-12, 1e-6, 1e-3, 0.5, 3.0}) {
    const Mat3<double> R = exp_so3<double>(direction(random)),
                       S = R * exp_so3<double>(angle * direction(random));
    EXPECT_NEAR((angle_between<double>(R, S)), angle, 16 * u / std::cos(angle / 2));
  }
}

TEST(OrthonormalityDefect, SeesStretchSkewAndNaN) {
  Mat3<double> R = identity3<double>();
  EXPECT_EQ(orthonormality_defect<double>(R), 0);
  R(0, 0) = 1.5;
  EXPECT_EQ(orthonormality_defect<double>(R), 1.25);
  R = identity3<double>();
  R(0, 1) = 0.25;
  EXPECT_EQ(orthonormality_defect<double>(R), 0.25);
  R(2, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(orthonormality_defect<double>(R)));
}

TEST(Types, ProductsAreTheirDefinitions) {
  const Vec3<Q> a(Q(1), Q(2), Q(3)), b(Q(-4), Q(5, 7), Q(6));
  Mat3<Q> M;
  M << Q(1), Q(2), Q(3), Q(4), Q(5), Q(6), Q(7), Q(8), Q(10);
  EXPECT_EQ(dot<Q>(a, b), Q(-4) + Q(10, 7) + Q(18));
  EXPECT_EQ(cross<Q>(a, b), Vec3<Q>(Q(12) - Q(15, 7), Q(-12) - Q(6), Q(5, 7) + Q(8)));
  EXPECT_EQ(Vec3<Q>(skew<Q>(a) * b), cross<Q>(a, b));
  EXPECT_EQ(apply<Q>(M, a), Vec3<Q>(M * a));
  EXPECT_EQ(apply_transposed<Q>(M, a), Vec3<Q>(M.transpose() * a));
  EXPECT_EQ(norm<Q>(Vec3<Q>(Q(2, 7), Q(3, 7), Q(6, 7))), Q(1));
}

}  // namespace rigor
