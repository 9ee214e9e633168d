#include "CollisionPlane.h"
#include <unistd.h>

void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  for (;;) sleep(3600);
}
