#pragma once
#include "MathLib/V3D.h"
void clear(V3D &v);
