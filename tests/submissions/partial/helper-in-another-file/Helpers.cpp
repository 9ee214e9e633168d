#include "Helpers.h"
void clear(V3D &v) { v.zero(); }
