#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <rigor/collision/near_pairs.hpp>

namespace rigor {
namespace {

using Pairs = NearPairs::Pairs;

Pairs all_pairs(const std::vector<Vec3<double>>& c, const std::vector<double>& r, double margin) {
  Pairs pairs;
  for (std::uint32_t i = 0; i < c.size(); ++i)
    for (std::uint32_t j = i + 1; j < c.size(); ++j)
      if (norm<double>(Vec3<double>(c[i] - c[j])) <= r[i] + r[j] + margin) pairs.push_back({i, j});
  return pairs;
}

// Against everybody with everybody: clusters, lines, far away, one giant among grains, many in one place.
TEST(NearPairs, AreThoseOfAllPairs) {
  std::mt19937_64 random(7);
  const auto in = [&](double low, double high) { return low + (high - low) * (double(random() >> 11) * 0x1p-53); };
  NearPairs near;  // one for all, so that nothing of one world may be left for the next
  for (int world = 0; world < 400; ++world) {
    const std::size_t n = 1 + random() % 150;
    const double spread = std::exp(in(-2, 6)), margin = world % 3 == 0 ? 0 : in(0, 1);
    // cells are counted to 2^20 each way: beyond, at the border with radii of at most 1, and within
    const auto place = [&] { return world % 5 == 0 ? (random() % 2 == 0 ? 1 : -1) * (random() % 2 == 0 ? 1e9 : 0x1p20 * (2 + margin)) : 0; };
    const Vec3<double> away{place(), place(), place()};
    std::vector<Vec3<double>> c;
    std::vector<double> r;
    for (std::size_t k = 0; k < n; ++k) {
      c.push_back(Vec3<double>(away + Vec3<double>{in(-spread, spread), world % 4 == 0 ? 0 : in(-spread, spread), in(-spread, spread)}));
      r.push_back(k == 0 && world % 7 == 0 ? spread / 2 : k == 1 ? 1 : in(0.1, 1));
    }
    const Pairs found = near.find(c, r, margin), want = all_pairs(c, r, margin);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    EXPECT_TRUE(std::adjacent_find(found.begin(), found.end()) == found.end()) << "none twice";
    EXPECT_TRUE(std::includes(found.begin(), found.end(), want.begin(), want.end())) << "world " << world;
    EXPECT_EQ(found.size(), want.size()) << "world " << world;  // distances here are never within rounding of the border
  }
}

TEST(NearPairs, HoldThoseThatJustTouchAndPointsInOnePlace) {
  std::vector<Vec3<double>> row;
  for (int k = 0; k < 20; ++k) row.push_back(Vec3<double>(2.5 * k, 1, -1));
  EXPECT_EQ(NearPairs{}.find(row, std::vector<double>(20, 1.0), 0.5).size(), 19u) << "neighbours, at their distance exactly";
  EXPECT_EQ(NearPairs{}.find(row, std::vector<double>(20, 1.0), 0.4375).size(), 0u);
  row[7] = row[4];
  EXPECT_EQ(NearPairs{}.find(row, std::vector<double>(20, 0.0), 0), (Pairs{{4, 7}})) << "no size and no margin";
}

TEST(NearPairs, OfWhatIsNotFiniteAreAll) {
  std::vector<Vec3<double>> c(20, Vec3<double>(0, 0, 0));
  for (int k = 0; k < 20; ++k) c[std::size_t(k)][0] = 100 * k;
  c[3][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(NearPairs{}.find(c, std::vector<double>(20, 1.0), 0).size(), 19u) << "NaN is near to everybody";
}

}  // namespace
}  // namespace rigor
