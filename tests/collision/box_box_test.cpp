#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <rigor/collision/box_box.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/scalar/gamma.hpp>
#include <tests/collision/exact_sat.hpp>
#include <tests/collision/poses.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;
using Random = std::mt19937_64;

double uniform(Random& random, double low, double high) { return low + (high - low) * (double(random() >> 11) * 0x1p-53); }
Mat3<double> turn(Random& random) {
  std::normal_distribution<double> N;
  return rotation_of<double>(Vec4<double>(N(random), N(random), N(random), N(random)));
}
Manifold touch(const Body& a, const Body& b) { return box_box(a.shape, a.pose, b.shape, b.pose); }
Separation apart(const Body& a, const Body& b) { return separation(a.shape, a.pose, b.shape, b.pose); }
double extent(const Body& a, const Body& b) { return (a.shape.size().sum() + b.shape.size().sum()) / 2 + norm<double>(V(b.pose.p_WB - a.pose.p_WB)); }
bool inside(const Body& b, const V& point, double grown) {
  const V local = apply_transposed<double>(b.pose.R_WB, V(point - b.pose.p_WB));
  for (int i = 0; i < 3; ++i)
    if (!(std::fabs(local[i]) <= b.shape.size()[i] / 2 + grown)) return false;
  return true;
}

// Six size classes: cubes, small cubes, slabs, needles, anything, one of each.
V size_of(Random& random, int kind) {
  switch (kind) {
    case 0: return V::Constant(1);
    case 1: return V::Constant(0.05);
    case 2: return V(uniform(random, 1, 2), uniform(random, 0.01, 0.05), uniform(random, 1, 2));
    case 3: return V(uniform(random, 0.01, 0.05), uniform(random, 1, 2), uniform(random, 0.01, 0.05));
    default: return V(uniform(random, 0.1, 2), uniform(random, 0.1, 2), uniform(random, 0.1, 2));
  }
}
// A pose near contact: where the centres' distance makes the gap small either way.
std::pair<Body, Body> near_contact(Random& random, int kind) {
  Body a = body(size_of(random, kind == 5 ? 2 : kind), V(uniform(random, -3, 3), uniform(random, -3, 3), uniform(random, -3, 3)), turn(random));
  Body b = body(size_of(random, kind == 5 ? 3 : kind), zero3<double>(), turn(random));
  std::normal_distribution<double> N;
  V direction(N(random), N(random), N(random));
  direction /= norm<double>(direction);
  double near = 0, far = (norm<double>(a.shape.size()) + norm<double>(b.shape.size()));
  for (int i = 0; i < 40; ++i) {  // bisect the distance at which they part
    const double middle = (near + far) / 2;
    b.pose.p_WB = a.pose.p_WB + middle * direction;
    (apart(a, b).gap > 0 ? far : near) = middle;
  }
  const double scale = std::pow(10, uniform(random, -12, -1));
  b.pose.p_WB = a.pose.p_WB + (near + uniform(random, -1, 1) * scale) * direction;
  return {a, b};
}
long poses() {  // RIGOR_POSES for a soak
  const char* asked = std::getenv("RIGOR_POSES");
  return asked != nullptr ? std::atol(asked) : 24000;
}

// Lengths in units of 2^-30 m or of 2^30: the same axis and normal to the bit, gap, depth and points in those units.
TEST(BoxBox, DoesNotCareHowLargeTheBoxesAre) {
  Random random(21);
  int edges = 0;
  for (int k = 0; k < 600; ++k) {
    const auto [a, b] = near_contact(random, k % 6);
    const Manifold found = touch(a, b);
    edges += found.touches() && found.axis >= 6;
    for (const double unit : {0x1p-30, 0x1p30}) {
      const auto in_units = [&](const Body& one) { return body(unit * one.shape.size(), unit * one.pose.p_WB, one.pose.R_WB); };
      const Body small_a = in_units(a), small_b = in_units(b);
      const Manifold same = touch(small_a, small_b);
      EXPECT_EQ(apart(small_a, small_b).gap, unit * apart(a, b).gap);
      ASSERT_EQ(same.count, found.count);
      if (!found.touches()) continue;
      EXPECT_EQ(same.axis, found.axis);
      EXPECT_EQ(same.n_AB_W, found.n_AB_W);
      EXPECT_EQ(same.depth, unit * found.depth);
      for (std::size_t i = 0; i < std::size_t(found.count); ++i) {
        EXPECT_EQ(same.points[i].p_WC, V(unit * found.points[i].p_WC));
        EXPECT_EQ(same.points[i].depth, unit * found.points[i].depth);
      }
    }
  }
  EXPECT_GT(edges, 20) << "of the contacts are of edges";
}

