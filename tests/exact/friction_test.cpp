#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <rigor/bodies/plane.hpp>
#include <rigor/formulas/friction_tangent.hpp>
#include <rigor/formulas/positional_correction.hpp>
#include <tests/exact/draw.hpp>

namespace rigor {

// Vectors with a given tangent t ⊥ n: two columns of a rotation, any multiple of n added. The root of the
// formula is then exact, and a nearly normal velocity is as good as any.
// id: friction.tangent
TEST(FrictionTangent, IsTheDirectionOfTheSlipElseOfTheForceElseNone) {
  Draw draw(51);
  for (int i = 0; i < draws; ++i) {
    const Mat3<Q> R = draw.rotation();
    const Vec3<Q> n = R.col(0), t = R.col(1), other = R.col(2);
    const Vec3<Q> slipping = draw.number() * n + draw.positive() * t, normal = draw.number() * n;
    const Vec3<Q> force = draw.number() * n + draw.positive() * other;
    EXPECT_EQ(friction_tangent<Q>(slipping, force, n), t);
    EXPECT_EQ(friction_tangent<Q>(Vec3<Q>(-slipping), force, n), Vec3<Q>(-t));
    EXPECT_EQ(friction_tangent<Q>(slipping, force, Vec3<Q>(-n)), t);  // the sign of n does not matter
    EXPECT_EQ(friction_tangent<Q>(normal, force, n), other);
    EXPECT_EQ(friction_tangent<Q>(normal, normal, n), zero3<Q>());
    EXPECT_EQ(friction_tangent<Q>(zero3<Q>(), zero3<Q>(), n), zero3<Q>());
  }
}

// id: contact.correction
TEST(PositionalCorrection, PutsTheDeepestCornerOnThePlaneAndLeavesAFreeBodyAlone) {
  Draw draw(52);
  for (int i = 0; i < draws; ++i) {
    const Body body = draw_body(draw);
    const Vec3<Q> n = draw.unit();
    const auto deepest_gap = [&](const Plane<Q>& plane, const Vec3<Q>& shift) {
      Q least;
      for (int k = 0; k < 8; ++k) {
        const Vec3<Q> corner = body.state.p_WB + shift + body.state.R_WB * body.shape.corner(k);
        const Q gap = plane.gap(corner);
        if (k == 0 || gap < least) least = gap;
      }
      return least;
    };
    // A plane through the centre is penetrated; one moved down by the full diagonal's square is not.
    const Plane<Q> through = *Plane<Q>::make(body.state.p_WB, n);
    const Q depth = -deepest_gap(through, zero3<Q>());
    ASSERT_GT(depth, Q(0));
    const Vec3<Q> shift = positional_correction<Q>(depth, n);
    EXPECT_EQ(deepest_gap(through, shift), Q(0));
    EXPECT_EQ(cross<Q>(shift, n), zero3<Q>());
    EXPECT_EQ(positional_correction<Q>(Q(0), n), zero3<Q>());
    EXPECT_EQ(positional_correction<Q>(-depth, n), zero3<Q>());
  }
}

// However little it is inside.
TEST(PositionalCorrection, MovesASmallDepthToo) {
  const Vec3<Q> n(Q(2, 7), Q(3, 7), Q(6, 7));
  EXPECT_EQ(positional_correction<Q>(Q(1, 1000), n), Vec3<Q>(Q(1, 1000) * n));
}

// Zero slip is judged at 16 u of the velocity: a tangential part of 16.5 u gives a direction, one of 15.5 u none.
TEST(FrictionTangent, CountsSixteenRoundingsOfTheVelocityAsNoSlip) {
  const Vec3<double> n(0, 1, 0), none = zero3<double>();
  const double u = 0x1p-53;
  EXPECT_EQ(friction_tangent<double>(Vec3<double>(16.5 * u, 1, 0), none, n), Vec3<double>(1, 0, 0));
  EXPECT_EQ(friction_tangent<double>(Vec3<double>(15.5 * u, 1, 0), none, n), none);
}

// A velocity along n has none, whatever the axes: rounding leaves up to 7.5 u of it across (2e7 draws; more than 4 u in 3 of 1000).
TEST(FrictionTangent, SeesNoSlipInAPurelyNormalVelocity) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> any;
  for (int i = 0; i < 100000; ++i) {
    Vec3<double> n(any(random), any(random), any(random));
    n /= norm<double>(n);
    EXPECT_EQ(friction_tangent<double>(Vec3<double>(-std::exp(any(random)) * n), zero3<double>(), n), zero3<double>()) << i;
  }
}

}  // namespace rigor
