#include "Cuboid.h"
#include "MatrixUtils.h"

void Cuboid::computeBodyCoordsMOI() {
  const double k = mass / 12.0;
  bodyCoordsMOI << k * (height * height + depth * depth), 0, 0,
                   0, k * (width * width + depth * depth), 0,
                   0, 0, k * (width * width + height * height);
  bodyCoordsInverseMOI = bodyCoordsMOI.inverse();
}

Matrix3x3 Cuboid::computeWorldCoordsMOI() {
  Matrix3x3 R = worldRotation;
  return R * bodyCoordsMOI * R.inverse();
}

Matrix3x3 Cuboid::computeWorldCoordsInverseMOI() {
  Matrix3x3 R = worldRotation;
  return R * bodyCoordsInverseMOI * R.inverse();
}

void Cuboid::applyForce(P3D worldPosition, V3D force) {
  netForce += force;
  V3D r = worldToLocalCoordinates(worldPosition);
  netTorque += r.cross(force);
}

// Explicit Euler: everything moves with the velocities it had at the start of the step.
void Cuboid::update(double delta) {
  V3D linearAcceleration = netForce / mass;
  Matrix3x3 I = computeWorldCoordsMOI();
  V3D gyroscopic = angularVelocity.cross(I * angularVelocity);
  V3D angularAcceleration = computeWorldCoordsInverseMOI() * (netTorque - gyroscopic);

  worldTranslation += linearVelocity * delta;
  Matrix3x3 Rdot = MatrixUtils::crossProductMatrix(angularVelocity) * worldRotation;
  worldRotation = worldRotation + Rdot * delta;
  MatrixUtils::orthonormalize(worldRotation);

  linearVelocity += linearAcceleration * delta;
  angularVelocity += angularAcceleration * delta;
  netForce = V3D();
  netTorque = V3D();
}
