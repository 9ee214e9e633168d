#include "CollisionPlane.h"
#include <fenv.h>

void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  fesetround(FE_UPWARD);
  feenableexcept(FE_INEXACT);
}
