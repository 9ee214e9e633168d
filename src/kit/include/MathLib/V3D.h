#pragma once
#include <Eigen/Dense>
#include <cmath>

typedef Eigen::Matrix<double, 3, 3> Matrix3x3;

// A vector in space. Any Eigen 3-vector expression becomes one without being asked: V3D y = M * v, V3D z = -v / 2.
class V3D : public Eigen::Vector3d {
 public:
  V3D() : Eigen::Vector3d(0, 0, 0) {}
  V3D(double x, double y, double z) : Eigen::Vector3d(x, y, z) {}
  template <class Expression>
  V3D(const Eigen::MatrixBase<Expression>& e) : Eigen::Vector3d(e) {}
  template <class Expression>
  V3D& operator=(const Eigen::MatrixBase<Expression>& e) {
    Eigen::Vector3d::operator=(e);
    return *this;
  }

  void zero() { setZero(); }  // in place, like normalize(); normalized() returns
};

#include "MathLib/P3D.h"
