#pragma once
#include <cstdint>
#include <rigor/linalg/types.hpp>
#include <vector>

namespace rigor {

/// A box along the world's axes, m; low ≤ high.
struct AxisBox {
  Vec3<double> low, high;
};
inline bool overlap(const AxisBox& a, const AxisBox& b) {
  for (int k = 0; k < 3; ++k)
    if (!(a.low[k] <= b.high[k] && b.low[k] <= a.high[k])) return false;
  return true;
}

inline bool holds(const AxisBox& outer, const AxisBox& inner) {
  for (int k = 0; k < 3; ++k)
    if (!(outer.low[k] <= inner.low[k] && inner.high[k] <= outer.high[k])) return false;
  return true;
}

/// Boxes that come, change and go one at a time, and which of them a given one overlaps.
///
/// A box lies in the cell of its low corner, on the level whose cells are the smallest power of two it fits into. Who
/// overlaps [low, high] has its low corner in [low − cell, high]: on each level in use those cells are looked up, or, where
/// there are more cells than boxes, the boxes of the level. Work in proportion to the levels in use and the boxes nearby,
/// whatever the sizes. No allocation but for a level not seen before.
///
/// domain    finite boxes
class BoxIndex {
 public:
  /// Room for boxes 0 to n − 1.
  explicit BoxIndex(std::size_t n);

  /// Puts box i, in place of the one it had.
  void put(std::uint32_t i, const AxisBox& box);
  void remove(std::uint32_t i);
  bool has(std::uint32_t i) const { return entries_[i].level != none; }
  /// Box i as it was put; precondition: it is there.
  const AxisBox& box(std::uint32_t i) const { return entries_[i].box; }

  /// Appends every i whose box overlaps `box`, in no order.
  void overlapping(const AxisBox& box, std::vector<std::uint32_t>& found) const;

 private:
  static constexpr std::uint32_t none = 0xffffffff;
  struct Link {
    std::uint32_t next = none, before = none;
  };
  struct Cell {
    std::int64_t x, y, z;
    bool operator==(const Cell&) const = default;
  };
  struct Entry {
    AxisBox box;
    Cell cell{};
    std::uint32_t level = none;  // index into levels_; none: it is not there
    Link in_bucket, in_level;
  };
  struct Level {
    int exponent;  // cells are 2^exponent m wide
    std::uint32_t count = 0, first = none;
  };
  std::uint32_t bucket(std::uint32_t level, const Cell& cell) const;
  std::uint32_t level_of(const AxisBox& box);
  void link(std::uint32_t& first, std::uint32_t i, Link Entry::*chain);
  void unlink(std::uint32_t& first, std::uint32_t i, Link Entry::*chain);

  std::vector<Entry> entries_;
  std::vector<std::uint32_t> buckets_;
  std::vector<Level> levels_;
};

}  // namespace rigor
