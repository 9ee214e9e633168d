#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <rigor/collision/box_index.hpp>

namespace rigor {
namespace {

// Along each axis by itself, and with faces that touch.
TEST(AxisBox, HoldsWhatLiesWithinItAlongEveryAxis) {
  const AxisBox outer{{-1, 2, 5}, {4, 3, 9}}, inner{{0, 2.25, 6}, {3, 2.75, 8}};
  EXPECT_TRUE(holds(outer, inner));
  EXPECT_TRUE(holds(outer, outer));
  for (int k = 0; k < 3; ++k) {
    AxisBox below = inner, above = inner;
    below.low[k] = outer.low[k] - 0.125;
    above.high[k] = outer.high[k] + 0.125;
    EXPECT_FALSE(holds(outer, below)) << k;
    EXPECT_FALSE(holds(outer, above)) << k;
  }
}

// Where a position has more digits than a cell's number: long after a size of 1e-3 m could be told apart at 1e17 m.
TEST(BoxIndex, FindsBoxesFartherAwayThanTheirCellsCanBeCounted) {
  for (int k = 0; k < 3; ++k)
    for (const double far : {1e17, -1e17}) {
      BoxIndex index(40);
      AxisBox first;
      for (std::uint32_t i = 0; i < 40; ++i) {
        AxisBox box{Vec3<double>(1, 2, 3), Vec3<double>(1.001, 2.001, 3.001)};
        box.low[k] = box.high[k] = far;
        box.low[(k + 1) % 3] += 0.01 * i;
        box.high[(k + 1) % 3] += 0.01 * i;
        index.put(i, box);
        if (i == 0) first = box;
      }
      std::vector<std::uint32_t> found;
      index.overlapping(first, found);
      EXPECT_EQ(found, std::vector<std::uint32_t>{0}) << k << ", " << far;
    }
}

// A box is found from its far end, and by a point in it, whichever axis it is long along and wherever it is, after grains have been put: its
// cell is as wide as its longest edge.
TEST(BoxIndex, FindsALongBoxFromItsFarEnd) {
  const double length = 1.49, third = length / 3;  // just below half a metre: a cell for it holds no more
  const Vec3<double> places[] = {Vec3<double>(3, -5, 7), Vec3<double>(-3, -5, -7), Vec3<double>(1, 1 + third, 1 + 2 * third), Vec3<double>(1 + 2 * third, 1 + third, 1),
                                 Vec3<double>(1 + third, 1 + 2 * third, 1), Vec3<double>(1 + 2 * third, 1, 1 + third), Vec3<double>(1, 1 + 2 * third, 1 + third), Vec3<double>(1 + third, 1, 1 + 2 * third)};
  for (const double unit : {1.0, 0.25})
    for (int k = 0; k < 3; ++k)
      for (const Vec3<double>& place : places) {
        BoxIndex index(101);
        const auto put = [&](std::uint32_t i, const Vec3<double>& low, const Vec3<double>& high) { index.put(i, AxisBox{unit * low, unit * high}); };
        put(100, Vec3<double>(-90, 80, 70), Vec3<double>(-89.999, 80.001, 70.001));
        for (std::uint32_t i = 0; i < 100; ++i) {
          const Vec3<double> low = place + Vec3<double>::Constant(0.01 * (double(i) - 42));
          Vec3<double> high = low + Vec3<double>::Constant(0.001);
          high[k] = low[k] + length;
          put(i, low, high);
        }
        for (const double part : {0.0, 0.3, 0.6, 0.99})
          for (const double size : {0.0, 0.0005}) {
            AxisBox asked{index.box(42).low, index.box(42).low};
            asked.low[k] += unit * part * length;
            asked.high = asked.low + Vec3<double>::Constant(unit * size);
            std::vector<std::uint32_t> found;
            index.overlapping(asked, found);
            EXPECT_EQ(found, std::vector<std::uint32_t>{42}) << unit << ", " << k << ", " << place.transpose() << ", " << part << ", " << size;
          }
      }
}

// Against everybody with everybody, while boxes come, move and go: grains and giants, needles, points, far away.
TEST(BoxIndex, FindsThoseThatOverlap) {
  std::mt19937_64 random(11);
  const auto in = [&](double low, double high) { return low + (high - low) * (double(random() >> 11) * 0x1p-53); };
  std::size_t met = 0;
  for (int world = 0; world < 100; ++world) {
    const std::uint32_t n = 1 + std::uint32_t(random() % 200);
    const double spread = std::exp(in(-30, 30)), away = world % 5 == 0 ? 1e9 * spread : 0, sizes = world % 3 == 0 ? 0 : in(0, 12);  // of one size, or of many
    const auto draw = [&] {
      AxisBox box;
      const double size = spread / 10 * std::exp(-in(0, sizes));
      for (int k = 0; k < 3; ++k) {
        box.low[k] = away + in(-spread, spread);
        box.high[k] = box.low[k] + (world % 4 == k ? 0 : size * std::exp(-in(0, world % 2 == 0 ? 0 : 5)));  // needles and plates, too
      }
      return box;
    };
    BoxIndex index(n);
    std::vector<std::optional<AxisBox>> there(n);
    for (int change = 0; change < 600; ++change) {
      const std::uint32_t i = std::uint32_t(random() % n);
      if (change % 7 == 6) {
        index.remove(i);
        there[i].reset();
      } else {
        there[i] = draw();
        index.put(i, *there[i]);
      }
      EXPECT_EQ(index.has(i), there[i].has_value());
      if (there[i]) {
        EXPECT_EQ(index.box(i).low, there[i]->low);
        EXPECT_EQ(index.box(i).high, there[i]->high);
      }
      if (change % 3 != 0) continue;
      const AxisBox asked = there[i] ? *there[i] : draw();
      std::vector<std::uint32_t> found, want;
      index.overlapping(asked, found);
      for (std::uint32_t j = 0; j < n; ++j)
        if (there[j] && overlap(asked, *there[j])) want.push_back(j);
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, want) << "world " << world;
      met += want.size() - 1;
    }
  }
  EXPECT_GT(met, 10000u) << "boxes that never overlap show nothing";
}

// A point asks for no cells to speak of; boxes that hold it are found by cells as wide as they are.
TEST(BoxIndex, FindsBoxesAroundAPoint) {
  BoxIndex index(8);
  for (std::uint32_t i = 0; i < 8; ++i) index.put(i, {Vec3<double>(-1, -1, -1), Vec3<double>(1, 1, 1)});
  std::vector<std::uint32_t> found;
  index.overlapping({Vec3<double>(0, 0, 0), Vec3<double>(0, 0, 0)}, found);
  EXPECT_EQ(found.size(), 8u);
}

}  // namespace
}  // namespace rigor
