#include "CollisionPlane.h"

#include "Constants.h"

CollisionPlane::CollisionPlane(P3D p, V3D n) : pointOnPlane(p), normal(n.normalized()) {}

bool CollisionPlane::isColliding(P3D p) { return (p - pointOnPlane).dot(normal) < 0; }

V3D CollisionPlane::frictionTangent(Cuboid& c, P3D& p) {
  // TODO: the tangential direction of the velocity at p, else of the net force, else zero.
  return V3D(0, 0, 0);
}

void CollisionPlane::applyCollisionResponse(Cuboid& c) {
  // TODO: if the cuboid is colliding, push it out of the plane, then apply the normal and the frictional response.
}
