#pragma once
#include <cstdint>
#include <rigor/linalg/types.hpp>
#include <utility>
#include <vector>

namespace rigor {

/// Which of many spheres come within `margin` of touching: every pair i < j with |c_i − c_j| ≤ r_i + r_j + margin, and
/// some that do not; in lexicographic order, the same on every machine. By a grid of cells as wide as the largest reach:
/// work in proportion to the spheres and the pairs found, as long as radii are of one size.
///
/// Keeps its memory, so that finding again allocates nothing.
///
/// units     m
/// domain    finite centres, radii and margin ≥ 0. A centre that is not finite gives all pairs.
class NearPairs {
 public:
  using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

  const Pairs& find(const std::vector<Vec3<double>>& centres, const std::vector<double>& radii, double margin);
  /// What was found last.
  const Pairs& found() const { return pairs_; }

 private:
  Pairs pairs_;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> cells_;
};

}  // namespace rigor
