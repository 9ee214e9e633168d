#pragma once
#include <array>
#include <rigor/bodies/cuboid.hpp>
#include <rigor/formulas/state.hpp>

namespace rigor {

/// One point of a contact patch, half way between the two surfaces.
struct ContactPoint {
  Vec3<double> p_WC;
  double depth;  ///< m, > 0: how far the surfaces overlap here along the normal
};

/// Where two cuboids touch: one normal, up to eight points. Empty when they do not overlap.
struct Manifold {
  Vec3<double> n_AB_W = zero3<double>();  ///< unit, from A to B
  double depth = 0;                       ///< smallest overlap over the 15 axes: the shift that separates them
  int axis = -1;                          ///< 0-2 faces of A, 3-5 faces of B, 6 + 3i + j edges i of A and j of B
  int count = 0;
  std::array<ContactPoint, 8> points;

  bool touches() const { return count > 0; }
  /// Mean of the points: the contact point of the assignment's pair impulse.
  Vec3<double> centroid() const;
};

/// Largest signed gap over the 15 axes of the separating-axis theorem: > 0 means apart by at least that much.
struct Separation {
  double gap;
  Vec3<double> n_AB_W;  ///< the axis it is measured along, from A to B
  int axis;
};

/// Separating axes of two cuboids: three face normals each and the nine cross products of edges.
///
/// An edge pair within an angle s of parallel gives a cross product with relative error u/s; its gap is lowered by
/// that error times the extents, so noise can neither part two cuboids nor win the search (below s = 1e-8 the pair is
/// left out: a face axis then agrees with it to 1e-8 of the extents). Faces win over edges unless an edge pair is
/// better by more than 1e-9 of the extents. Ties go to the lower axis number; with coincident centres the normal is
/// the positive axis.
///
/// units     m
/// frames    world axes
/// rounding  gap within 40 u of the sum of extents and distance, outside which its sign is right
Separation separation(const Cuboid<double>& A, const State<double>& a, const Cuboid<double>& B, const State<double>& b);

/// The contact patch of two overlapping cuboids: the incident face clipped by the reference face, or the nearest
/// points of two edges. Touching exactly (gap 0) is no contact.
Manifold box_box(const Cuboid<double>& A, const State<double>& a, const Cuboid<double>& B, const State<double>& b);

}  // namespace rigor
