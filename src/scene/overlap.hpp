#pragma once
#include <rigor/scene/scene.hpp>

namespace rigor {

/// How a scene begins that asks for a push: cuboids inside planes or each other. The first step moves them out at once.
struct Overlap {
  std::size_t cuboids = 0;  ///< how many of them
  double depth = 0;         ///< m, the deepest
};

/// units     m
/// domain    a scene for which check_scene holds
/// rounding  overlaps up to 1e-9 of the cuboid's diagonal are none: that is contact, written in decimals
Overlap overlap_at_start(const Scene& scene);

}  // namespace rigor
