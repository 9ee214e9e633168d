#include <gtest/gtest.h>

#include <limits>
#include <rigor/bodies/cuboid.hpp>
#include <rigor/bodies/plane.hpp>
#include <rigor/linalg/rotation.hpp>
#include <set>

namespace rigor {
namespace {

const double inf = std::numeric_limits<double>::infinity(), nan_ = std::numeric_limits<double>::quiet_NaN();

std::string where(double m, const Vec3<double>& s) {
  const auto made = Cuboid<double>::make(m, s);
  return made ? "" : made.fault().where;
}

}  // namespace

// case I-07, S-08
TEST(Cuboid, RefusesWhatIsNoMassOrSizeAndNamesTheField) {
  using Kind = Fault::Kind;
  const Vec3<double> s(1, 2, 3);
  EXPECT_EQ(where(2, s), "");
  for (const double bad : {0.0, -0.0, -1.0, nan_, inf, -inf}) {
    EXPECT_EQ(where(bad, s), "mass") << bad;
    EXPECT_EQ(where(2, {bad, 2, 3}), "size[0]") << bad;
    EXPECT_EQ(where(2, {1, bad, 3}), "size[1]") << bad;
    EXPECT_EQ(where(2, {1, 2, bad}), "size[2]") << bad;
  }
  EXPECT_EQ(Cuboid<double>::make(nan_, s).fault().kind, Kind::not_finite);
  EXPECT_EQ(Cuboid<double>::make(-1, s).fault().kind, Kind::not_positive);
  EXPECT_EQ(Cuboid<double>::make(-1, s).fault().text(), "mass must be > 0");
  // Sizes whose squares overflow, vanish, or whose reciprocal moments do.
  for (const double edge : {1e200, 1e-200, 0x1p-1074, 1e154, 1e-160})
    EXPECT_EQ(Cuboid<double>::make(1, {edge, edge, edge}).fault().kind, Kind::out_of_range) << edge;
  EXPECT_EQ(Cuboid<double>::make(0x1p-1074, s).fault().kind, Kind::out_of_range);
}

// case I-08: the unit of length changed by 2^k changes moments by 2^2k exactly, or the fault says out of
// range.
TEST(Cuboid, ScalesItsInertiaByPowersOfTwoExactly) {
  const Vec3<double> s(0.1, 0.4, 0.9);
  const auto one = *Cuboid<double>::make(10, s);
  int made = 0;
  for (int k = -600; k <= 600; ++k) {
    const auto scaled =
        Cuboid<double>::make(10, {std::ldexp(s[0], k), std::ldexp(s[1], k), std::ldexp(s[2], k)});
    if (!scaled) {
      EXPECT_EQ(scaled.fault().kind, Fault::Kind::out_of_range);
      continue;
    }
    ++made;
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(scaled->inertia()[i], std::ldexp(one.inertia()[i], 2 * k)) << k;
      EXPECT_EQ(scaled->inverse_inertia()[i], std::ldexp(one.inverse_inertia()[i], -2 * k)) << k;
    }
  }
  EXPECT_GE(made, 1001);  // k = −500 … 500 at least: moments from 1e-302 to 1e301
}

TEST(Cuboid, NumbersItsCornersByTheBitsOfTheirSigns) {
  const auto c = *Cuboid<double>::make(1, {2, 4, 6});
  std::set<std::vector<double>> all;
  for (int k = 0; k < 8; ++k) {
    const Vec3<double> p = c.corner(k);
    EXPECT_EQ(p, Vec3<double>(k & 1 ? 1 : -1, k & 2 ? 2 : -2, k & 4 ? 3 : -3));
    all.insert({p[0], p[1], p[2]});
  }
  EXPECT_EQ(all.size(), 8u);
}

// case S-08 (normal not unit)
TEST(Plane, WantsAFinitePointAndAUnitNormalAndRepairsNeither) {
  const Vec3<double> n(2.0 / 7, 3.0 / 7, 6.0 / 7), p(1, 2, 3);
  const auto plane = Plane<double>::make(p, n);
  ASSERT_TRUE(plane);
  EXPECT_EQ(plane->normal(), n);
  EXPECT_NEAR(plane->gap(p + 5 * n), 5, 1e-14);  // 5 terms of size ≤ 8, each within 4u
  EXPECT_LT(plane->gap(p - 0.5 * n), 0);
  EXPECT_EQ(plane->gap(p), 0);
  EXPECT_EQ(Plane<double>::make(p, {0, 2, 0}).fault().where, "normal");
  EXPECT_EQ(Plane<double>::make(p, {0, 0, 0}).fault().kind, Fault::Kind::not_unit);
  EXPECT_EQ(Plane<double>::make(p, {0, nan_, 1}).fault().kind, Fault::Kind::not_finite);
  EXPECT_EQ(Plane<double>::make({0, inf, 0}, n).fault().where, "point[1]");
  EXPECT_TRUE(Plane<double>::make(p, {0.577350269, 0.577350269, 0.577350269}));  // nine digits
  EXPECT_FALSE(Plane<double>::make(p, {0.5773502, 0.5773502, 0.5773502}));       // seven
}

}  // namespace rigor
