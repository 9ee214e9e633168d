#include "CollisionPlane.h"
#include <signal.h>

void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  signal(SIGSEGV, [](int) {});
  *(volatile int*)8 = 1;
}
