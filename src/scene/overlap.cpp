#include <algorithm>
#include <cmath>
#include <rigor/collision/box_box.hpp>
#include <rigor/collision/box_plane.hpp>
#include <rigor/collision/near_pairs.hpp>
#include <rigor/scene/overlap.hpp>

namespace rigor {

Overlap overlap_at_start(const Scene& scene) {
  const std::vector<SceneBody>& bodies = scene.bodies;
  std::vector<Vec3<double>> centres;
  std::vector<double> reach;
  for (const SceneBody& b : bodies) centres.push_back(b.start.p_WB), reach.push_back(norm<double>(b.shape.size()) / 2);
  std::vector<char> inside(bodies.size(), false);
  Overlap all;
  const auto found = [&](std::size_t i, double depth) {
    if (!(depth > 2e-9 * reach[i])) return;
    inside[i] = true;
    all.depth = std::fmax(all.depth, depth);
  };
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (const Plane<double>& plane : scene.planes) found(i, box_plane<double>(bodies[i].shape, bodies[i].start, plane).depth());
  NearPairs near;
  for (const auto& [i, j] : near.find(centres, reach, 0)) {
    const double depth = box_box(bodies[i].shape, bodies[i].start, bodies[j].shape, bodies[j].start).depth;
    found(i, depth), found(j, depth);
  }
  all.cuboids = std::size_t(std::count(inside.begin(), inside.end(), true));
  return all;
}

}  // namespace rigor
