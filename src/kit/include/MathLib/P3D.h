#pragma once
#include "MathLib/V3D.h"

// A point in space. The difference of two is a vector, a point and a vector make a point; from and to V3D freely.
class P3D : public Eigen::Vector3d {
 public:
  P3D() : Eigen::Vector3d(0, 0, 0) {}
  P3D(double x, double y, double z) : Eigen::Vector3d(x, y, z) {}
  template <class Expression>
  P3D(const Eigen::MatrixBase<Expression>& e) : Eigen::Vector3d(e) {}
  template <class Expression>
  P3D& operator=(const Eigen::MatrixBase<Expression>& e) {
    Eigen::Vector3d::operator=(e);
    return *this;
  }

  void zero() { setZero(); }
};
