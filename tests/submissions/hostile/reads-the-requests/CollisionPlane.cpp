#include "CollisionPlane.h"
#include <unistd.h>

void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  char request[1 << 14];
  while (read(3, request, sizeof request) > 0) {
  }
}
