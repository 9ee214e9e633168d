#include "Cuboid.h"
#include "MatrixUtils.h"

void Cuboid::applyForce(P3D worldPosition, V3D force) {
  netForce += force;
  netTorque += (worldPosition - centerOfMass()).cross(force);
}

void Cuboid::update(double delta) {
  const V3D w = angularVelocity;
  lastAcceleration = netForce / mass;
  linearVelocity += lastAcceleration * delta;
  worldTranslation += linearVelocity * delta;
  angularVelocity += computeWorldCoordsInverseMOI() * (netTorque - w.cross(computeWorldCoordsMOI() * w)) * delta;
  worldRotation += MatrixUtils::crossProductMatrix(angularVelocity) * worldRotation * delta;
  MatrixUtils::orthonormalize(worldRotation);
  energies.push_back(0.5 * mass * linearVelocity.squaredNorm());
  if (energies.size() > 100) energies.clear();
  netForce.zero();
  netTorque.zero();
}

void Cuboid::push(const P3D& point, const V3D& impulse) {
  linearVelocity += impulse / mass;
  angularVelocity += computeWorldCoordsInverseMOI() * (point - worldTranslation).cross(impulse);
}

double Cuboid::inverseMassAt(const P3D& point, const V3D& direction) {
  V3D r = point - worldTranslation;
  return 1 / mass + (computeWorldCoordsInverseMOI() * r.cross(direction)).cross(r).dot(direction);
}
