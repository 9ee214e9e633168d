#include "ParticleSystem.h"
#include "Constants.h"

void ParticleSystem::applyCollisionImpulse(Cuboid &c1, Cuboid &c2, P3D &collisionPoint, V3D &collisionNormal) {
  Vector3f n = collisionNormal.cast<float>();
  Vector3f r1 = (collisionPoint - c1.worldTranslation).cast<float>();
  Vector3f r2 = (collisionPoint - c2.worldTranslation).cast<float>();
  Vector3f v1 = c1.velocityOfPoint(collisionPoint).cast<float>();
  Vector3f v2 = c2.velocityOfPoint(collisionPoint).cast<float>();
  float vn = (v2 - v1).dot(n);
  if (vn >= 0.f) return;
  Vector3f a1 = c1.computeWorldCoordsInverseMOI().cast<float>() * r1.cross(n);
  Vector3f a2 = c2.computeWorldCoordsInverseMOI().cast<float>() * r2.cross(n);
  float m1 = c1.mass, m2 = c2.mass, e = COEFF_RESITUTION;
  float j = -(1.f + e) * vn / (1.f / m1 + 1.f / m2 + (a1.cross(r1) + a2.cross(r2)).dot(n));
  c1.linearVelocity -= (n * (j / m1)).cast<double>();
  c2.linearVelocity += (n * (j / m2)).cast<double>();
  c1.angularVelocity -= (a1 * j).cast<double>();
  c2.angularVelocity += (a2 * j).cast<double>();
}
