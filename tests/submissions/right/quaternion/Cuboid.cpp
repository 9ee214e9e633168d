#include "Cuboid.h"

// All products of inertia vanish, so only the diagonal is ever filled.
void Cuboid::computeBodyCoordsMOI() {
  bodyCoordsMOI = Matrix3x3::Zero();
  bodyCoordsInverseMOI = Matrix3x3::Zero();
  bodyCoordsMOI(0, 0) = 1.0 / 12.0 * mass * (pow(height, 2) + pow(depth, 2));
  bodyCoordsMOI(1, 1) = 1.0 / 12.0 * mass * (pow(width, 2) + pow(depth, 2));
  bodyCoordsMOI(2, 2) = 1.0 / 12.0 * mass * (pow(width, 2) + pow(height, 2));
  for (int i = 0; i < 3; ++i) bodyCoordsInverseMOI(i, i) = 1.0 / bodyCoordsMOI(i, i);
}

Matrix3x3 Cuboid::computeWorldCoordsMOI() {
  Quaterniond q(worldRotation);
  return q * bodyCoordsMOI * q.conjugate();
}

Matrix3x3 Cuboid::computeWorldCoordsInverseMOI() {
  Quaterniond q(worldRotation);
  return q * bodyCoordsInverseMOI * q.conjugate();
}

void Cuboid::applyForce(P3D worldPosition, V3D force) {
  netForce += force;
  netTorque -= force.cross(worldPosition - worldTranslation);
}

// dq/dt = 1/2 (0, w) q, then the quaternion is normalised: no matrix is ever anything but a rotation.
void Cuboid::update(double delta) {
  linearVelocity += netForce * (delta / mass);
  worldTranslation += linearVelocity * delta;

  Quaterniond q(worldRotation);
  V3D w = q.conjugate() * angularVelocity;
  V3D torque = q.conjugate() * netTorque;
  V3D change;
  for (int i = 0; i < 3; ++i) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    change[i] = (torque[i] - (bodyCoordsMOI(k, k) - bodyCoordsMOI(j, j)) * w[j] * w[k]) / bodyCoordsMOI(i, i);
  }
  angularVelocity += delta * (q * change);

  Quaterniond spin(0, angularVelocity[0], angularVelocity[1], angularVelocity[2]);
  Quaterniond rate = spin * q;
  q.coeffs() += 0.5 * delta * rate.coeffs();
  q.normalize();
  worldRotation = q.toRotationMatrix();

  netForce = netTorque = V3D(0, 0, 0);
}
