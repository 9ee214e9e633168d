#include "CollisionPlane.h"

extern double restitution asm("COEFF_RESITUTION");
extern double friction asm("COEFF_STATIC_FRICTION");

void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  restitution = -1;
  friction = 0;
}
