#pragma once
// The assignment's room with one cuboid thrown into it, and how the witnesses of impacts take it.
#include <reference/impacts.hpp>
#include <rigor/scene/simulate.hpp>

namespace rigor {

using reference::Thrown;
using P = reference::Precise;

inline Scene room(double e, double mu) {
  Scene s = builtin_scene("assignment", 1);
  s.method = "located";
  s.surface = *Surface<double>::make(e, mu, mu);
  s.friction_law = FrictionLaw::coulomb;
  State<double> start;
  start.p_WB = Vec3<double>(0.5, 2.5, -1);
  start.R_WB = Mat3<double>::Identity();
  start.v_WB = Vec3<double>(12, 3, -15);
  start.w_WB = Vec3<double>(2, -3, 1);
  s.bodies = {{*Cuboid<double>::make(2, {0.5, 0.75, 1.25}), start}};
  s.until = 20;
  s.every = 20;
  return s;
}

/// The scene's first body among its planes.
inline reference::Throw thrown_in(const Scene& scene) {
  const Cuboid<double>& shape = scene.bodies[0].shape;
  reference::Throw made{shape.size(), shape.mass(), scene.gravity, {}, scene.surface.restitution(), scene.surface.dynamic_friction()};
  for (const auto& plane : scene.planes) made.walls.push_back({plane.point(), plane.normal()});
  return made;
}
template <class T>
Thrown<T> thrown(const State<double>& s) {
  return {s.p_WB.cast<T>(), s.v_WB.cast<T>(), s.w_WB.cast<T>(), s.R_WB.cast<T>()};
}

}  // namespace rigor
