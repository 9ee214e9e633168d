#include <gtest/gtest.h>

#include <rigor/collision/box_plane.hpp>
#include <rigor/linalg/rotation.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;

const Cuboid<double> block = *Cuboid<double>::make(1, {2, 1, 4});
const Plane<double> floor_ = *Plane<double>::make(V(7, 0.25, -3), V(0, 1, 0));

// Figures by hand, upright: corners 0, 1, 4, 5 are below, equally deep.
TEST(BoxPlane, CountsTheCornersBehindAndNamesTheFirstOfTheDeepest) {
  State<double> s;
  for (const double y : {0.7, 0.75, 0.875}) {  // into the plane, on it, above
    s.p_WB = V(3, y, -2);
    const auto contact = box_plane(block, s, floor_);
    EXPECT_EQ(contact.behind, y < 0.75 ? 4 : 0) << y;
    EXPECT_EQ(contact.touches(), y < 0.75) << y;
    EXPECT_EQ(contact.deepest, 0) << y;
    EXPECT_NEAR(contact.depth(), 0.75 - y, 1e-15) << y;
    for (int k = 0; k < 8; ++k) {
      EXPECT_EQ(contact.p_BC_W[std::size_t(k)], V(k & 1 ? 1 : -1, k & 2 ? 0.5 : -0.5, k & 4 ? 2 : -2)) << k;
      EXPECT_NEAR(contact.gap[std::size_t(k)], y - 0.75 + (k & 2 ? 1 : 0), 1e-15) << k;
    }
  }
}

// Tilted so that each corner in turn is the lowest.
TEST(BoxPlane, FindsEveryCornerWhereItIsTheDeepest) {
  for (int k = 0; k < 8; ++k) {
    State<double> s;
    const V corner = block.corner(k);
    const V axis = cross<double>(V(corner / norm<double>(corner)), V(0, -1, 0));
    s.R_WB = exp_so3<double>(V(axis / norm<double>(axis) * std::acos(-corner[1] / norm<double>(corner))));  // the corner points down
    s.p_WB = V(-1, 0.25 + norm<double>(corner) - 0.125, 5);
    const auto contact = box_plane(block, s, floor_);
    EXPECT_EQ(contact.deepest, k);
    EXPECT_EQ(contact.behind, 1);
    EXPECT_NEAR(contact.depth(), 0.125, 1e-14);
  }
}

}  // namespace
}  // namespace rigor
