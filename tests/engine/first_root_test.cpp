// First δ > 0 with s + r δ + c δ²/2 = 0, against parabolas written by their roots: c/2 (δ − a)(δ − b).
#include <gtest/gtest.h>

#include <limits>
#include <rigor/engine/first_root.hpp>

namespace rigor {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(FirstRoot, IsTheLesserPositiveRootOfAParabolaThatOpensUpwards) {
  for (const double a : {0.25, 1.0, 8.0})
    for (const double b : {8.0, 64.0}) EXPECT_EQ(first_root(a * b, -(a + b), 2), a) << b;
  EXPECT_EQ(first_root(3, -2, 2), infinity) << "no root at all";
  EXPECT_EQ(first_root(8, 6, 2), infinity) << "both in the past";
  EXPECT_EQ(first_root(4, -4, 2), 2) << "a double one";
}
TEST(FirstRoot, IsTheOnlyPositiveRootOfOneThatOpensDownwards) {
  for (const double a : {0.25, 1.0, 8.0})
    for (const double b : {0.5, 4.0}) EXPECT_EQ(first_root(a * b, a - b, -2), a) << b;  // −(δ − a)(δ + b)
  EXPECT_EQ(first_root(0, 3, -2), 3) << "from the plane and back";
  EXPECT_EQ(first_root(0, 0, -2), 0);
  EXPECT_EQ(first_root(0, -3, -2), 0);
}
TEST(FirstRoot, OfALine) {
  EXPECT_EQ(first_root(6, -2, 0), 3);
  EXPECT_EQ(first_root(6, 2, 0), infinity);
  EXPECT_EQ(first_root(6, 0, 0), infinity);
  EXPECT_EQ(first_root(0, 0, 0), infinity) << "lies on it for ever: no first moment behind";
  EXPECT_EQ(first_root(0, 0, 2), infinity);
  EXPECT_EQ(first_root(0, -2, 0), 0);
}
// The two terms of −r + √(r² − 2 c s) do not cancel: a root of 2^-40 beside one of 2^40.
TEST(FirstRoot, KeepsASmallRootBesideALargeOne) {
  EXPECT_DOUBLE_EQ(first_root(1, -(0x1p40 + 0x1p-40), 2), 0x1p-40);
  EXPECT_DOUBLE_EQ(first_root(1, -(0x1p40 - 0x1p-40), -2), 0x1p-40);
}

}  // namespace
}  // namespace rigor
