#pragma once
#include <vector>

#include "GUILib/GLMesh.h"
#include "MathLib/P3D.h"
#include "MathLib/V3D.h"

using namespace std;
using namespace Eigen;

// A rigid body: a homogeneous rectangular block. World axes and SI units unless a name says otherwise.
class Cuboid {
 private:
  double width, height, depth;  // full extents along the body's x, y, z
  double boundingR;             // radius of the sphere through its corners
  Matrix3x3 bodyCoordsMOI, bodyCoordsInverseMOI;
  P3D vertices[8];  // in body coordinates
  V3D colour;
  GLMesh mesh;

  V3D lastAcceleration;  // of the last update, for a look in the debugger
  vector<double> energies;

  void computeBodyCoordsMOI() {
    Vector3d s(width, height, depth);
    bodyCoordsMOI = mass / 12 * (s.squaredNorm() * Matrix3x3::Identity() - Matrix3x3(s.cwiseAbs2().asDiagonal()));
    bodyCoordsInverseMOI = bodyCoordsMOI.inverse();
  }
  void generateVertices();

 public:
  V3D netForce, netTorque;    // what applyForce has gathered since the last update
  V3D worldTranslation;       // of the centre of mass
  Matrix3x3 worldRotation;    // body to world
  V3D linearVelocity, angularVelocity;
  double mass;

  Cuboid(double w, double h, double d, double m, P3D worldCenter, Matrix3x3 worldRotation);

  // A force that acts at a point given in world coordinates.
  void applyForce(P3D worldPosition, V3D force);
  Matrix3x3 computeWorldCoordsMOI() { return toWorld(bodyCoordsMOI); }
  Matrix3x3 computeWorldCoordsInverseMOI() { return toWorld(bodyCoordsInverseMOI); }
  // One step of delta seconds; clears the accumulators.
  void update(double delta);

  void getTransformedVertices(vector<P3D>& output);
  double boundingRadius();
  // Of the material point of this body that is at `point` now.
  V3D velocityOfPoint(P3D point);
  V3D currentNetForce();
  P3D centerOfMass();
  // Changes of velocity and angular velocity, added as they stand.
  void applyLinearImpulse(V3D impulse);
  void applyAngularImpulse(V3D impulse);
  // The offset of a point from the centre of mass.
  V3D worldToLocalCoordinates(P3D worldPos);
  // Approximate: corners of one inside the other. The normal points from this one to the other.
  bool checkCollision(Cuboid& other, P3D& collisionPoint, V3D& collisionNormal, double& distance);

  // A tensor of the body in world axes.
  Matrix3x3 toWorld(const Matrix3x3& tensor) const { return worldRotation * tensor * worldRotation.transpose(); }
  // An impulse in N s at a point, unlike the two above.
  void push(const P3D& point, const V3D& impulse);
  double inverseMassAt(const P3D& point, const V3D& direction);

  void setColor(double r, double g, double b);
  void setMaterial(GLShaderMaterial* material);
  void draw();
};
