#pragma once
#include <rigor/linalg/types.hpp>

namespace rigor::reference {

/// A torque-free rigid body at t = 0.
struct FreeBody {
  Vec3<double> I_B;   ///< principal moments, kg·m²
  Vec3<double> w_B;   ///< spin in body axes, rad/s
  Mat3<double> R_WB;  ///< body to world
};

/// Its attitude and spin at a time, in scalar T.
template <class T>
struct Attitude {
  Mat3<T> R_WB;
  Vec3<T> w_B;
};

}  // namespace rigor::reference