// Turned against each other by 1e-8 to 1e-6 rad about an axis none of whose edges is special: a direction between two
// nearly parallel edges is known to u/sine only, and must not win over a face by its rounding.
TEST(BoxBox, NearlyParallelEdgesDoNotWinByRounding) {
  Random random(22);
  std::normal_distribution<double> N;
  for (int k = 0; k < 20000; ++k) {
    Body a = body(size_of(random, 4), V(uniform(random, -3, 3), uniform(random, -3, 3), uniform(random, -3, 3)), turn(random)), b = a;
    V about(N(random), N(random), N(random));
    about *= std::pow(10, uniform(random, -8, -6)) / norm<double>(about);
    b.pose.R_WB = exp_so3<double>(about) * a.pose.R_WB;
    const int face = k % 3;
    V offset(uniform(random, -0.5, 0.5), uniform(random, -0.5, 0.5), uniform(random, -0.5, 0.5));
    offset = offset.cwiseProduct(a.shape.size());
    offset[face] = a.shape.size()[face] * (1 - std::pow(10, uniform(random, -5, -3)));
    b.pose.p_WB = a.pose.p_WB + a.pose.R_WB * offset;
    const Manifold found = touch(a, b);
    ASSERT_TRUE(found.touches());
    EXPECT_FALSE(found.axis == 6 || found.axis == 10 || found.axis == 14) << k;  // a nearly parallel pair
  }
}

// case BB-08: the sign of the gap is that of exact rationals outside a band of 40 u of the extents, at poses chosen
// within 1e-12 to 1e-1 of contact.
TEST(BoxBox, SignOfTheGapAgreesWithExactRationals) {
  Random random(8);
  long wrong_outside = 0, inside_band = 0;
  for (int k = 0; k < 3000; ++k) {
    const auto [a, b] = near_contact(random, k % 6);
    const double gap = apart(a, b).gap, band = 40 * unit_roundoff<double>() * extent(a, b);
    const int sign = exact_sign_of_gap(a.shape, a.pose, b.shape, b.pose);
    if (std::fabs(gap) <= band) ++inside_band;
    else if ((gap > 0) != (sign > 0)) ++wrong_outside;
  }
  EXPECT_EQ(wrong_outside, 0);
  EXPECT_LT(inside_band, 300) << "a band that swallows everything proves nothing";
}

// case BB-11: over random poses in six size classes, no phantom, none missed, none too deep, one unit normal, at most
// eight points, each within half its depth of both boxes.
TEST(BoxBox, ManifoldsKeepTheirInvariants) {
  Random random(11);
  long phantom = 0, missed = 0, deep = 0, outside = 0, touching = 0;
  for (long k = 0; k < poses(); ++k) {
    const auto [a, b] = near_contact(random, int(k % 6));
    const Manifold m = touch(a, b);
    const double scale = extent(a, b), slack = 1e-8 * scale;
    if (std::fabs(apart(a, b).gap) > 1e-13 * scale && k % 6 == 4) {  // the exact judge is slow: every sixth pose
      const int sign = exact_sign_of_gap(a.shape, a.pose, b.shape, b.pose);
      phantom += m.touches() && sign > 0;
      missed += !m.touches() && sign < 0;
    }
    if (!m.touches()) continue;
    ++touching;
    ASSERT_LE(m.count, 8);
    ASSERT_NEAR(norm<double>(m.n_AB_W), 1, 1e-14);
    for (int i = 0; i < m.count; ++i) {
      const ContactPoint& point = m.points[std::size_t(i)];
      deep += point.depth > m.depth + slack;
      outside += !inside(a, point.p_WC, point.depth / 2 + slack) || !inside(b, point.p_WC, point.depth / 2 + slack);
    }
    // the normal is a separating direction: moved apart by the depth, they no longer overlap by more than rounding
    Body moved = b;
    moved.pose.p_WB += (m.depth + slack) * m.n_AB_W;
    deep += apart(a, moved).gap < -slack;
  }
  std::printf("%ld of %ld poses touch\n", touching, poses());
  EXPECT_EQ(phantom, 0);
  EXPECT_EQ(missed, 0);
  EXPECT_EQ(deep, 0);
  EXPECT_EQ(outside, 0);
  EXPECT_GT(touching, poses() / 4);
}

