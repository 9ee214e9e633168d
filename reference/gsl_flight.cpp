#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_ellint.h>
#include <gsl/gsl_sf_elljac.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <reference/gsl_flight.hpp>

namespace rigor::reference {
namespace {

constexpr double pi_half = 1.57079632679489661923;

// F(φ|k) and Π(φ, n|k) with GSL's sign of n (1 + n sin²), over any number of half periods.
struct Elliptic {
  double k, n, K = 0, Pi = 0;
  bool ok = true;

  double take(int (*f)(double, double, gsl_mode_t, gsl_sf_result*), double a, double b) {
    gsl_sf_result r{};
    ok = f(a, b, GSL_PREC_DOUBLE, &r) == GSL_SUCCESS && ok;
    return r.val;
  }
  double third(double phi) {
    gsl_sf_result r{};
    ok = gsl_sf_ellint_P_e(phi, k, n, GSL_PREC_DOUBLE, &r) == GSL_SUCCESS && ok;
    return r.val;
  }
};

}  // namespace

Outcome<Attitude<double>> gsl_free_body(const FreeBody& body, double t) {
  static const bool silent = (gsl_set_error_handler_off(), true);
  (void)silent;
  std::array<int, 3> order{0, 1, 2};
  const Vec3<double>&I = body.I_B, &w = body.w_B;
  std::sort(order.begin(), order.end(), [&](int a, int b) { return I[a] < I[b]; });
  const int lo = order[0], mid = order[1], hi = order[2];
  const double D = I[hi] * (I[hi] - I[mid]) * w[hi] * w[hi] - I[lo] * (I[mid] - I[lo]) * w[lo] * w[lo];
  const std::array<int, 3> axis = D >= 0 ? std::array<int, 3>{lo, mid, hi} : std::array<int, 3>{hi, mid, lo};
  std::array<double, 3> sign{w[axis[0]] < 0 ? -1.0 : 1.0, 1, w[axis[2]] < 0 ? -1.0 : 1.0};
  sign[1] = sign[0] * sign[2] * (axis[1] == (axis[0] + 1) % 3 ? 1 : -1);
  const double I1 = I[axis[0]], I2 = I[axis[1]], I3 = I[axis[2]];
  const double w1 = sign[0] * w[axis[0]], w2 = sign[1] * w[axis[1]], w3 = sign[2] * w[axis[2]];
  const double G = std::sqrt(I1 * I1 * w1 * w1 + I2 * I2 * w2 * w2 + I3 * I3 * w3 * w3);
  const double d12 = std::fabs(I1 - I2), d13 = std::fabs(I1 - I3), d23 = std::fabs(I2 - I3);
  const double P3 = I1 * d13 * w1 * w1 + I2 * d23 * w2 * w2, P1 = I2 * d12 * w2 * w2 + I3 * d13 * w3 * w3;
  const double m = P3 * d12 / (P1 * d23);
  if (!(d12 > 0) || !(d23 > 0) || !(P3 > 0) || !(m < 1))
    return Fault{Fault::Kind::unsupported, "free flight by GSL", "does not cover this degenerate motion"};
  const double L1 = std::sqrt(I1 * P3 / d13), L2 = std::sqrt(I2 * P3 / d23), L3 = std::sqrt(I3 * P1 / d13);
  const double rate = (I3 > I1 ? 1 : -1) * std::sqrt(P1 * d23 / (I1 * I2 * I3));

  Elliptic e{std::sqrt(m), I2 * d13 / (I1 * d23) - 1};
  e.K = [&] {
    gsl_sf_result r{};
    e.ok = gsl_sf_ellint_Kcomp_e(e.k, GSL_PREC_DOUBLE, &r) == GSL_SUCCESS;
    return r.val;
  }();
  e.Pi = e.third(pi_half);
  const double phi0 = std::atan2(I2 * w2 / L2, I1 * w1 / L1);
  const double u0 = e.take(gsl_sf_ellint_F_e, phi0, e.k), third0 = e.third(phi0);
  const double u = u0 + rate * t, half = std::rint(u / (2 * e.K));
  double sn, cn, dn;
  e.ok = gsl_sf_elljac_e(u, m, &sn, &cn, &dn) == GSL_SUCCESS && e.ok;
  const double flip = std::fmod(std::fabs(half), 2.0) == 1 ? -1 : 1;
  const double third = 2 * half * e.Pi + e.third(std::atan2(flip * sn, flip * cn));
  if (!e.ok) return Fault{Fault::Kind::unsupported, "free flight by GSL", "a library call refused its argument"};
  const double psi = G / I3 * t + G * (1 / I1 - 1 / I3) / rate * (third - third0);

  // the frame with third row along L: columns are the sorted body axes
  const auto frame = [&](double s, double c, double d) {
    const double across = std::sqrt(I2 * d13 / (I1 * d23)) * s, length = std::hypot(c, across);
    const double ca = c / length, sa = across / length, ct = L3 * d / G, st = L1 * length / G;
    Mat3<double> F;
    F << ca * ct, sa * ct, -st, -sa, ca, 0, st * ca, st * sa, ct;
    return F;
  };
  const Mat3<double> F0 = frame(I2 * w2 / L2, I1 * w1 / L1, I3 * w3 / L3), F = frame(sn, cn, dn);
  Mat3<double> turn;
  turn << std::cos(psi), -std::sin(psi), 0, std::sin(psi), std::cos(psi), 0, 0, 0, 1;
  const Mat3<double> sorted = F0.transpose() * (turn * F);  // in sorted axes, from t = 0
  Mat3<double> P = zero33<double>();                        // sorted = P body
  for (int k = 0; k < 3; ++k) P(k, axis[k]) = sign[k];
  Attitude<double> end;
  end.R_WB = body.R_WB * (P.transpose() * sorted * P);
  end.w_B[axis[0]] = sign[0] * L1 * cn / I1;
  end.w_B[axis[1]] = sign[1] * L2 * sn / I2;
  end.w_B[axis[2]] = sign[2] * L3 * dn / I3;
  return end;
}

}  // namespace rigor::reference
