#pragma once
// The room benchmark's scene for other engines, which bring their own vector types.
#include <array>
#include <memory>
#include <vector>

namespace rigor::bench {

struct PeerRoom {
  std::vector<std::pair<std::array<double, 3>, double>> planes;  ///< normal n and offset: n·x = offset on the plane
  std::array<double, 3> gravity, size, p, v, w;                  ///< the cuboid starts with its axes along the world's
  double mass, restitution, friction, until;
  long steps;
};

/// Where the cuboid is at the end.
std::array<double, 3> bullet_room(const PeerRoom& room);

}  // namespace rigor::bench