// case BB-09: three analytic poses, each with the boxes exchanged and in six orientations of the pair.
TEST(BoxBox, ReproducesThreeAnalyticPosesInTwelvePermutations) {
  const double pi = 3.14159265358979323846;
  const auto about = [](const V& axis, double angle) { return exp_so3<double>(V(angle * axis)); };
  // unit cubes; the second turned 45 degrees about z, centres 0.5 + sqrt(2)/2 - d apart along x: an edge in a face
  const double root2 = std::sqrt(2.0);
  struct Pose {
    Body a, b;
    double depth;
  };
  const V x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const double depth_1 = root2 / 2 - 0.25, c = std::cos(pi / 8) * root2 / 2 - 0.25;
  const Pose base[] = {
      {body(V::Constant(1)), body(V::Constant(1), V(0.75, 0, 0), about(z, pi / 4)), depth_1},
      {body(V::Constant(1)), body(V::Constant(1), V(0.75, 0, 0), about(z, pi / 8)), c},
      // edge against edge: two cubes turned 45 degrees about z and y, their edges crossing at right angles
      {body(V::Constant(1), zero3<double>(), about(z, pi / 4)), body(V::Constant(1), V(root2 - 0.1, 0, 0), about(y, pi / 4)), 0.1},
  };
  for (const Pose& pose : base)
    for (const bool swapped : {false, true})
      for (int k = 0; k < 6; ++k) {
        const Mat3<double> R = k == 0 ? identity3<double>() : about(k % 3 == 0 ? x : k % 3 == 1 ? y : z, (k + 1) * pi / 2);
        Body a = swapped ? pose.b : pose.a, b = swapped ? pose.a : pose.b;
        for (Body* each : {&a, &b}) {
          each->pose.p_WB = R * each->pose.p_WB;
          each->pose.R_WB = R * each->pose.R_WB;
        }
        const Manifold m = touch(a, b);
        ASSERT_TRUE(m.touches());
        EXPECT_NEAR(m.depth, pose.depth, 1e-14) << k << swapped;
        EXPECT_NEAR(norm<double>(V(m.n_AB_W - (swapped ? -1 : 1) * (R * x))), 0, 1e-14);
      }
}

// case BB-10: tilted by 1e-15 to 1e-1 about a generic axis with 1e-5 overlap, the normal stays a face normal and the
// eight points of a face patch stay.
TEST(BoxBox, SmallTiltsKeepTheFaceNormalAndTheEightPoints) {
  const V axis = V(0.2, 1, 0.4) / norm<double>(V(0.2, 1, 0.4));
  double last = 1e-5;
  for (double tilt = 1e-15; tilt < 1e-6; tilt *= 10) {
    const Mat3<double> R = exp_so3<double>(V(0.3 * V(0, 1, 0))) * exp_so3<double>(V(tilt * axis));
    const Manifold m = touch(body(V(2, 1, 2)), body(V(2, 1, 2), V(0, 1 - 1e-5, 0), R));
    ASSERT_EQ(m.count, 8) << tilt;
    EXPECT_NEAR(m.n_AB_W[1], 1, 1e-12);
    EXPECT_LT(m.axis, 6) << "an edge pair of nearly parallel edges won";
    EXPECT_NEAR(m.depth, last, 4 * tilt + 1e-15);  // depth moves with the tilt, without a jump
    last = m.depth;
  }
}

// case BB-12, case S-07: containment and coincident centres have one documented answer.
TEST(BoxBox, ContainmentAndCoincidenceHaveOneAnswer) {
  const Manifold contained = touch(body(V(4, 4, 4)), body(V(1, 1, 1), V(0.2, 0.1, 0)));
  EXPECT_EQ(contained.axis, 0);  // 2 + 0.5 - 0.2 along x is the shortest way out
  EXPECT_NEAR(contained.depth, 2.3, 1e-15);
  EXPECT_EQ(contained.n_AB_W, V(1, 0, 0));
  const Manifold same = touch(body(V(1, 2, 3)), body(V(1, 2, 3)));
  EXPECT_EQ(same.n_AB_W, V(1, 0, 0));
  EXPECT_EQ(same.depth, 1);
  EXPECT_FALSE(touch(body(V(1, 1, 1)), body(V(1, 1, 1), V(1, 0, 0))).touches()) << "touching exactly is no contact";
  EXPECT_EQ(apart(body(V(1, 1, 1)), body(V(1, 1, 1), V(3, 0, 0))).gap, 2);
}

