// The assignment's own detection, against figures worked out by hand.
#include <gtest/gtest.h>

#include <rigor/collision/box_box.hpp>
#include <rigor/collision/handed_out_pair.hpp>
#include <rigor/linalg/rotation.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;

const Cuboid<double> brick = *Cuboid<double>::make(1, {2, 1.2, 0.8});
const Mat3<double> quarter = rotation_of<double>(Vec4<double>(1, 0, 0, 1));  // x goes to y

State<double> at(const V& p, const Mat3<double>& R = identity3<double>()) {
  State<double> s;
  s.p_WB = p;
  s.R_WB = R;
  return s;
}
void expect_near(const V& got, const V& want) { EXPECT_LT(norm<double>(V(got - want)), 1e-14) << got.transpose() << " for " << want.transpose(); }

// B stands off along all three axes: of its corners the one that looks back lies in A, grown by a hundredth.
TEST(HandedOutPair, FindsEachCornerOfAnUprightPair) {
  for (int k = 0; k < 8; ++k) {
    const V sign(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1), line = sign.cwiseProduct(V(1.8, 0.3, 0.1)), p_A(3, -4, 5);
    const auto found = handed_out_pair(brick, at(p_A), brick, at(V(p_A + line)));
    ASSERT_TRUE(found) << k;
    expect_near(found->p_WC, V(p_A + sign.cwiseProduct(V(0.8, -0.3, -0.3))));
    expect_near(found->n_AB_W, V(line / line.norm()));
    EXPECT_NEAR(found->depth, 0.4 + 0.01 - 0.3, 1e-14) << "the nearest face is along z";
  }
}

TEST(HandedOutPair, MeasuresTheDepthAlongEveryAxisAndAHundredthBeyond) {
  for (int axis = 0; axis < 3; ++axis)
    for (const double apart : {-0.02, 0.0, 0.009, 0.011}) {
      V line(0.2, 0.2, 0.2);
      line[axis] = brick.size()[axis] + apart;
      const auto found = handed_out_pair(brick, at(zero3<double>()), brick, at(line));
      EXPECT_EQ(found.has_value(), apart < 0.01) << axis << ", " << apart;
      if (found) {
        EXPECT_NEAR(found->depth, 0.01 - apart, 1e-14) << axis;
      }
    }
}

TEST(HandedOutPair, TakesCornersOfBBeforeThoseOfA) {
  const Cuboid<double> hall = *Cuboid<double>::make(1, {9, 8, 7});
  const V line(0.5, 0.25, 0.125);
  const auto outside_in = handed_out_pair(hall, at(zero3<double>()), brick, at(line)), inside_out = handed_out_pair(brick, at(line), hall, at(zero3<double>()));
  ASSERT_TRUE(outside_in && inside_out);  // the first corner of the brick, both times
  for (const auto& found : {*outside_in, *inside_out}) {
    expect_near(found.p_WC, V(line - brick.size() / 2));
    EXPECT_NEAR(found.depth, 3.5 + 0.01 - (0.4 - 0.125), 1e-14);
  }
  expect_near(outside_in->n_AB_W, V(-inside_out->n_AB_W));
  EXPECT_FALSE(handed_out_pair(brick, at(line), hall, at(line))) << "no line of centres";
  const auto both = handed_out_pair(brick, at(zero3<double>()), brick, at(V(1.8, 0.3, 0.1)));  // each has a corner in the other
  ASSERT_TRUE(both);
  expect_near(both->p_WC, V(0.8, -0.3, -0.3));
}

// Its mistake, by hand: with A a quarter turned the corner's arm (1, -.6, -.4) is (-.6, -1, -.4) in A, but the offset stays (.3, 1.5, .2).
TEST(HandedOutPair, DoesNotTurnTheOffset) {
  const V line(0.3, 1.5, 0.2);
  const auto found = handed_out_pair(brick, at(zero3<double>(), quarter), brick, at(line));
  ASSERT_TRUE(found);
  expect_near(found->p_WC, V(line + V(1, -0.6, -0.4)));
  EXPECT_NEAR(found->depth, 0.6 + 0.01 - 0.5, 1e-14);
  // an upright overlap is found, and lost when all of it is turned
  const V over(1.8, 0.3, 0.1);
  EXPECT_TRUE(handed_out_pair(brick, at(zero3<double>()), brick, at(over)));
  EXPECT_FALSE(handed_out_pair(brick, at(zero3<double>(), quarter), brick, at(V(quarter * over), quarter)));
  EXPECT_TRUE(box_box(brick, at(zero3<double>(), quarter), brick, at(V(quarter * over), quarter)).touches());
}

// A corner to the bit on the grown face is not inside: 1.01 − 0.5 and 0.5 + 0.01 are the same double.
TEST(HandedOutPair, TakesTheGrownFaceItselfForOutside) {
  const auto cube = *Cuboid<double>::make(1, {1, 1, 1});
  ASSERT_EQ(1.01 - 0.5, 0.5 + 0.01);
  EXPECT_FALSE(handed_out_pair(cube, at(zero3<double>()), cube, at(V(1.01, 0, 0))));
  EXPECT_TRUE(handed_out_pair(cube, at(zero3<double>()), cube, at(V(std::nextafter(1.01, 0), 0, 0))));
}

}  // namespace
}  // namespace rigor
