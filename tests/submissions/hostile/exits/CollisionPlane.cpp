#include "CollisionPlane.h"

void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  exit(0);
}
