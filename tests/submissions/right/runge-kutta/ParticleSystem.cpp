#include "ParticleSystem.h"
#include "Constants.h"

// With the matrix K that takes an impulse to the change of relative velocity at the contact.
static Matrix3x3 impulseToVelocity(Cuboid &c, const V3D &r) {
  Matrix3x3 cross;
  cross << 0, -r[2], r[1], r[2], 0, -r[0], -r[1], r[0], 0;
  return Matrix3x3::Identity() / c.mass - cross * c.computeWorldCoordsInverseMOI() * cross;
}

void ParticleSystem::applyCollisionImpulse(Cuboid &c1, Cuboid &c2, P3D &collisionPoint, V3D &collisionNormal) {
  V3D r1 = collisionPoint - c1.worldTranslation, r2 = collisionPoint - c2.worldTranslation;
  Matrix3x3 K = impulseToVelocity(c1, r1) + impulseToVelocity(c2, r2);
  V3D v = c2.velocityOfPoint(collisionPoint) - c1.velocityOfPoint(collisionPoint);
  double vn = v.dot(collisionNormal);
  if (vn > 0) return;
  V3D impulse = -(1 + COEFF_RESITUTION) * vn / collisionNormal.dot(K * collisionNormal) * collisionNormal;
  c1.linearVelocity -= impulse / c1.mass;
  c2.linearVelocity += impulse / c2.mass;
  c1.angularVelocity -= c1.computeWorldCoordsInverseMOI() * r1.cross(impulse);
  c2.angularVelocity += c2.computeWorldCoordsInverseMOI() * r2.cross(impulse);
}
