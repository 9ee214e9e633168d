#include "Cuboid.h"
#include "MatrixUtils.h"

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

static void orthonormalizeRows(Matrix3x3 &R) {
  V3D x = R.row(0), y = R.row(1);
  x.normalize();
  y = y - x.dot(y) * x;
  y.normalize();
  V3D z = x.cross(y);
  R.row(0) = x;
  R.row(1) = y;
  R.row(2) = z;
}

// The orientation turns with the spin the step began with.
void Cuboid::update(double delta) {
  Matrix3x3 Rdot;
  for (int column = 0; column < 3; ++column) Rdot.col(column) = angularVelocity.cross(worldRotation.col(column));
  V3D alpha = computeWorldCoordsInverseMOI() *
              (netTorque - angularVelocity.cross(computeWorldCoordsMOI() * angularVelocity));
  worldRotation += Rdot * delta;
  orthonormalizeRows(worldRotation);
  angularVelocity += alpha * delta;
  linearVelocity += netForce / mass * delta;
  worldTranslation += linearVelocity * delta;
  netForce.setZero();
  netTorque.setZero();
}
