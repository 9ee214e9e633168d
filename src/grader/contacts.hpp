#pragma once
#include <cmath>
#include <rigor/formulas/apply_pair_impulse.hpp>
#include <rigor/formulas/normal_effective_mass.hpp>
#include <rigor/formulas/normal_impulse.hpp>
#include <rigor/formulas/point_velocity.hpp>
#include <rigor/grader/scenario.hpp>

namespace rigor::grader {

/// Corner k of a box in body axes: bit 0, 1, 2 of k set means +half along x, y, z.
inline Vec3<double> corner_B(const Box& b, int k) {
  return Vec3<double>((k & 1 ? 1 : -1) * b.size[0] / 2, (k & 2 ? 1 : -1) * b.size[1] / 2, (k & 4 ? 1 : -1) * b.size[2] / 2);
}
/// The same as an arm in world axes.
inline Vec3<double> corner_W(const Box& b, int k) { return apply<double>(b.R_WB(), corner_B(b, k)); }

/// How far each corner lies behind the plane (> 0), and the deepest.
struct Depths {
  double each[8];
  double deepest = -1e300, sum = 0;
  int behind = 0, corner = 0;
};
inline Depths depths(const Box& b, const Vec3<double>& plane_point, const Vec3<double>& n) {
  Depths d;
  for (int k = 0; k < 8; ++k) {
    d.each[k] = -dot<double>(Vec3<double>(b.position + corner_W(b, k) - plane_point), n);
    if (d.each[k] > d.deepest) d.deepest = d.each[k], d.corner = k;
    if (d.each[k] > 0) ++d.behind, d.sum += d.each[k];
  }
  return d;
}

/// Puts the box so that corner `k` lies `depth` behind the plane, `along` beside its point.
inline void place(Box& b, int k, double depth, const Vec3<double>& plane_point, const Vec3<double>& n, const Vec3<double>& along) {
  const Vec3<double> in_plane = along - dot<double>(along, n) * n;
  b.position = plane_point + in_plane - corner_W(b, k) - depth * n;
}

/// One corner, and no other within 5 % of the size, behind or near the plane.
inline bool single_corner(const Scenario& s, int k) {
  const Depths d = depths(s.A, s.plane_point, s.normal);
  for (int i = 0; i < 8; ++i)
    if (i != k && d.each[i] > -0.05 * norm<double>(s.A.size)) return false;
  return d.each[k] > 0;
}

/// By cofactors; not finite where there is no inverse.
inline Mat3<double> inverse3(const Mat3<double>& A) {
  const Vec3<double> x = A.col(0), y = A.col(1), z = A.col(2);
  Mat3<double> inverse;
  inverse.row(0) = cross<double>(y, z).transpose();
  inverse.row(1) = cross<double>(z, x).transpose();
  inverse.row(2) = cross<double>(x, y).transpose();
  return inverse / dot<double>(x, cross<double>(y, z));
}

/// Body B of an impact with a plane, or either body of a pair; with the student's own tensor where it is given.
inline ImpactBody<double> impact_body(const Box& b, const Vec3<double>& arm, const double* own_inverse = nullptr) {
  return {1 / b.mass, own_inverse != nullptr ? mat(own_inverse) : b.world_inverse(), arm};
}

}  // namespace rigor::grader
