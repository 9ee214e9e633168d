#pragma once
#include "MathLib/V3D.h"

class MatrixUtils {
 public:
  // [v]x, so that crossProductMatrix(v) * a is v x a.
  static Matrix3x3 crossProductMatrix(V3D v);
  // Gram-Schmidt on the columns, in place; the first column keeps its direction.
  static void orthonormalize(Matrix3x3& mat);
};
