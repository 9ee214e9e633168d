#include "CollisionPlane.h"

void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  abort();
}
