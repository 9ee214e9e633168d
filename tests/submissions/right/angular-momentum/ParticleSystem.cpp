#include "ParticleSystem.h"
#include "Constants.h"

void ParticleSystem::applyCollisionImpulse(Cuboid &c1, Cuboid &c2, P3D &collisionPoint, V3D &collisionNormal) {
  V3D r1 = c1.worldToLocalCoordinates(collisionPoint);
  V3D r2 = c2.worldToLocalCoordinates(collisionPoint);
  V3D vr = c2.velocityOfPoint(collisionPoint) - c1.velocityOfPoint(collisionPoint);
  Matrix3x3 I1inv = c1.computeWorldCoordsInverseMOI();
  Matrix3x3 I2inv = c2.computeWorldCoordsInverseMOI();
  V3D rn1 = I1inv * (r1.cross(collisionNormal));
  V3D rn2 = I2inv * (r2.cross(collisionNormal));
  double denom = 1 / c1.mass + 1 / c2.mass + (rn1.cross(r1) + rn2.cross(r2)).dot(collisionNormal);
  double jr = -(1 + COEFF_RESITUTION) * vr.dot(collisionNormal) / denom;

  c1.applyLinearImpulse(-(jr / c1.mass) * collisionNormal);
  c2.applyLinearImpulse((jr / c2.mass) * collisionNormal);
  c1.applyAngularImpulse(-jr * rn1);
  c2.applyAngularImpulse(jr * rn2);
}
