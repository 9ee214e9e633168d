// The cuboid, the attitude and the three spins (cases A, B, C of free flight) on which the closed form is measured.
#pragma once

#include <rigor/linalg/rotation.hpp>

namespace rigor {

inline const Vec3<double> moments(13 / 12., 10 / 12., 5 / 12.);  // cuboid 1 x 2 x 3 m, 1 kg
inline const Mat3<double> generic = rotation_of<double>(Vec4<double>(1, 2, -1, 3));
inline const Vec3<double> spins[3] = {{0.3, 2, 0.2}, {5, 0.01, 0.01}, {1e-6, 2, 1e-6}};

}  // namespace rigor
