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
  return R * bodyCoordsMOI * R.transpose();
}

Matrix3x3 Cuboid::computeWorldCoordsInverseMOI() {
  Matrix3x3 R = worldRotation;
  return R * bodyCoordsInverseMOI * R.transpose();
}

void Cuboid::applyForce(P3D worldPosition, V3D force) {
  netForce += force;
  V3D r = worldToLocalCoordinates(worldPosition);
  netTorque += r.cross(force);
}

// Fourth order: the force and the torque are constant over the step, the rest is Euler's equation.
void Cuboid::update(double delta) {
  V3D a = netForce / mass;
  worldTranslation += linearVelocity * delta + a * delta * delta / 2;
  linearVelocity += a * delta;

  auto spinRate = [this](const Matrix3x3 &R, const V3D &w) -> V3D {
    V3D wB = R.transpose() * w;
    return R * (bodyCoordsInverseMOI * (R.transpose() * netTorque - wB.cross(bodyCoordsMOI * wB)));
  };
  auto turnRate = [](const Matrix3x3 &R, const V3D &w) -> Matrix3x3 { return MatrixUtils::crossProductMatrix(w) * R; };
  Matrix3x3 R1 = worldRotation;
  V3D w1 = angularVelocity;
  Matrix3x3 kR1 = turnRate(R1, w1);
  V3D kw1 = spinRate(R1, w1);
  Matrix3x3 R2 = R1 + delta / 2 * kR1;
  V3D w2 = w1 + delta / 2 * kw1;
  Matrix3x3 kR2 = turnRate(R2, w2);
  V3D kw2 = spinRate(R2, w2);
  Matrix3x3 R3 = R1 + delta / 2 * kR2;
  V3D w3 = w1 + delta / 2 * kw2;
  Matrix3x3 kR3 = turnRate(R3, w3);
  V3D kw3 = spinRate(R3, w3);
  Matrix3x3 R4 = R1 + delta * kR3;
  V3D w4 = w1 + delta * kw3;
  Matrix3x3 kR4 = turnRate(R4, w4);
  V3D kw4 = spinRate(R4, w4);
  worldRotation = R1 + delta / 6 * (kR1 + 2 * kR2 + 2 * kR3 + kR4);
  MatrixUtils::orthonormalize(worldRotation);
  angularVelocity = w1 + delta / 6 * (kw1 + 2 * kw2 + 2 * kw3 + kw4);

  netForce.zero();
  netTorque.zero();
}
