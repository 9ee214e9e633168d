#include "CollisionPlane.h"

void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  vector<char> all(10000000000ull, 1);
  c.mass = all[5];
}
