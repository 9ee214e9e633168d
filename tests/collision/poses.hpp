#pragma once
#include <rigor/bodies/cuboid.hpp>
#include <rigor/formulas/state.hpp>
#include <vector>

namespace rigor {

struct Body {
  Cuboid<double> shape;
  State<double> pose;
};
inline Body body(const Vec3<double>& size, const Vec3<double>& at = zero3<double>(), const Mat3<double>& R = identity3<double>()) {
  State<double> pose;
  pose.p_WB = at;
  pose.R_WB = R;
  return {*Cuboid<double>::make(1, size), pose};
}
/// The 24 rotations that bring the axes to the axes.
inline std::vector<Mat3<double>> cube_rotations() {
  std::vector<Mat3<double>> all;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (const double si : {1., -1.})
        for (const double sj : {1., -1.}) {
          if (i == j) continue;
          Vec3<double> x = zero3<double>(), y = zero3<double>();
          x[i] = si, y[j] = sj;
          const Vec3<double> z = cross<double>(x, y);
          Mat3<double> R;
          for (int k = 0; k < 3; ++k) R(k, 0) = x[k], R(k, 1) = y[k], R(k, 2) = z[k];
          all.push_back(R);
        }
  return all;
}
}  // namespace rigor
