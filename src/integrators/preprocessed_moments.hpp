#pragma once
#include <rigor/linalg/types.hpp>

namespace rigor {

/// Inverse moments (1/(kg m²), body axes) of the changed body whose step by Moser and Veselov's map is the turn of the body
/// with moments `I_B` (kg m²) to `order` 4 or 8, and to order 2 those of the body itself: (1 + s)/I + d, with s and d series in h² whose coefficients are polynomials in
/// the energy H, C = |L|²/2 and the elementary symmetric functions of the moments. `L_B`: kg m²/s, body axes; h: s.
/// Source: Hairer and Vilmart 2006; every coefficient is held to 50 digits by tests/integrators/moser_veselov_test.cpp.
template <class T>
Vec3<T> preprocessed_inverse_moments(const Vec3<T>& I_B, const Vec3<T>& inverse_I_B, const Vec3<T>& L_B, const T& h, int order) {
  const T e1 = I_B[0] + I_B[1] + I_B[2], e2 = I_B[0] * I_B[1] + I_B[0] * I_B[2] + I_B[1] * I_B[2], e3 = I_B[0] * I_B[1] * I_B[2];
  const T H = dot<T>(L_B, Vec3<T>(L_B.cwiseProduct(inverse_I_B))) / 2, C = dot<T>(L_B, L_B) / 2, h2 = h * h;
  T s = 0, d = 0;
  if (order >= 4) {
    s += h2 * (-e2 * H / 3 + e1 * C / 6) / e3;
    d += h2 * (e1 * H / 6 - C / 3) / e3;
  }
  if (order >= 8) {
    const T k = h2 * h2 / (e3 * e3), l = k * h2 / e3;
    s += k * (H * H * (e2 * e2 / 30 - e1 * e3 / 60) + H * C * (-e1 * e2 / 30 + 2 * e3 / 15) + C * C * (e1 * e1 / 30 - e2 / 10));
    d += k * (H * H * (-e1 * e2 / 60 - e3 / 10) + H * C * (-e1 * e1 / 60 + 2 * e2 / 15) - C * C * e1 / 60);
    s += l * (H * H * H * (-e2 * e2 * e2 / 630 + e1 * e2 * e3 / 630 + e3 * e3 / 35) + H * H * C * (e1 * e2 * e2 / 420 + 41 * e1 * e1 * e3 / 2520 - 53 * e2 * e3 / 630) +
              H * C * C * (-e1 * e1 * e2 / 70 + 11 * e2 * e2 / 210 - e1 * e3 / 84) + C * C * C * (17 * e1 * e1 * e1 / 2520 - 11 * e1 * e2 / 420 + 5 * e3 / 126));
    d += l * (H * H * H * (e1 * e2 * e2 / 1260 - 13 * e1 * e1 * e3 / 1260 + e2 * e3 / 42) + H * H * C * (13 * e1 * e1 * e2 / 2520 - 8 * e2 * e2 / 315 + 11 * e1 * e3 / 252) +
              H * C * C * (e1 * e1 * e1 / 1260 - e1 * e2 / 1260 - 22 * e3 / 315) + C * C * C * (-19 * e1 * e1 / 2520 + e2 / 35));
  }
  return (1 + s) * inverse_I_B + Vec3<T>::Constant(d);
}

}  // namespace rigor
