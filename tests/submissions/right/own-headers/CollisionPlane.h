#pragma once
#include "Cuboid.h"
#include "MathLib/P3D.h"
#include "MathLib/V3D.h"

using namespace std;
using namespace Eigen;

// An immovable half space.
class CollisionPlane {
 private:
  P3D pointOnPlane;
  V3D normal;  // unit, points to the free side

 public:
  CollisionPlane(P3D p, V3D n);

  // Strictly behind the plane?
  bool isColliding(P3D p);
  double depthOf(const P3D& p) const { return normal.dot(pointOnPlane - p); }
  // Direction in which friction acts at p: a unit vector, or zero when there is none.
  V3D frictionTangent(Cuboid& c, P3D& p);
  void applyCollisionResponse(Cuboid& c);
  void bounce(Cuboid& c, P3D p);
};
