#include "ParticleSystem.h"

#include "Constants.h"

void ParticleSystem::applyCollisionImpulse(Cuboid &c1, Cuboid &c2, P3D &collisionPoint, V3D &collisionNormal) {
  V3D n = collisionNormal;
  V3D r1 = collisionPoint - c1.centerOfMass();
  V3D r2 = collisionPoint - c2.centerOfMass();
  double approach = (c2.velocityOfPoint(collisionPoint) - c1.velocityOfPoint(collisionPoint)).dot(n);
  if (approach >= 0) return;

  V3D turn1 = c1.computeWorldCoordsInverseMOI() * r1.cross(n);
  V3D turn2 = c2.computeWorldCoordsInverseMOI() * r2.cross(n);
  double j = -(1 + COEFF_RESITUTION) * approach /
             (1 / c1.mass + 1 / c2.mass + (turn1.cross(r1) + turn2.cross(r2)).dot(n));
  c1.applyLinearImpulse(-j / c1.mass * n);
  c2.applyLinearImpulse(j / c2.mass * n);
  c1.applyAngularImpulse(-j * turn1);
  c2.applyAngularImpulse(j * turn2);
}
