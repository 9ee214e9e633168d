#include "CollisionPlane.h"

void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  for (volatile int i = 0;; i = i + 1) {
  }
}
