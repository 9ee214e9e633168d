#include "ParticleSystem.h"

#include <cstdlib>

#include "Constants.h"
#include "GUILib/GLUtils.h"
#include "Utils/Logger.h"

bool ParticleSystem::drawParticles = true;
bool ParticleSystem::enableGravity = true;

static double uniform(double low, double high) { return low + (high - low) * (rand() / (double)RAND_MAX); }

static V3D randomDirectionUp() {
  V3D d;
  do d = V3D(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
  while (d.norm() > 1 || d.norm() < 1e-3);
  d.normalize();
  d[1] = fabs(d[1]);
  return d;
}

ParticleSystem::ParticleSystem(GLShaderMaterial* material) : applyingRandomForces(false) {
  for (int i = 0; i < 10; ++i) {
    double w = uniform(0.5, 2.5), h = uniform(0.5, 2.5), d = uniform(0.5, 2.5), m = uniform(2, 3);
    V3D direction = randomDirectionUp();
    P3D center = uniform(2, 10) * direction;
    Cuboid* cube = new Cuboid(w, h, d, m, center, Matrix3x3::Identity());
    cube->setMaterial(material);
    cube->setColor(uniform(0, 1), uniform(0, 1), uniform(0, 1));
    cubes.push_back(cube);
  }
  planes.push_back(CollisionPlane(P3D(0, 0, 0), V3D(0, 1, 0)));
  planes.push_back(CollisionPlane(P3D(0, 5, 0), V3D(0, -1, 0)));
  planes.push_back(CollisionPlane(P3D(-10, 0, 0), V3D(1, 0, 0)));
  planes.push_back(CollisionPlane(P3D(10, 0, 0), V3D(-1, 0, 0)));
  planes.push_back(CollisionPlane(P3D(0, 0, -10), V3D(0, 0, 1)));
  planes.push_back(CollisionPlane(P3D(0, 0, 10), V3D(0, 0, -1)));
}

ParticleSystem::~ParticleSystem() {
  for (Cuboid* cube : cubes) delete cube;
}

void ParticleSystem::applyCollisionImpulse(Cuboid& c1, Cuboid& c2, P3D& collisionPoint, V3D& collisionNormal) {
  // TODO: the normal collision response of two cuboids.
}

void ParticleSystem::applyForces(double delta) {
  for (unsigned i = 0; i < cubes.size(); ++i) {
    Cuboid& c = *cubes[i];
    if (enableGravity) c.applyForce(c.centerOfMass(), V3D(0, -9.8, 0) * c.mass);
    if (applyingRandomForces) c.applyForce(c.centerOfMass() + randomOffsets[i], randomForces[i]);
  }
}

void ParticleSystem::handleCubeCollisions() {
  for (unsigned i = 0; i < cubes.size(); ++i)
    for (unsigned j = i + 1; j < cubes.size(); ++j) {
      P3D point;
      V3D normal;
      double distance;
      if (!cubes[i]->checkCollision(*cubes[j], point, normal, distance)) continue;
      cubes[i]->worldTranslation -= normal * (distance / 2);
      cubes[j]->worldTranslation += normal * (distance / 2);
      applyCollisionImpulse(*cubes[i], *cubes[j], point, normal);
    }
}

void ParticleSystem::integrate_PBF(double delta) {
  applyForces(delta);
  for (Cuboid* cube : cubes)
    for (CollisionPlane& plane : planes) plane.applyCollisionResponse(*cube);
  handleCubeCollisions();
  for (Cuboid* cube : cubes) cube->update(delta);
}

void ParticleSystem::startVacuumForces() {
  applyingRandomForces = true;
  randomForces.clear();
  randomOffsets.clear();
  P3D average;
  for (Cuboid* cube : cubes) average += cube->worldTranslation / cubes.size();
  for (Cuboid* cube : cubes) {
    V3D force = V3D(average - cube->worldTranslation).normalized() * 10 * cube->mass;
    force[1] = 10 * cube->mass;
    randomForces.push_back(force);
    randomOffsets.push_back(0.1 * randomDirectionUp());
  }
}

void ParticleSystem::stopVacuumForces() { applyingRandomForces = false; }

void ParticleSystem::drawParticleSystem() {
  if (!drawParticles) return;
  for (Cuboid* cube : cubes) cube->draw();
}
