// The search for the next contact with a plane, each of the eight corners in turn.
#include <gtest/gtest.h>

#include <cmath>
#include <rigor/engine/plane_search.hpp>
#include <rigor/linalg/rotation.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;

struct Block {
  Cuboid<double> shape = *Cuboid<double>::make(2, {1, 2, 3});
  State<double> state;
  // A plane that only corner k of the cuboid can touch, `below` it by so many metres.
  Plane<double> under(int k, double below) const {
    const V out = apply<double>(state.R_WB, shape.corner(k));
    return *Plane<double>::make(V(state.p_WB + (1 + below / norm<double>(out)) * out), V(-out / norm<double>(out)));
  }
};
Block turned() {
  Block block;
  block.state.p_WB = V(0.25, -0.5, 1), block.state.R_WB = rotation_of<double>(Vec4<double>(1, 2, -1, 3));
  return block;
}

// Half a diagonal 7/2; 16 u of the terms of a gap and of the speeds in a rate. Gaps and rates by the corners themselves.
TEST(CornerGaps, RoundingIsSixteenUnitsOfTheTerms) {
  const auto shape = *Cuboid<double>::make(2, {2, 3, 6});
  const auto plane = *Plane<double>::make(V(8, -16, 64), V(2, 1, -2) / 3);
  State<double> s;
  s.p_WB = V(1, -2, 4), s.R_WB = rotation_of<double>(Vec4<double>(1, 2, -1, 3)), s.v_WB = V(3, 4, 12), s.w_WB = V(2, -3, 6);
  const CornerGaps c = corner_gaps(shape, s, plane);
  EXPECT_NEAR(c.rounding / (16 * 0x1p-53 * (3.5 + (2 * (1 + 8) + (2 + 16) + 2 * (4 + 64)) / 3.0)), 1, 1e-15);
  EXPECT_NEAR(c.still / (16 * 0x1p-53 * (13 + 7 * 7)), 1, 1e-15);
  for (int k = 0; k < 8; ++k) {
    const V r = s.R_WB * shape.corner(k);
    EXPECT_NEAR(c.gap[std::size_t(k)], (V(s.p_WB + r - plane.point()).dot(plane.normal())), 1e-13);
    EXPECT_NEAR(c.rate[std::size_t(k)], (V(s.v_WB + cross<double>(s.w_WB, r)).dot(plane.normal())), 1e-13);
    EXPECT_EQ(c.touches(k), c.gap[std::size_t(k)] <= c.rounding);
  }
}

// Pressed against the plane at rest: there is no time to name, whichever corner it is.
TEST(NextPlaneContact, IsTangledWhereAnyOneCornerStays) {
  const Block block = turned();
  for (int k = 0; k < 8; ++k) {
    const Plane<double> plane = block.under(k, 0);
    const Flight flight(block.shape, block.state, V(-9.81 * plane.normal()));
    EXPECT_EQ(next_plane_contact(block.shape, flight, plane, 0, 1).kind, PlaneContact::Kind::tangled) << k;
  }
}

// Thrown at the plane without spin, a metre away at 2 m/s and 9.81 m/s^2: τ by the formula for a fall.
TEST(NextPlaneContact, IsWhereTheFirstOfEightCornersTouches) {
  Block block = turned();
  const double fall = (-2 + std::sqrt(4 + 2 * 9.81)) / 9.81;
  for (int k = 0; k < 8; ++k) {
    const Plane<double> plane = block.under(k, 1);
    block.state.v_WB = V(-2 * plane.normal());
    const Flight flight(block.shape, block.state, V(-9.81 * plane.normal()));
    const PlaneContact found = next_plane_contact(block.shape, flight, plane, 0, 1);
    EXPECT_EQ(found.kind, PlaneContact::Kind::impact) << k;
    EXPECT_NEAR(found.tau, fall, 1e-14) << k;  // 3 roundings of a place of size 3, over 5 m/s
    const PlaneContact none = next_plane_contact(block.shape, flight, plane, 0, fall / 2);
    EXPECT_EQ(none.kind, PlaneContact::Kind::none) << k;
    EXPECT_EQ(none.tau, fall / 2);
  }
}

}  // namespace
}  // namespace rigor