// case BB-03: exchanging the boxes reverses the normal and keeps the depth; turning and moving the world turns with it.
TEST(BoxBox, DoesNotCareWhoIsFirstOrWhereTheWorldIs) {
  Random random(3);
  for (int k = 0; k < 600; ++k) {
    const auto [a, b] = near_contact(random, k % 6);
    const Separation one = apart(a, b), two = apart(b, a);
    const double scale = extent(a, b);
    EXPECT_NEAR(one.gap, two.gap, 40 * unit_roundoff<double>() * scale);
    const Mat3<double> R = turn(random);
    Body c = a, d = b;
    for (Body* each : {&c, &d}) {
      each->pose.p_WB = R * each->pose.p_WB + V(5, -3, 2);
      each->pose.R_WB = R * each->pose.R_WB;
    }
    EXPECT_NEAR(apart(c, d).gap, one.gap, 1e-13 * (scale + 10));
  }
}

// Every face against every face, by figures: two blocks whose edges lie along the axes, whichever their own axes are. The patch is the
// rectangle in which they overlap, half the depth within either.
TEST(BoxBox, AnyTwoFacesMeetInTheRectangleTheyShare) {
  const V lower(2, 1, 3), upper(1.5, 0.75, 2.5), shift(0.625, 0, -0.75);  // extents along the world's axes
  const double depth = 0.125;
  const auto rotations = cube_rotations();
  for (const Mat3<double>& Q : rotations)
    for (const Mat3<double>& R : rotations) {
      const auto own = [](const Mat3<double>& T, const V& world) { return V(V(T.transpose() * world).cwiseAbs()); };
      const Body a = body(own(Q, lower), V(5, -1, 2), Q), b = body(own(R, upper), V(V(5, -1, 2) + shift + V(0, (1 + 0.75) / 2 - depth, 0)), R);
      for (const bool swapped : {false, true}) {
        const Manifold m = swapped ? touch(b, a) : touch(a, b);
        ASSERT_EQ(m.count, 4);
        EXPECT_LT(norm<double>(V(m.n_AB_W - V(0, swapped ? -1 : 1, 0))), 1e-15);
        EXPECT_NEAR(m.depth, depth, 1e-15);
        V least = V::Constant(1e9), most = V::Constant(-1e9);
        for (int k = 0; k < 4; ++k) {
          least = least.cwiseMin(m.points[std::size_t(k)].p_WC);
          most = most.cwiseMax(m.points[std::size_t(k)].p_WC);
          EXPECT_NEAR(m.points[std::size_t(k)].depth, depth, 1e-15);
        }
        // along x from b's left to a's right, along z from b's near to the nearer of the far ends; y in the middle
        EXPECT_LT(norm<double>(V(least - (V(5, -1, 2) + V(0.625 - 0.75, 0.5 - depth / 2, -1.5)))), 1e-14);
        EXPECT_LT(norm<double>(V(most - (V(5, -1, 2) + V(1, 0.5 - depth / 2, 0.5)))), 1e-14);
        EXPECT_LT(norm<double>(V(m.centroid() - (least + most) / 2)), 1e-14);
      }
    }
}

