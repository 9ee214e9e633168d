#include "CollisionPlane.h"

char much[8ull << 30] = {1};

void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  c.linearVelocity[0] = much[c.mass > 1];
}
