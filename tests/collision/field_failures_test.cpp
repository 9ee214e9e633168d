// case BB-13: situations in which widely used collision libraries were reported to fail (fcl 319, 390, 399, 493, 495;
// libccd 17, 25; mujoco 1800, 3476; bepuphysics1 13), rebuilt from their descriptions. The reports' own digits are not in
// this project; each situation is taken through the 24 rotations of the cube and both orders of the bodies instead.
#include <gtest/gtest.h>

#include <cmath>
#include <rigor/collision/box_box.hpp>
#include <rigor/linalg/rotation.hpp>
#include <tests/collision/exact_sat.hpp>
#include <tests/collision/poses.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;
Body turned(const Body& b, const Mat3<double>& Q) {
  Mat3<double> R = Q * b.pose.R_WB;
  return {b.shape, [&] { State<double> s; s.p_WB = Q * b.pose.p_WB; s.R_WB = R; return s; }()};
}

// In every orientation and order: overlap of this depth along this normal (to rounding), with so many points; or apart.
void expect_contact(const char* what, const Body& a, const Body& b, double depth, const V& n, int points) {
  for (const Mat3<double>& Q : cube_rotations())
    for (const bool swapped : {false, true}) {
      const Body x = turned(swapped ? b : a, Q), y = turned(swapped ? a : b, Q);
      const Manifold found = box_box(x.shape, x.pose, y.shape, y.pose);
      const double size = x.shape.size().sum() + y.shape.size().sum() + norm<double>(V(y.pose.p_WB - x.pose.p_WB));
      ASSERT_TRUE(found.touches()) << what;
      EXPECT_EQ(exact_sign_of_gap(x.shape, x.pose, y.shape, y.pose), -1) << what;
      EXPECT_NEAR(found.depth, depth, 40 * 0x1p-53 * size) << what;
      EXPECT_LT(norm<double>(V(found.n_AB_W - (swapped ? -1 : 1) * (Q * n))), 1e-15) << what;
      EXPECT_EQ(found.count, points) << what;
    }
}
void expect_apart(const char* what, const Body& a, const Body& b) {
  for (const Mat3<double>& Q : cube_rotations())
    for (const bool swapped : {false, true}) {
      const Body x = turned(swapped ? b : a, Q), y = turned(swapped ? a : b, Q);
      EXPECT_FALSE(box_box(x.shape, x.pose, y.shape, y.pose).touches()) << what;
    }
}

// libccd 25: two unit cubes, one upon the other, overlapping a little: no contact was found.
TEST(FieldFailures, StackedCubesThatOverlapALittleTouchAtFourPoints) {
  for (const double depth : {0x1p-7, 0x1p-20, 0x1p-40})
    expect_contact("stacked", body({1, 1, 1}, {0, 0, 0}), body({1, 1, 1}, {0, 1 - depth, 0}), depth, {0, 1, 0}, 4);
}
// libccd 17: a body of 5 m below one of 0.2 m: contact points misplaced.
TEST(FieldFailures, ASmallBoxOnALargeOneTouchesAtItsOwnCorners) {
  const Body large = body({5, 5, 5}, {0, 0, 0}), small = body({0.25, 0.25, 0.25}, {1.5, 2.625 - 0x1p-10, -0.75});
  expect_contact("small on large", large, small, 0x1p-10, {0, 1, 0}, 4);
  const Manifold found = box_box(large.shape, large.pose, small.shape, small.pose);
  for (int k = 0; k < found.count; ++k) {
    EXPECT_NEAR(std::fabs(found.points[k].p_WC[0] - 1.5), 0.125, 1e-15);
    EXPECT_NEAR(std::fabs(found.points[k].p_WC[2] + 0.75), 0.125, 1e-15);
  }
}
// fcl 493, 495: exactly kissing faces, edges and corners: an exception was thrown. Touching is no contact here.
TEST(FieldFailures, KissingBoxesAreApart) {
  expect_apart("faces", body({1, 2, 3}, {0, 0, 0}), body({2, 1, 1}, {1.5, 0.25, -0.5}));
  expect_apart("edges", body({1, 2, 3}, {0, 0, 0}), body({2, 1, 1}, {1.5, 1.5, 0}));
  expect_apart("corners", body({1, 2, 3}, {0, 0, 0}), body({2, 1, 1}, {1.5, 1.5, 2}));
}
// fcl 399, bepuphysics1 13, mujoco 3476: nearly parallel edges: an axis made of cancellation noise won the search.
TEST(FieldFailures, NearlyAlignedBoxesKeepTheFaceNormalAndTheirDepth) {
  for (const double angle : {1e-16, 1e-12, 1e-9, 1e-8, 1e-7, 1e-6}) {
    const double c = std::cos(angle), s = std::sin(angle);
    Mat3<double> R = identity3<double>();  // about the normal: every edge nearly parallel, the overlap unchanged
    R(0, 0) = c, R(0, 2) = s, R(2, 0) = -s, R(2, 2) = c;
    const Body a = body({1, 0.5, 2}, {0, 0, 0}), b = body({0.75, 1, 0.5}, {0.1, 0.75 - 0x1p-12, 0.3}, R);
    for (const bool swapped : {false, true}) {
      const Body &x = swapped ? b : a, &y = swapped ? a : b;
      const Manifold found = box_box(x.shape, x.pose, y.shape, y.pose);
      ASSERT_TRUE(found.touches()) << angle;
      EXPECT_NEAR(found.depth, 0x1p-12, 1e-14) << angle;
      EXPECT_LT(norm<double>(V(found.n_AB_W - V(0, swapped ? -1 : 1, 0))), 1e-15) << angle;
      EXPECT_EQ(found.count, 4) << angle;
    }
  }
}
// mujoco 1800: identical boxes at the same place: a documented answer, the smallest edge along its positive axis.
TEST(FieldFailures, IdenticalBoxesAtOnePlaceGetTheSmallestExtentAlongAPositiveAxis) {
  const Body a = body({1, 0.5, 2}, {3, 4, 5});
  const Manifold found = box_box(a.shape, a.pose, a.shape, a.pose);
  EXPECT_EQ(found.n_AB_W, V(0, 1, 0));
  EXPECT_EQ(found.depth, 0.5);
}
// fcl 319, 390: a plate with one edge of 1e-6 against a cube: depth of the wrong feature.
TEST(FieldFailures, AThinPlateInACubeReportsTheSmallestWayOut) {
  expect_contact("plate", body({1, 1, 1}, {0, 0, 0}), body({2, 0x1p-20, 2}, {0, 0.5 - 0x1p-22, 0}), 0x1p-22 + 0x1p-21, {0, 1, 0}, 4);
}

}  // namespace
}  // namespace rigor
