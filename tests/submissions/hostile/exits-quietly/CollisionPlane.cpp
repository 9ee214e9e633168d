#include "CollisionPlane.h"
#include <unistd.h>

void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  _exit(139);
}
