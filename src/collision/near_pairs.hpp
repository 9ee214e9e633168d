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
/// units     m
/// domain    finite centres, radii and margin ≥ 0. A centre that is not finite gives all pairs.
std::vector<std::pair<std::uint32_t, std::uint32_t>> near_pairs(const std::vector<Vec3<double>>& centres, const std::vector<double>& radii, double margin);

}  // namespace rigor
