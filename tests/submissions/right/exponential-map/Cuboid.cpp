#include "Cuboid.h"

void Cuboid::computeBodyCoordsMOI() {
  double w2 = width * width, h2 = height * height, d2 = depth * depth;
  bodyCoordsMOI.setZero();
  bodyCoordsMOI.diagonal() << h2 + d2, w2 + d2, w2 + h2;
  bodyCoordsMOI *= mass / 12;
  bodyCoordsInverseMOI = bodyCoordsMOI.diagonal().cwiseInverse().asDiagonal();
}

Matrix3x3 Cuboid::computeWorldCoordsMOI() { return worldRotation * bodyCoordsMOI * worldRotation.transpose(); }

Matrix3x3 Cuboid::computeWorldCoordsInverseMOI() { return computeWorldCoordsMOI().inverse(); }

void Cuboid::applyForce(P3D worldPosition, V3D force) {
  V3D arm = worldPosition - worldTranslation;
  netForce = netForce + force;
  netTorque = netTorque + arm.cross(force);
}

// The orientation turns by the angle |w| dt about w (Rodrigues), so it stays a rotation by itself.
void Cuboid::update(double delta) {
  V3D acceleration = netForce / mass;
  linearVelocity = linearVelocity + acceleration * delta;
  worldTranslation = worldTranslation + linearVelocity * delta;

  // Euler's equation with body components, where the tensor is diagonal
  V3D wB = worldRotation.transpose() * angularVelocity;
  V3D tauB = worldRotation.transpose() * netTorque;
  V3D alphaB = bodyCoordsInverseMOI * (tauB - wB.cross(bodyCoordsMOI * wB));
  angularVelocity += delta * (worldRotation * alphaB);

  double angle = angularVelocity.norm() * delta;
  if (angle > 0) {
    Matrix3x3 turn = Eigen::AngleAxisd(angle, angularVelocity.normalized()).toRotationMatrix();
    worldRotation = turn * worldRotation;
  }
  netForce = V3D(0, 0, 0);
  netTorque = V3D(0, 0, 0);
}
