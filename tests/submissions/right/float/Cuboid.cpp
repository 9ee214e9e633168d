#include "Cuboid.h"
#include "MatrixUtils.h"

// Single precision inside, as on a graphics card.
void Cuboid::computeBodyCoordsMOI() {
  float w = width, h = height, d = depth, m = mass;
  Vector3f I(m * (h * h + d * d) / 12.f, m * (w * w + d * d) / 12.f, m * (w * w + h * h) / 12.f);
  bodyCoordsMOI = I.cast<double>().asDiagonal();
  Vector3f inverse(1.f / I[0], 1.f / I[1], 1.f / I[2]);
  bodyCoordsInverseMOI = inverse.cast<double>().asDiagonal();
}

Matrix3x3 Cuboid::computeWorldCoordsMOI() {
  Matrix3f R = worldRotation.cast<float>();
  Matrix3f I = R * bodyCoordsMOI.cast<float>() * R.transpose();
  return I.cast<double>();
}

Matrix3x3 Cuboid::computeWorldCoordsInverseMOI() {
  Matrix3f R = worldRotation.cast<float>();
  Matrix3f I = R * bodyCoordsInverseMOI.cast<float>() * R.transpose();
  return I.cast<double>();
}

void Cuboid::applyForce(P3D worldPosition, V3D force) {
  Vector3f arm = (worldPosition - worldTranslation).cast<float>();
  Vector3f torque = arm.cross(force.cast<float>());
  netForce += force;
  netTorque += torque.cast<double>();
}

void Cuboid::update(double delta) {
  Vector3f a = netForce.cast<float>() / float(mass);
  linearVelocity += delta * a.cast<double>();
  worldTranslation += delta * linearVelocity;

  Vector3f w = angularVelocity.cast<float>();
  Vector3f L = computeWorldCoordsMOI().cast<float>() * w;
  Vector3f alpha = computeWorldCoordsInverseMOI().cast<float>() * (netTorque.cast<float>() - w.cross(L));
  angularVelocity += delta * alpha.cast<double>();

  worldRotation += delta * MatrixUtils::crossProductMatrix(angularVelocity) * worldRotation;
  MatrixUtils::orthonormalize(worldRotation);
  netForce.zero();
  netTorque.zero();
}
