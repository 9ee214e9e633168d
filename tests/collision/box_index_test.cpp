#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <rigor/collision/box_index.hpp>

namespace rigor {
namespace {

// Against everybody with everybody, while boxes come, move and go: grains and giants, needles, points, far away.
TEST(BoxIndex, FindsThoseThatOverlap) {
  std::mt19937_64 random(11);
  const auto in = [&](double low, double high) { return low + (high - low) * (double(random() >> 11) * 0x1p-53); };
  std::size_t met = 0;
  for (int world = 0; world < 100; ++world) {
    const std::uint32_t n = 1 + std::uint32_t(random() % 200);
    const double spread = std::exp(in(-30, 30)), away = world % 5 == 0 ? 1e9 * spread : 0, sizes = in(0, 12);
    const auto draw = [&] {
      AxisBox box;
      const double size = spread / 10 * std::exp(-in(0, sizes));
      for (int k = 0; k < 3; ++k) {
        box.low[k] = away + in(-spread, spread);
        box.high[k] = box.low[k] + (world % 4 == k ? 0 : size);
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

}  // namespace
}  // namespace rigor
