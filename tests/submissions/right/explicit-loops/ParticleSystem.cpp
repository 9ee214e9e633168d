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
  V3D r1, r2, v1, v2;
  for (int i = 0; i < 3; i++) {
    r1[i] = collisionPoint[i] - c1.worldTranslation[i];
    r2[i] = collisionPoint[i] - c2.worldTranslation[i];
  }
  v1 = c1.linearVelocity + c1.angularVelocity.cross(r1);
  v2 = c2.linearVelocity + c2.angularVelocity.cross(r2);
  double vn = 0;
  for (int i = 0; i < 3; i++) vn += (v2[i] - v1[i]) * collisionNormal[i];
  if (vn >= 0) return;  // already parting

  Matrix3x3 I1inv = c1.computeWorldCoordsInverseMOI();
  Matrix3x3 I2inv = c2.computeWorldCoordsInverseMOI();
  V3D a1 = I1inv * r1.cross(collisionNormal);
  V3D a2 = I2inv * r2.cross(collisionNormal);
  double denominator = 1.0 / c1.mass + 1.0 / c2.mass;
  V3D b1 = a1.cross(r1), b2 = a2.cross(r2);
  for (int i = 0; i < 3; i++) denominator += (b1[i] + b2[i]) * collisionNormal[i];
  double j = -(1 + COEFF_RESITUTION) * vn / denominator;
  for (int i = 0; i < 3; i++) {
    c1.linearVelocity[i] -= j / c1.mass * collisionNormal[i];
    c2.linearVelocity[i] += j / c2.mass * collisionNormal[i];
    c1.angularVelocity[i] -= j * a1[i];
    c2.angularVelocity[i] += j * a2[i];
  }
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
