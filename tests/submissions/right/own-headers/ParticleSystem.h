#pragma once
#include <vector>

#include "CollisionPlane.h"
#include "Cuboid.h"
#include "GUILib/GLMesh.h"

using namespace std;
using namespace Eigen;

class ParticleSystem {
 private:
  vector<Cuboid*> cubes;
  vector<CollisionPlane> planes;
  vector<V3D> randomForces, randomOffsets;

 public:
  bool applyingRandomForces;
  static bool drawParticles, enableGravity;

  ParticleSystem(GLShaderMaterial* material);
  ~ParticleSystem();

  // Two cuboids in collision; the normal points from c1 to c2.
  void applyCollisionImpulse(Cuboid& c1, Cuboid& c2, P3D& collisionPoint, V3D& collisionNormal);

  void applyForces(double delta);
  void handleCubeCollisions();
  void integrate_PBF(double delta);
  void startVacuumForces();
  void stopVacuumForces();
  void drawParticleSystem();
};