// A corner in a face, and an edge across an edge, by figures, in every orientation: the point lies halfway between what overlaps.
TEST(BoxBox, ACornerOrAnEdgeTouchesAtOnePointHalfwayIn) {
  const double depth = 0.125, rounding = 40 * unit_roundoff<double>() * 10;  // extents of 10 m; measured 1.1e-14
  for (int corner = 0; corner < 8; ++corner)
    for (const Mat3<double>& Q : cube_rotations()) {
      // the corner's own direction is turned to point straight down, into the top of a plate
      const Body plate = body(V(6, 1, 8), zero3<double>());
      Body die = body(V(1, 1.25, 0.75));
      const V arm = die.shape.corner(corner), axis = cross<double>(V(arm / norm<double>(arm)), V(0, -1, 0));
      die.pose.R_WB = exp_so3<double>(V(axis / norm<double>(axis) * std::acos(-arm[1] / norm<double>(arm))));
      die.pose.p_WB = V(0.5, 0.5 - depth + norm<double>(arm), -0.25);
      for (const bool swapped : {false, true}) {
        Body a = swapped ? die : plate, b = swapped ? plate : die;
        for (Body* each : {&a, &b}) each->pose.p_WB = Q * each->pose.p_WB, each->pose.R_WB = Q * each->pose.R_WB;
        const Manifold m = touch(a, b);
        ASSERT_EQ(m.count, 1);
        EXPECT_NEAR(m.depth, depth, rounding);
        EXPECT_LT(norm<double>(V(m.points[0].p_WC - Q * V(0.5, 0.5 - depth / 2, -0.25))), rounding);
      }
    }
  // two beams that lie on an edge each and cross: turned 45 degrees about x and about the line across, d along y
  const double half = std::sqrt(2.0) / 2, angle = 0.7;  // between the edges
  const Mat3<double> on_edge = exp_so3<double>(V(3.14159265358979323846 / 4 * V(1, 0, 0)));
  for (int own = 0; own < 3; ++own)      // which of its axes lies along the edge
    for (int other = 0; other < 3; ++other)
      for (const Mat3<double>& Q : cube_rotations())
        for (const bool swapped : {false, true}) {
          const auto beam = [](int along) {
            V size = V::Constant(1);
            size[along] = 4;
            Mat3<double> R = zero33<double>();  // own axis `along` to x
            R(0, along) = R(1, (along + 1) % 3) = R(2, (along + 2) % 3) = 1;
            return std::pair{size, R};
          };
          const auto [size_a, turn_a] = beam(own);
          const auto [size_b, turn_b] = beam(other);
          const V across(0.25, 0, -0.5);
          Body a = body(size_a, zero3<double>(), Mat3<double>(on_edge * turn_a));
          Body b = body(size_b, V(V(0, 2 * half - depth, 0) + across), Mat3<double>(exp_so3<double>(V(angle * V(0, 1, 0))) * on_edge * turn_b));
          for (Body* each : {&a, &b}) each->pose.p_WB = Q * each->pose.p_WB, each->pose.R_WB = Q * each->pose.R_WB;
          const Manifold m = swapped ? touch(b, a) : touch(a, b);
          ASSERT_EQ(m.count, 1);
          EXPECT_GE(m.axis, 6);
          EXPECT_NEAR(m.depth, depth, rounding);
          EXPECT_LT(norm<double>(V(m.n_AB_W - (swapped ? -1 : 1) * (Q * V(0, 1, 0)))), rounding);
          // a's edge is z = 0, y = half; b's passes (across x, z) along (cos, -sin): they cross where z = 0
          const V crossing(across[0] + across[2] / std::tan(angle), half - depth / 2, 0);
          EXPECT_LT(norm<double>(V(m.points[0].p_WC - Q * crossing)), rounding) << own << other;
        }
}

// Boxes that overlap by some roundings, generic, parallel, or parallel but for a hair: where rounding clips every point the one that
// stands for them lies in both.
TEST(BoxBox, OverlapsOfAFewRoundingsTouchWhereTheBoxesAre) {
  Random random(13);
  const auto rotations = cube_rotations();
  long touching = 0, outside = 0;
  for (int k = 0; k < 12000; ++k) {
    Body a = body(size_of(random, 4), V{uniform(random, -3, 3), uniform(random, -3, 3), uniform(random, -3, 3)}, turn(random)), b = body(size_of(random, 4));
    const V hair = std::pow(10, uniform(random, -13, -8)) * V{uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)};
    if (k % 3 == 0) b.pose.R_WB = turn(random);
    else b.pose.R_WB = a.pose.R_WB * rotations[random() % 24] * (k % 3 == 1 ? identity3<double>() : exp_so3<double>(hair));
    V direction{uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)};
    direction /= norm<double>(direction);
    double near = 0, far = norm<double>(a.shape.size()) + norm<double>(b.shape.size());
    for (int i = 0; i < 60; ++i) {
      const double middle = (near + far) / 2;
      b.pose.p_WB = a.pose.p_WB + middle * direction;
      (apart(a, b).gap > 0 ? far : near) = middle;
    }
    b.pose.p_WB = a.pose.p_WB + near * (1 - (k % 2 == 0 ? 0 : std::pow(10, uniform(random, -17, -12)))) * direction;
    if (k % 3 != 0 && k % 4 == 0) {  // edges that kiss: within rounding along two axes at once
      V offset = (a.shape.size() + V(V(a.pose.R_WB.transpose() * b.pose.R_WB * b.shape.size()).cwiseAbs())) / 2;
      for (int i = 0; i < 3; ++i) offset[i] *= (random() % 2 == 0 ? 1 : -1) * (k % 9 / 3 == i ? 0.5 : 1 - double(random() % 8) * 0x1p-53);
      b.pose.p_WB = a.pose.p_WB + a.pose.R_WB * offset;
    }
    const Manifold m = touch(a, b);
    touching += m.touches();
    EXPECT_EQ(m.touches(), apart(a, b).gap < 0) << k;
    const double slack = 1e-12 + 4 * norm<double>(hair);  // a corner brought between the sides leaves its own tilted face by that
    for (int i = 0; i < m.count; ++i) outside += !inside(a, m.points[std::size_t(i)].p_WC, slack) || !inside(b, m.points[std::size_t(i)].p_WC, slack);
  }
  EXPECT_EQ(outside, 0);
  EXPECT_GT(touching, 5000);
}

