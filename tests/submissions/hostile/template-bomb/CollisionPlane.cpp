#include "CollisionPlane.h"

template <int depth, int path>
struct Tree {
  static const long value = Tree<depth - 1, 2 * path>::value + Tree<depth - 1, 2 * path + 1>::value;
};
template <int path>
struct Tree<0, path> {
  static const long value = path;
};

void CollisionPlane::applyCollisionResponse(Cuboid &c) { c.linearVelocity[0] = Tree<28, 1>::value; }
