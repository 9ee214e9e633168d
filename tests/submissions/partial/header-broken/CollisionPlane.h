#pragma once
#include "Cuboid.h"
class CollisionPlane {
  P3D pointOnPlane
  V3D normal;
};
