#pragma once
#include <array>
#include <rigor/bodies/cuboid.hpp>
#include <rigor/bodies/plane.hpp>
#include <rigor/formulas/state.hpp>

namespace rigor {

/// The eight corners of a cuboid against a plane. Corner k as Cuboid::corner: bit 0, 1, 2 of k set means +half edge
/// along body x, y, z.
template <Field T>
struct BoxPlane {
  std::array<Vec3<T>, 8> p_BC_W;  ///< arms: corner − centre of mass, world axes
  std::array<T, 8> gap;           ///< signed distance, < 0 behind the plane
  int behind = 0;                 ///< how many corners lie strictly behind it
  int deepest = 0;                ///< the corner with the least gap, the first of equals

  bool touches() const { return behind > 0; }
  T depth() const { return -gap[deepest]; }  ///< > 0 when it touches
};

/// shapes    Cuboid, State (only the pose counts), Plane → BoxPlane
/// units     m
/// frames    world axes
/// rounding  each gap within γ₈ of the absolute sum of its terms
template <Field T>
BoxPlane<T> box_plane(const Cuboid<T>& box, const State<T>& s, const Plane<T>& plane) {
  BoxPlane<T> contact;
  for (int k = 0; k < 8; ++k) {
    contact.p_BC_W[k] = apply<T>(s.R_WB, box.corner(k));
    const Vec3<T>& arm = contact.p_BC_W[k];
    contact.gap[k] = plane.gap(Vec3<T>(s.p_WB[0] + arm[0], s.p_WB[1] + arm[1], s.p_WB[2] + arm[2]));
    if (contact.gap[k] < T(0)) ++contact.behind;
    if (contact.gap[k] < contact.gap[contact.deepest]) contact.deepest = k;
  }
  return contact;
}

}  // namespace rigor
