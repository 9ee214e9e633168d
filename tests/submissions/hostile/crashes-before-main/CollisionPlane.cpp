#include "CollisionPlane.h"

static struct Before {
  Before() {
    *(volatile int*)8 = 1;
  }
} before;
