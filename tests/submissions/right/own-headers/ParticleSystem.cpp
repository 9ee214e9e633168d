#include "ParticleSystem.h"
#include "Constants.h"

void ParticleSystem::applyCollisionImpulse(Cuboid& c1, Cuboid& c2, P3D& collisionPoint, V3D& collisionNormal) {
  V3D relative = c2.velocityOfPoint(collisionPoint) - c1.velocityOfPoint(collisionPoint);
  double approach = relative.dot(collisionNormal);
  if (approach >= 0) return;
  double k = c1.inverseMassAt(collisionPoint, collisionNormal) + c2.inverseMassAt(collisionPoint, collisionNormal);
  V3D impulse = -(1 + COEFF_RESITUTION) * approach / k * collisionNormal;
  c1.push(collisionPoint, -impulse);
  c2.push(collisionPoint, impulse);
}
