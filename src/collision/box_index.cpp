#include <algorithm>
#include <bit>
#include <cmath>
#include <rigor/collision/box_index.hpp>

namespace rigor {
namespace {

constexpr int narrowest = -1000;
constexpr int digits = 50;  // of a cell's number: far more than positions have beside sizes, and exact in double

}  // namespace

BoxIndex::BoxIndex(std::size_t n) : entries_(n), buckets_(std::bit_ceil(2 * n + 1), none) {}

void BoxIndex::put(std::uint32_t i, const AxisBox& box) {
  remove(i);
  Entry& e = entries_[i];
  e.box = box;
  e.level = level_of(box);
  const int down = -levels_[e.level].exponent;
  const auto cell = [&](double x) { return std::int64_t(std::floor(std::ldexp(x, down))); };
  e.cell = {cell(box.low[0]), cell(box.low[1]), cell(box.low[2])};
  link(buckets_[bucket(e.level, e.cell)], i, &Entry::in_bucket);
  link(levels_[e.level].first, i, &Entry::in_level);
  ++levels_[e.level].count;
}

void BoxIndex::remove(std::uint32_t i) {
  Entry& e = entries_[i];
  if (e.level == none) return;
  unlink(buckets_[bucket(e.level, e.cell)], i, &Entry::in_bucket);
  unlink(levels_[e.level].first, i, &Entry::in_level);
  --levels_[e.level].count;
  e.level = none;
}

void BoxIndex::overlapping(const AxisBox& box, std::vector<std::uint32_t>& found) const {
  for (std::uint32_t at = 0; at < levels_.size(); ++at) {
    const Level& level = levels_[at];
    if (level.count == 0) continue;
    Vec3<double> low, high;  // of the cells, in cells
    double cells = 1, farthest = 0;
    for (int k = 0; k < 3; ++k) {
      low[k] = std::floor(std::ldexp(box.low[k], -level.exponent)) - 1;
      high[k] = std::floor(std::ldexp(box.high[k], -level.exponent));
      cells *= high[k] - low[k] + 1;
      farthest = std::max({farthest, std::fabs(low[k]), std::fabs(high[k])});
    }
    if (!(cells <= level.count && farthest < std::ldexp(1, digits + 1))) {
      for (std::uint32_t i = level.first; i != none; i = entries_[i].in_level.next)
        if (overlap(box, entries_[i].box)) found.push_back(i);
      continue;
    }
    Cell c;
    for (c.x = std::int64_t(low[0]); c.x <= std::int64_t(high[0]); ++c.x)
      for (c.y = std::int64_t(low[1]); c.y <= std::int64_t(high[1]); ++c.y)
        for (c.z = std::int64_t(low[2]); c.z <= std::int64_t(high[2]); ++c.z)
          for (std::uint32_t i = buckets_[bucket(at, c)]; i != none; i = entries_[i].in_bucket.next)
            if (entries_[i].level == at && entries_[i].cell == c && overlap(box, entries_[i].box)) found.push_back(i);
  }
}

std::uint32_t BoxIndex::bucket(std::uint32_t level, const Cell& cell) const {
  std::uint64_t h = level;
  for (const std::int64_t x : {cell.x, cell.y, cell.z}) h = (h ^ std::uint64_t(x)) * 0x9e3779b97f4a7c15u, h ^= h >> 29;
  return std::uint32_t(h & (buckets_.size() - 1));
}

std::uint32_t BoxIndex::level_of(const AxisBox& box) {
  double extent = 0, farthest = 0;
  for (int k = 0; k < 3; ++k) {
    extent = std::fmax(extent, box.high[k] - box.low[k]);
    farthest = std::fmax(farthest, std::fabs(box.low[k]));
  }
  int exponent = narrowest;
  if (extent > 0) exponent = std::max(exponent, std::ilogb(extent) + 1);
  if (farthest > 0) exponent = std::max(exponent, std::ilogb(farthest) + 1 - digits);
  const auto known = std::find_if(levels_.begin(), levels_.end(), [&](const Level& l) { return l.exponent == exponent; });
  if (known != levels_.end()) return std::uint32_t(known - levels_.begin());
  levels_.push_back({exponent});
  return std::uint32_t(levels_.size() - 1);
}

void BoxIndex::link(std::uint32_t& first, std::uint32_t i, Link Entry::*chain) {
  entries_[i].*chain = {first, none};
  if (first != none) (entries_[first].*chain).before = i;
  first = i;
}

void BoxIndex::unlink(std::uint32_t& first, std::uint32_t i, Link Entry::*chain) {
  const Link gone = entries_[i].*chain;
  if (gone.before == none) first = gone.next;
  else (entries_[gone.before].*chain).next = gone.next;
  if (gone.next != none) (entries_[gone.next].*chain).before = gone.before;
}

}  // namespace rigor
