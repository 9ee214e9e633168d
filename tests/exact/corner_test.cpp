#include <gtest/gtest.h>

#include <rigor/formulas/effective_mass.hpp>
#include <tests/exact/draw.hpp>

// What the shape of a cuboid says about the effective mass at its corners (proofs/contact.md).
namespace rigor {
namespace {

/// m K at a corner of a cuboid, the other side immovable.
Mat3<Q> corner_response(const Body& body, int corner) {
  const Vec3<Q> p_WC = body.state.p_WB + body.state.R_WB * body.shape.corner(corner);
  return effective_inverse_mass<Q>(ImpactBody<Q>{}, body.at(p_WC)) * body.mass();
}

}  // namespace

// The characteristic polynomial: (x − 1)(x² − 11x + 1 + 9 + 9 λ₂λ₃), λ₂λ₃ = 2 + 2abc/((a+b)(b+c)(c+a)).
TEST(CornerContact, HasTheEigenvaluesOneAndTwoThatDependOnTheShapeAlone) {
  Draw draw(91);
  for (int i = 0; i < draws; ++i) {
    const Body body = draw_body(draw);
    const Mat3<Q> mK = corner_response(body, int(draw.integer(0, 7)));
    const Vec3<Q> s = body.shape.size() / Q(2), squares(s[0] * s[0], s[1] * s[1], s[2] * s[2]);
    const Q &a = squares[0], &b = squares[1], &c = squares[2];
    const Q product = Q(2) + Q(2) * a * b * c / ((a + b) * (b + c) * (c + a));
    EXPECT_GT(product, Q(2));
    EXPECT_LE(product, Q(9, 4));
    // (1 + 3λ₂) + (1 + 3λ₃) = 11 and (1 + 3λ₂)(1 + 3λ₃) = 1 + 9 + 9 λ₂λ₃
    const Q pair_product = Q(10) + Q(9) * product;
    const Q trace = mK(0, 0) + mK(1, 1) + mK(2, 2);
    Q minors = 0;
    for (int k = 0; k < 3; ++k) {
      const int p = (k + 1) % 3, q = (k + 2) % 3;
      minors += mK(p, p) * mK(q, q) - mK(p, q) * mK(q, p);
    }
    EXPECT_EQ(trace, Q(1) + Q(11));
    EXPECT_EQ(minors, Q(11) + pair_product);
    EXPECT_EQ(determinant(mK), pair_product);
  }
}

TEST(CornerContact, BoundsItsInverseMassesAndItsCoupling) {
  Draw draw(92);
  Q largest_ratio = 0;
  for (int i = 0; i < 200; ++i) {
    const Mat3<Q> mK = corner_response(draw_body(draw), int(draw.integer(0, 7))), R = draw.rotation();
    const Vec3<Q> n = R.col(0), t = R.col(1), Kn = mK * n;
    const Q k_nn = n.dot(Kn), k_tn = abs(t.dot(Kn));
    EXPECT_GE(k_nn, Q(1));
    EXPECT_LT(k_nn, Q(7));
    EXPECT_LT(k_tn, Q(3));
    const Q ratio = k_tn * k_tn / (k_nn * k_nn);
    EXPECT_LT(ratio, Q(9, 7));  // (3/√7)²: no jam for μ < √7/3
    if (largest_ratio < ratio) largest_ratio = ratio;
  }
  EXPECT_GT(largest_ratio, Q(4, 7));  // the bound is not idle
}

// case FR-14: the plane of n and t holds two body axes: n = (sin f, cos f) from the corner's direction, K
// there has the eigenvalues 1 and 4, so μ_P = k_nn/k_tn = (1 + 3 cos² f)/(3 sin f cos f), at least 4/3, which
// is met at tan f = 2.
TEST(CornerContact, InThePlaneHasPainlevesThresholdOfARod) {
  Draw draw(93);
  for (int i = 0; i < 100; ++i) {
    Body body = draw_body(draw);
    const Vec3<Q> r_B = body.shape.corner(int(draw.integer(0, 7)));
    // the contact: the corner's projection on the body's xy plane, which is what planar motion sees
    const Vec3<Q> r(r_B[0], r_B[1], Q(0));
    body.state.R_WB = identity3<Q>(), body.state.p_WB = zero3<Q>();
    Mat3<Q> mK = effective_inverse_mass<Q>(ImpactBody<Q>{}, body.at(r)) * body.mass();
    const Q m = draw.number(), d = Q(1) + m * m, cos_f = (Q(1) - m * m) / d, sin_f = Q(2) * m / d;
    // along r and across it, as rational multiples: |r|² need not be a square, so scale by it
    const Q rr = r.dot(r);
    const Vec3<Q> across(-r[1], r[0], Q(0));
    EXPECT_EQ(Vec3<Q>(mK * r), r);
    EXPECT_EQ(across.dot(Vec3<Q>(mK * across)), Q(4) * rr);
    const Q k_nn = Q(1) * sin_f * sin_f + Q(4) * cos_f * cos_f, k_tn = abs(Q(3) * sin_f * cos_f);
    EXPECT_EQ(k_nn, Q(1) + Q(3) * cos_f * cos_f);
    if (Q(0) < k_tn) {
      EXPECT_GE(k_nn / k_tn, Q(4, 3));
    }
  }
  EXPECT_EQ((Q(1) + Q(3) * Q(1, 5)) / (Q(3) * Q(2, 5)), Q(4, 3));  // tan f = 2: cos² = 1/5, sin cos = 2/5
}

}  // namespace rigor
