#include "CollisionPlane.h"

static double deeper(double x) {
  volatile double here[64];
  here[0] = x;
  return deeper(here[0] + 1) + here[0];
}

void CollisionPlane::applyCollisionResponse(Cuboid &c) { c.linearVelocity[0] = deeper(c.mass); }
