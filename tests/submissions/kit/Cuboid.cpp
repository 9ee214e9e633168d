#include "Cuboid.h"

#include "GUILib/GLUtils.h"
#include "MatrixUtils.h"

Cuboid::Cuboid(double w, double h, double d, double m, P3D worldCenter, Matrix3x3 worldRotation)
    : width(w), height(h), depth(d), worldTranslation(worldCenter), worldRotation(worldRotation), mass(m) {
  boundingR = 0.5 * sqrt(w * w + h * h + d * d);
  computeBodyCoordsMOI();
  generateVertices();
}

// Fill in both bodyCoordsMOI and bodyCoordsInverseMOI.
void Cuboid::computeBodyCoordsMOI() {
  // TODO: the moment of inertia tensor of a cuboid in body coordinates.
  bodyCoordsMOI.setIdentity();
  bodyCoordsInverseMOI = bodyCoordsMOI.inverse();
}

Matrix3x3 Cuboid::computeWorldCoordsMOI() {
  // TODO: the moment of inertia tensor in world coordinates.
  return Matrix3x3::Identity();
}

Matrix3x3 Cuboid::computeWorldCoordsInverseMOI() {
  // TODO: its inverse.
  return Matrix3x3::Identity();
}

void Cuboid::applyForce(P3D worldPosition, V3D force) {
  // TODO: add to netForce and netTorque.
}

void Cuboid::update(double delta) {
  // TODO: integrate position and orientation forward in time, then clear the accumulators.
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
