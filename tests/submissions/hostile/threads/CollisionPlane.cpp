#include "CollisionPlane.h"
#include <unistd.h>
#include <thread>

void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  std::thread other([] { write(4, "forged", 6); });
  other.detach();
}
