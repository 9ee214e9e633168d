#include "CollisionPlane.h"

void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  double nan = numeric_limits<double>::quiet_NaN(), inf = numeric_limits<double>::infinity();
  c.linearVelocity = V3D(nan, inf, -inf);
  c.angularVelocity = c.worldTranslation = c.netForce = c.netTorque = c.linearVelocity;
  c.worldRotation.setConstant(nan);
  c.mass = -inf;
}
