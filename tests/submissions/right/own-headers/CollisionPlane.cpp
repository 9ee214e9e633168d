#include "CollisionPlane.h"
#include "Constants.h"

V3D CollisionPlane::frictionTangent(Cuboid& c, P3D& p) {
  for (V3D along : {c.velocityOfPoint(p), c.currentNetForce()}) {
    V3D tangent = along - along.dot(normal) * normal;
    if (tangent.norm() > 1e-8) return tangent / tangent.norm();
  }
  return V3D(0, 0, 0);
}

void CollisionPlane::applyCollisionResponse(Cuboid& c) {
  vector<P3D> corners;
  c.getTransformedVertices(corners);
  double deepest = 0;
  for (const P3D& p : corners)
    if (isColliding(p)) {
      deepest = max(deepest, depthOf(p));
      bounce(c, p);
    }
  c.worldTranslation += deepest * normal;
}

void CollisionPlane::bounce(Cuboid& c, P3D p) {
  double vn = c.velocityOfPoint(p).dot(normal);
  if (vn >= 0) return;
  double jr = -(1 + COEFF_RESITUTION) * vn / c.inverseMassAt(p, normal);
  c.push(p, jr * normal);

  V3D t = frictionTangent(c, p);
  if (t.isZero()) return;
  double stop = c.velocityOfPoint(p).dot(t) / c.inverseMassAt(p, t);
  double limit = COEFF_STATIC_FRICTION * jr;
  c.push(p, -(stop < limit ? stop : COEFF_DYNAMIC_FRICTION * jr) * t);
}
