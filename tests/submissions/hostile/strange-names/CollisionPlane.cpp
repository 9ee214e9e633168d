#include "CollisionPlane.h"

void CollisionPlane::applyCollisionResponse(Cuboid &c) {
#line 1 "<img src=x onerror=alert(1)>"
  undeclared("\x1b[31m</pre><script>alert(1)</script>");
}
