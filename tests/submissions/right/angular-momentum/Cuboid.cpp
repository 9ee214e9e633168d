#include "Cuboid.h"

void Cuboid::computeBodyCoordsMOI() {
  V3D squares(width * width, height * height, depth * depth);
  V3D moments = mass / 12.0 * (V3D(squares.sum(), squares.sum(), squares.sum()) - squares);
  bodyCoordsMOI = moments.asDiagonal();
  bodyCoordsInverseMOI = bodyCoordsMOI.inverse();
}

Matrix3x3 Cuboid::computeWorldCoordsMOI() {
  return worldRotation * bodyCoordsMOI * worldRotation.transpose();
}

Matrix3x3 Cuboid::computeWorldCoordsInverseMOI() {
  return worldRotation * bodyCoordsInverseMOI * worldRotation.transpose();
}

void Cuboid::applyForce(P3D worldPosition, V3D force) {
  netForce += force;
  netTorque += worldToLocalCoordinates(worldPosition).cross(force);
}

// The angular momentum is what a torque changes; the spin follows from it and from where the body has turned to.
void Cuboid::update(double delta) {
  V3D p = mass * linearVelocity + delta * netForce;
  V3D L = computeWorldCoordsMOI() * angularVelocity + delta * netTorque;
  worldTranslation += delta * p / mass;
  linearVelocity = p / mass;

  double speed = angularVelocity.norm();
  if (speed > 0) worldRotation = AngleAxisd(speed * delta, angularVelocity / speed) * worldRotation;
  angularVelocity = computeWorldCoordsInverseMOI() * L;

  netForce.zero();
  netTorque.zero();
}
