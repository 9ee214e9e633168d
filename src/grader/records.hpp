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

/// The record that crosses to the worker, without loads.
inline BodyRecord record(const Vec3<double>& size, double mass, const State<double>& s, const Vec3<double>& I_B, const Vec3<double>& inverse_I_B) {
  BodyRecord r{};
  put(r.size, size);
  r.mass = mass;
  put(r.position, s.p_WB);
  put(r.rotation, s.R_WB);
  put(r.velocity, s.v_WB);
  put(r.spin, s.w_WB);
  put(r.body_inertia, Mat3<double>(I_B.asDiagonal()));
  put(r.body_inverse_inertia, Mat3<double>(inverse_I_B.asDiagonal()));
  return r;
}
inline State<double> state(const BodyRecord& b) { return {vec(b.position), mat(b.rotation), vec(b.velocity), vec(b.spin)}; }

}  // namespace rigor::grader
