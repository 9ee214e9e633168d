#include "CollisionPlane.h"

static struct Before {
  Before() {
    for (volatile int i = 0;; i = i + 1) {
    }
  }
} before;