TEST(BoxBox, ApartThereIsNoManifold) {
  const Manifold none = touch(body(V(1, 2, 3), V(0, 0, 0)), body(V(1, 2, 3), V(5, 0, 0)));
  EXPECT_FALSE(none.touches());
  EXPECT_EQ(none.count, 0);
  EXPECT_EQ(none.depth, 0);
  EXPECT_EQ(none.axis, -1);
}

// case S-02: plates of 1 : 1e6 and centres far from the origin.
TEST(BoxBox, ThinPlatesFarFromTheOrigin) {
  const V far(1e6, -2e6, 5e5);
  const Body a = body(V(1, 1e-6, 1), far), b = body(V(1, 1e-6, 1), V(far + V(0.5, 0.9e-6, 0.25)));
  const Manifold m = touch(a, b);
  ASSERT_TRUE(m.touches());
  EXPECT_EQ(m.n_AB_W, V(0, 1, 0));
  EXPECT_NEAR(m.depth, 1e-7, 4 * unit_roundoff<double>() * 2e6);  // the difference of positions is known no better
}

// Corner to corner in the plane across them, edges turned by little more than 1e-8 rad: that pair sees the gap, √2
// times what a face sees, less the noise of its direction, a few u/s of the extents.
TEST(BoxBox, NearlyParallelEdgesTellTheGapLessTheNoiseOfTheirDirection) {
  const double gap = 0.01 * std::sqrt(2), s = 1.2e-8;
  const V diagonal = V(0, 1, 1) / std::sqrt(2);
  const Body a = body(V(1, 1, 1)), b = body(V(1, 1, 1), V(0, 1.01, 1.01), exp_so3<double>(V(s * diagonal)));
  const Separation found = apart(a, b);
  const double noise = unit_roundoff<double>() * extent(a, b) / s;
  EXPECT_EQ(found.axis, 6);
  EXPECT_LT(found.gap, gap - noise);
  EXPECT_GT(found.gap, gap - 20 * noise);
}

// Two bars lying crosswise in each other, edges up: x of the one times y of the other is z.
TEST(BoxBox, TheNormalOfCoincidentCentresIsTheProductOfTheEdges) {
  const double eighth = std::atan(1);
  const Manifold m = touch(body(V(4, 1, 1), zero3<double>(), exp_so3<double>(V(eighth, 0, 0))),
                           body(V(1, 4, 1), zero3<double>(), exp_so3<double>(V(0, eighth, 0))));
  EXPECT_EQ(m.axis, 7);
  EXPECT_NEAR(m.n_AB_W[2], 1, 1e-15);
}

// A tilted box sinks in bit by bit: where its upper corners reach the face to the bit, they are not yet points.
TEST(BoxBox, EveryPointIsDeeperThanNothing) {
  int two = 0, four = 0;
  for (const double tilt : {0.01, 0.02, 0.03}) {
    double z = 0.5 + 0.5 * std::cos(tilt) - 0.5 * std::sin(tilt) - 20 * 0x1p-53;
    for (int k = 0; k < 40; ++k, z += 0x1p-53) {
      const Manifold m = touch(body(V(3, 3, 1)), body(V(1, 1, 1), V(0, 0, z), exp_so3<double>(V(0, tilt, 0))));
      two += m.count == 2, four += m.count == 4;
      for (int i = 0; i < m.count; ++i) EXPECT_GT(m.points[std::size_t(i)].depth, 0) << z;
    }
  }
  EXPECT_GT(two, 20);
  EXPECT_GT(four, 20);
}

TEST(BoxBox, APoseThatIsNoNumberHasNoAxisAndTouchesNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Body a = body(V(1, 1, 1)), nowhere = body(V(1, 1, 1), V(nan, nan, nan));
  EXPECT_EQ(apart(a, nowhere).axis, -1);
  EXPECT_FALSE(touch(a, nowhere).touches());
}

}  // namespace
}  // namespace rigor
