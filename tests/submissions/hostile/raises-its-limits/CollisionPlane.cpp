#include "CollisionPlane.h"
#include <sys/resource.h>

void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  rlimit none = {RLIM_INFINITY, RLIM_INFINITY};
  for (int what = 0; what < RLIM_NLIMITS; ++what)
    if (setrlimit((__rlimit_resource)what, &none) == 0) printf("RAISED %d\n", what);
}
