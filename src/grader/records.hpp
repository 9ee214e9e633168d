#pragma once
#include <rigor/formulas/state.hpp>
#include <rigor/grader/protocol.hpp>

namespace rigor::grader {

inline Vec3<double> vec(const double* a) { return Vec3<double>(a[0], a[1], a[2]); }
inline Mat3<double> mat(const double* a) {
  Mat3<double> M;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) M(i, j) = a[3 * i + j];
  return M;
}
inline void put(double* a, const Vec3<double>& v) {
  for (int i = 0; i < 3; ++i) a[i] = v[i];
}
inline void put(double* a, const Mat3<double>& M) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) a[3 * i + j] = M(i, j);
}

inline State<double> state(const BodyRecord& b) { return {vec(b.position), mat(b.rotation), vec(b.velocity), vec(b.spin)}; }

}  // namespace rigor::grader
