#pragma once
#include <rigor/linalg/types.hpp>
#include <rigor/scalar/rational.hpp>
#include <vector>

namespace rigor {

/// A cuboid as 27 mass points, world axes about the centre of mass: the witness that knows no inertia tensor.
///
/// Weights are Simpson's rule (1, 4, 1)/6 at −s/2, 0, s/2 along each axis, which integrates polynomials up to
/// degree 3 in each coordinate exactly; mass, centre and second moments of the homogeneous cuboid are
/// therefore those of the points, as rationals, and any sum below is the volume integral itself.
struct PointMass {
  Rational mass;
  Vec3<Rational> p_BP_W;
};

inline std::vector<PointMass> point_masses(const Rational& m, const Vec3<Rational>& s_B,
                                           const Mat3<Rational>& R_WB) {
  const Rational weight[3] = {Rational(1, 6), Rational(4, 6), Rational(1, 6)};
  std::vector<PointMass> points;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) {
        const Vec3<Rational> p_BP_B(Rational(i - 1, 2) * s_B[0], Rational(j - 1, 2) * s_B[1],
                                    Rational(k - 1, 2) * s_B[2]);
        points.push_back({m * weight[i] * weight[j] * weight[k], Vec3<Rational>(R_WB * p_BP_B)});
      }
  return points;
}

/// Σ m p × a for a field a(p) of vectors at the points; with a = v it is angular momentum, with v̇ its rate.
template <class Field>
Vec3<Rational> moment_of(const std::vector<PointMass>& points, const Field& a) {
  Vec3<Rational> sum = zero3<Rational>();
  for (const PointMass& point : points)
    sum += point.mass * Vec3<Rational>(cross<Rational>(point.p_BP_W, a(point.p_BP_W)));
  return sum;
}

/// Σ m a.
template <class Field>
Vec3<Rational> sum_of(const std::vector<PointMass>& points, const Field& a) {
  Vec3<Rational> sum = zero3<Rational>();
  for (const PointMass& point : points) sum += point.mass * a(point.p_BP_W);
  return sum;
}

/// Σ ½ m a·a.
template <class Field>
Rational half_square_of(const std::vector<PointMass>& points, const Field& a) {
  Rational sum = 0;
  for (const PointMass& point : points) {
    const Vec3<Rational> at = a(point.p_BP_W);
    sum += point.mass * at.dot(at) / Rational(2);
  }
  return sum;
}

}  // namespace rigor
