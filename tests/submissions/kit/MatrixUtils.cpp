#include "MatrixUtils.h"

Matrix3x3 MatrixUtils::crossProductMatrix(V3D v) {
  Matrix3x3 result;
  result << 0, -v[2], v[1],
            v[2], 0, -v[0],
            -v[1], v[0], 0;
  return result;
}

void MatrixUtils::orthonormalize(Matrix3x3& mat) {
  V3D x = mat.col(0), y = mat.col(1), z = mat.col(2);
  x.normalize();
  y = y - x.dot(y) * x;
  y.normalize();
  z = z - x.dot(z) * x - y.dot(z) * y;
  z.normalize();
  mat.col(0) = x;
  mat.col(1) = y;
  mat.col(2) = z;
}
