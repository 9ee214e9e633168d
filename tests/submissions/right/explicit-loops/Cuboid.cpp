#include "Cuboid.h"

#include "GUILib/GLUtils.h"
#include "MatrixUtils.h"

Cuboid::Cuboid(double w, double h, double d, double m, P3D worldCenter, Matrix3x3 worldRotation)
    : width(w), height(h), depth(d), worldTranslation(worldCenter), worldRotation(worldRotation), mass(m) {
  boundingR = 0.5 * sqrt(w * w + h * h + d * d);
  computeBodyCoordsMOI();
  generateVertices();
}

void Cuboid::computeBodyCoordsMOI() {
  double extent[3] = {width, height, depth};
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) {
      bodyCoordsMOI(i, j) = 0;
      bodyCoordsInverseMOI(i, j) = 0;
    }
  for (int i = 0; i < 3; i++) {
    double other1 = extent[(i + 1) % 3];
    double other2 = extent[(i + 2) % 3];
    bodyCoordsMOI(i, i) = mass * (other1 * other1 + other2 * other2) / 12;
    bodyCoordsInverseMOI(i, i) = 1.0 / bodyCoordsMOI(i, i);
  }
}

// R * M * R^T, component by component
static Matrix3x3 turned(const Matrix3x3 &R, const Matrix3x3 &M) {
  Matrix3x3 result;
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) {
      double sum = 0;
      for (int k = 0; k < 3; k++)
        for (int l = 0; l < 3; l++) sum += R(i, k) * M(k, l) * R(j, l);
      result(i, j) = sum;
    }
  return result;
}

Matrix3x3 Cuboid::computeWorldCoordsMOI() {
  return turned(worldRotation, bodyCoordsMOI);
}

Matrix3x3 Cuboid::computeWorldCoordsInverseMOI() {
  return turned(worldRotation, bodyCoordsInverseMOI);
}

void Cuboid::applyForce(P3D worldPosition, V3D force) {
  double r[3];
  for (int i = 0; i < 3; i++) {
    netForce[i] += force[i];
    r[i] = worldPosition[i] - worldTranslation[i];
  }
  netTorque[0] += r[1] * force[2] - r[2] * force[1];
  netTorque[1] += r[2] * force[0] - r[0] * force[2];
  netTorque[2] += r[0] * force[1] - r[1] * force[0];
}

void Cuboid::update(double delta) {
  Matrix3x3 I = computeWorldCoordsMOI();
  Matrix3x3 Iinv = computeWorldCoordsInverseMOI();
  double L[3] = {0, 0, 0};
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) L[i] += I(i, j) * angularVelocity[j];
  double w[3] = {angularVelocity[0], angularVelocity[1], angularVelocity[2]};
  double torque[3] = {netTorque[0] - (w[1] * L[2] - w[2] * L[1]),
                      netTorque[1] - (w[2] * L[0] - w[0] * L[2]),
                      netTorque[2] - (w[0] * L[1] - w[1] * L[0])};
  for (int i = 0; i < 3; i++) {
    linearVelocity[i] += netForce[i] / mass * delta;
    worldTranslation[i] += linearVelocity[i] * delta;
    for (int j = 0; j < 3; j++) angularVelocity[i] += Iinv(i, j) * torque[j] * delta;
    netForce[i] = 0;
    netTorque[i] = 0;
  }
  // every column of R is a vector that turns with the body
  for (int column = 0; column < 3; column++) {
    double x = worldRotation(0, column), y = worldRotation(1, column), z = worldRotation(2, column);
    worldRotation(0, column) += delta * (angularVelocity[1] * z - angularVelocity[2] * y);
    worldRotation(1, column) += delta * (angularVelocity[2] * x - angularVelocity[0] * z);
    worldRotation(2, column) += delta * (angularVelocity[0] * y - angularVelocity[1] * x);
  }
  MatrixUtils::orthonormalize(worldRotation);
}

void Cuboid::generateVertices() {
  vector<P3D> bottom, top;
  for (int k = 0; k < 8; ++k) {
    vertices[k] = P3D(k & 1 ? width / 2 : -width / 2, k & 2 ? height / 2 : -height / 2,
                      k & 4 ? depth / 2 : -depth / 2);
    (k & 2 ? top : bottom).push_back(vertices[k]);
  }
  mesh.addPrism(bottom, top);
  mesh.computeNormals();
}

void Cuboid::getTransformedVertices(vector<P3D>& output) {
  output.clear();
  for (int k = 0; k < 8; ++k) output.push_back(worldRotation * vertices[k] + worldTranslation);
}

double Cuboid::boundingRadius() { return boundingR; }

V3D Cuboid::velocityOfPoint(P3D point) {
  return linearVelocity + angularVelocity.cross(point - worldTranslation);
}

V3D Cuboid::currentNetForce() { return netForce; }

P3D Cuboid::centerOfMass() { return worldTranslation; }

void Cuboid::applyLinearImpulse(V3D impulse) { linearVelocity += impulse; }

void Cuboid::applyAngularImpulse(V3D impulse) { angularVelocity += impulse; }

V3D Cuboid::worldToLocalCoordinates(P3D worldPos) { return worldPos - worldTranslation; }

bool Cuboid::checkCollision(Cuboid& other, P3D& collisionPoint, V3D& collisionNormal, double& distance) {
  const double margin = 0.01;
  V3D offset = other.worldTranslation - worldTranslation;
  if (offset.norm() > boundingR + other.boundingR + margin || offset.norm() == 0) return false;

  // Corners of the other in this one's axes. (The offset is not turned with them: approximate.)
  Matrix3x3 otherToThis = worldRotation.transpose() * other.worldRotation;
  V3D half(width / 2 + margin, height / 2 + margin, depth / 2 + margin);
  bool found = false;
  distance = 0;
  for (int k = 0; k < 8; ++k) {
    V3D inside = half - V3D(otherToThis * other.vertices[k] + offset).cwiseAbs();
    double depthHere = inside.minCoeff();
    if (depthHere > distance) {
      found = true;
      distance = depthHere;
      collisionPoint = other.worldRotation * other.vertices[k] + other.worldTranslation;
    }
  }
  if (found) collisionNormal = offset.normalized();
  return found;
}

void Cuboid::setColor(double r, double g, double b) {
  colour = V3D(r, g, b);
  mesh.material.setFloatParam("u_color", r, g, b, 1.0);
}

void Cuboid::setMaterial(GLShaderMaterial* material) { mesh.setMaterial(*material); }

void Cuboid::draw() {
  glPushMatrix();
  glTranslated(worldTranslation[0], worldTranslation[1], worldTranslation[2]);
  Matrix4d transform = Matrix4d::Identity();
  transform.topLeftCorner<3, 3>() = worldRotation;
  glMultMatrixd(transform.data());
  mesh.drawMesh();
  glPopMatrix();
}
