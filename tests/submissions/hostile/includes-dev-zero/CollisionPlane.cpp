#include "CollisionPlane.h"
#include "/dev/zero"
#include "/dev/stdin"
#include "/proc/self/environ"
