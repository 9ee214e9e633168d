#pragma once
#include <cmath>
#include <optional>
#include <rigor/bodies/cuboid.hpp>
#include <rigor/formulas/state.hpp>

namespace rigor {

/// What the assignment's handed-out pair detection reports.
struct HandedOutContact {
  Vec3<double> p_WC;
  Vec3<double> n_AB_W;  ///< along the line of centres
  double depth;         ///< m
};

/// The assignment's own approximate detection, kept as a named variant (`"pair_detection": "handed-out"`).
///
/// The corners of one cuboid are tested inside the other grown by 0.01 m; the first one found counts, corners of B
/// before corners of A. Its change of frame takes the corner's offset from its own centre into the other's axes but
/// adds the offset between the centres without turning it, so it is wrong as soon as the other cuboid is turned.
/// The depth is to the nearest face of the grown cuboid.
///
/// units     m
/// frames    world axes; the mistake is in the frames
inline std::optional<HandedOutContact> handed_out_pair(const Cuboid<double>& A, const State<double>& a, const Cuboid<double>& B,
                                                       const State<double>& b) {
  const auto corner_inside = [](const Cuboid<double>& in, const State<double>& in_pose, const Cuboid<double>& of,
                                const State<double>& of_pose) -> std::optional<std::pair<Vec3<double>, double>> {
    for (int k = 0; k < 8; ++k) {
      const Vec3<double> arm = apply<double>(of_pose.R_WB, of.corner(k));
      const Vec3<double> local = apply_transposed<double>(in_pose.R_WB, arm) + (of_pose.p_WB - in_pose.p_WB);  // not turned
      double depth = 1e300;
      for (int i = 0; i < 3; ++i) depth = std::fmin(depth, in.size()[i] / 2 + 0.01 - std::fabs(local[i]));
      if (depth > 0) return std::pair{Vec3<double>(of_pose.p_WB + arm), depth};
    }
    return std::nullopt;
  };
  auto found = corner_inside(A, a, B, b);
  if (!found) found = corner_inside(B, b, A, a);
  const Vec3<double> line = b.p_WB - a.p_WB;
  if (!found || !(norm<double>(line) > 0)) return std::nullopt;
  return HandedOutContact{found->first, Vec3<double>(line / norm<double>(line)), found->second};
}

}  // namespace rigor
