#include <gtest/gtest.h>

#include <rigor/formulas/cuboid_inertia.hpp>
#include <rigor/formulas/cuboid_inverse_inertia.hpp>
#include <rigor/formulas/world_inertia.hpp>
#include <rigor/formulas/world_inverse_inertia.hpp>
#include <tests/exact/draw.hpp>
#include <tests/exact/point_masses.hpp>

namespace rigor {
namespace {

/// Σ m (p·p 1 − p pᵀ), from the definition.
Mat3<Q> inertia_of(const std::vector<PointMass>& points) {
  Mat3<Q> I = zero33<Q>();
  for (const auto& [m, p] : points)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) I(i, j) += m * ((i == j ? p.dot(p) : Q(0)) - p[i] * p[j]);
  return I;
}

Mat3<Q> diagonal(const Vec3<Q>& d) {
  Mat3<Q> D = zero33<Q>();
  for (int i = 0; i < 3; ++i) D(i, i) = d[i];
  return D;
}

}  // namespace

// case I-06, with Simpson's product rule for Gauss's: both are exact for quadratics.
// id: inertia.cuboid
TEST(CuboidInertia, IsTheVolumeIntegralWithoutProductsOfInertia) {
  Draw draw(1);
  for (int i = 0; i < draws; ++i) {
    const Q m = draw.positive();
    const Vec3<Q> s_B = draw.lengths();
    EXPECT_EQ(diagonal(cuboid_inertia<Q>(m, s_B)), inertia_of(point_masses(m, s_B, identity3<Q>())));
  }
}

// case I-01: trace = m (a² + b² + c²)/6. case I-02: I₁ + I₂ − I₃ = m c²/6 and its two neighbours, hence the
// three triangle inequalities, with equality only at zero thickness.
TEST(CuboidInertia, HasTheTraceAndTheTriangleExcessOfAPlateStack) {
  Draw draw(2);
  for (int i = 0; i < draws; ++i) {
    const Q m = draw.positive();
    const Vec3<Q> s = draw.lengths(), I = cuboid_inertia<Q>(m, s);
    EXPECT_EQ(I[0] + I[1] + I[2], m * s.dot(s) / Q(6));
    for (int k = 0; k < 3; ++k) {
      const Q excess = I[(k + 1) % 3] + I[(k + 2) % 3] - I[k];
      EXPECT_EQ(excess, m * s[k] * s[k] / Q(6));
      EXPECT_GT(excess, Q(0));
    }
    const Vec3<Q> plate = cuboid_inertia<Q>(m, Vec3<Q>(s[0], s[1], Q(0)));
    EXPECT_EQ(plate[0] + plate[1], plate[2]);
  }
}

// case I-03: cut the cuboid in eight by three planes anywhere; parallel axes put it together again.
TEST(CuboidInertia, OfEightPiecesShiftedToTheCommonCentreIsThatOfTheWhole) {
  Draw draw(3);
  for (int i = 0; i < draws; ++i) {
    const Q m = draw.positive();
    const Vec3<Q> s = draw.lengths(), cut(draw.fraction(), draw.fraction(), draw.fraction());
    Mat3<Q> sum = zero33<Q>();
    for (int piece = 0; piece < 8; ++piece) {
      Vec3<Q> edge, centre;
      Q share = m;
      for (int k = 0; k < 3; ++k) {
        const bool upper = piece >> k & 1;
        const Q part = upper ? Q(1) - cut[k] : cut[k];
        edge[k] = part * s[k];
        centre[k] = (upper ? cut[k] + part / Q(2) : part / Q(2)) * s[k] - s[k] / Q(2);
        share *= part;
      }
      sum += diagonal(cuboid_inertia<Q>(share, edge)) + inertia_of({{share, centre}});
    }
    EXPECT_EQ(sum, diagonal(cuboid_inertia<Q>(m, s)));
  }
}

// id: inertia.cuboid_inverse
TEST(CuboidInverseInertia, TimesTheInertiaIsOne) {
  Draw draw(4);
  for (int i = 0; i < draws; ++i) {
    const Vec3<Q> I = draw.lengths(), inverse = cuboid_inverse_inertia<Q>(I);
    EXPECT_EQ(Mat3<Q>(diagonal(I) * diagonal(inverse)), identity3<Q>());
  }
}

// id: inertia.world
TEST(WorldInertia, IsTheVolumeIntegralOverTheTurnedCuboid) {
  Draw draw(5);
  for (int i = 0; i < draws; ++i) {
    const Q m = draw.positive();
    const Vec3<Q> s_B = draw.lengths();
    const Mat3<Q> R_WB = draw.rotation();
    EXPECT_EQ(world_inertia<Q>(R_WB, cuboid_inertia<Q>(m, s_B)), inertia_of(point_masses(m, s_B, R_WB)));
  }
}

// case I-04: the three invariants of the tensor do not turn; symmetric to the bit.
TEST(WorldInertia, KeepsTraceDeterminantAndSecondInvariant) {
  Draw draw(6);
  for (int i = 0; i < draws; ++i) {
    const Vec3<Q> I = draw.lengths();
    const Mat3<Q> I_W = world_inertia<Q>(draw.rotation(), I);
    EXPECT_EQ(I_W(0, 0) + I_W(1, 1) + I_W(2, 2), I[0] + I[1] + I[2]);
    EXPECT_EQ(determinant(I_W), I[0] * I[1] * I[2]);
    Q squares = 0;  // tr(I²)
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) squares += I_W(a, b) * I_W(a, b);
    EXPECT_EQ(squares, I.dot(I));
    EXPECT_EQ(I_W, Mat3<Q>(I_W.transpose()));
  }
}

// case I-05
// id: inertia.world_inverse
TEST(WorldInverseInertia, TimesTheWorldInertiaIsOne) {
  Draw draw(7);
  for (int i = 0; i < draws; ++i) {
    const Body body = draw_body(draw);
    const Mat3<Q> inverse = world_inverse_inertia<Q>(body.state.R_WB, body.shape.inverse_inertia());
    EXPECT_EQ(Mat3<Q>(body.inertia() * inverse), identity3<Q>());
  }
}

}  // namespace rigor
