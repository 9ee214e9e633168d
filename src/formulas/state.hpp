#pragma once
#include <rigor/linalg/types.hpp>

namespace rigor {

/// Where a body is and how it moves, world axes, SI units, spin in rad/s.
template <Field T>
struct State {
  Vec3<T> p_WB = zero3<T>();
  Mat3<T> R_WB = identity3<T>();
  Vec3<T> v_WB = zero3<T>();
  Vec3<T> w_WB = zero3<T>();
};

/// What an impact changes.
template <Field T>
struct Velocity {
  Vec3<T> v_WB = zero3<T>();
  Vec3<T> w_WB = zero3<T>();
};

}  // namespace rigor
