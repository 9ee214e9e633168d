#include <algorithm>
#include <cmath>
#include <rigor/collision/near_pairs.hpp>

namespace rigor {
namespace {

constexpr std::int64_t middle = 1 << 20;  // of the 21 bits of a cell's number along an axis
// cells; beyond it they are counted as the last one, which parts no neighbours. A neighbour's number fits into the bits, too.
constexpr double farthest = middle - 2;

std::uint64_t key(std::int64_t x, std::int64_t y, std::int64_t z) { return std::uint64_t(x + middle) << 42 | std::uint64_t(y + middle) << 21 | std::uint64_t(z + middle); }

}  // namespace

const NearPairs::Pairs& NearPairs::find(const std::vector<Vec3<double>>& centres, const std::vector<double>& radii, double margin) {
  const std::size_t n = centres.size();
  pairs_.clear();
  const auto offer = [&](std::uint32_t i, std::uint32_t j) {
    const Vec3<double> d = centres[i] - centres[j];
    const double reach = radii[i] + radii[j] + margin;
    if (!(dot<double>(d, d) > reach * reach)) pairs_.push_back(std::minmax(i, j));
  };
  double largest = 0;
  for (const double r : radii) largest = std::fmax(largest, r);
  const double cell = 2 * largest + margin;
  if (n < 16 || !(cell > 0) || !std::all_of(centres.begin(), centres.end(), [](const Vec3<double>& c) { return c.allFinite(); })) {
    for (std::uint32_t i = 0; i < n; ++i)
      for (std::uint32_t j = i + 1; j < n; ++j) offer(i, j);
    return pairs_;
  }

  const auto place = [&](double x) { return std::int64_t(std::clamp(std::floor(x / cell), -farthest, farthest)); };
  auto& cells = cells_;
  cells.resize(n);
  for (std::uint32_t i = 0; i < n; ++i) cells[i] = {key(place(centres[i][0]), place(centres[i][1]), place(centres[i][2])), i};
  std::sort(cells.begin(), cells.end());
  for (std::size_t at = 0; at < n; ++at) {
    const auto [here, i] = cells[at];
    for (std::size_t next = at + 1; next < n && cells[next].first <= here + 1; ++next) offer(i, cells[next].second);  // own cell and the one above
    // half of the other rows of three cells; the rest is found from the other side
    for (const std::int64_t row : {std::int64_t(1) << 21, (std::int64_t(1) << 42) - (std::int64_t(1) << 21), std::int64_t(1) << 42, (std::int64_t(1) << 42) + (std::int64_t(1) << 21)}) {
      const std::uint64_t low = here + std::uint64_t(row) - 1;
      for (auto it = std::lower_bound(cells.begin(), cells.end(), std::pair{low, std::uint32_t(0)}); it != cells.end() && it->first <= low + 2; ++it) offer(i, it->second);
    }
  }
  std::sort(pairs_.begin(), pairs_.end());
  return pairs_;
}

}  // namespace rigor
