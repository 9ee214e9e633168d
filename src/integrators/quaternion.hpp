#pragma once
#include <cmath>
#include <rigor/linalg/rotation.hpp>
#include <rigor/scalar/cos_sinc.hpp>

/// The few quaternion operations of the free turns: plain loops without a call to the mathematics library.
namespace rigor {

/// The unit quaternion of a turn by |θ| about θ.
inline Vec4<double> exp_quaternion(const Vec3<double>& theta) {
  const CosSinc half = cos_sinc(dot<double>(theta, theta) / 4);
  const double s = half.sinc / 2;
  return Vec4<double>(half.cos, s * theta[0], s * theta[1], s * theta[2]);
}

inline Vec4<double> product(const Vec4<double>& a, const Vec4<double>& b) {
  return Vec4<double>(a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
                      a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]);
}

/// Rᵀx of a quaternion whose squared length is 2/`two_over_n`.
inline Vec3<double> turned_back(const Vec4<double>& q, const Vec3<double>& x, double two_over_n = 2) {
  const Vec3<double> v(q[1], q[2], q[3]), t = two_over_n * cross<double>(v, x);
  return Vec3<double>(x - q[0] * t + cross<double>(v, t));
}

/// Equal steps, each turning by the quaternion that `turn` gives for the L of its beginning.
template <class Turn>
Vec4<double> turn_by(const Vec3<double>& L_B, long steps, const Turn& turn) {
  Vec3<double> L = L_B;
  Vec4<double> q(1, 0, 0, 0);
  for (long step = 0; step < steps; ++step) {
    const Vec4<double> e = turn(L);
    q = product(q, e);
    L = turned_back(e, L);
  }
  return q;
}

/// Steps between two normalisations of a quaternion whose length does not matter but must not leave the numbers.
inline bool is_time_to_normalise(long step) { return step % 16 == 15; }
inline Vec4<double> normalised(const Vec4<double>& q) { return q / std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]); }

}  // namespace rigor
