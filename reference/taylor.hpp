#pragma once
#include <reference/free_body.hpp>
#include <reference/precise.hpp>

namespace rigor::reference {

/// Free rotation by its Taylor series: Euler's equations with a quaternion are quadratic, so the coefficients follow
/// from Cauchy products. Shares nothing with the closed forms.
///
/// `order` terms a step, steps no longer than `step` s (choose |ω| step ≤ 1/20 for 50 digits at order 40). The
/// quaternion is not normalised on the way: its length is a check.
/// errors    about (|ω| step)^order a step; at the defaults below 1e-50 on the catalogue's problems
template <class T>
Attitude<T> taylor_free_body(const Vec3<T>& I_B, const Vec3<T>& w_B, const Mat3<T>& R_WB, const T& t, int order = 40, double step = 0.02);

/// The same for a body given in double, taken exactly.
template <class T>
Attitude<T> taylor_free_body(const FreeBody& body, const T& t, int order = 40, double step = 0.02) {
  return taylor_free_body<T>(Vec3<T>(body.I_B.cast<T>()), Vec3<T>(body.w_B.cast<T>()), Mat3<T>(body.R_WB.cast<T>()), t, order, step);
}

extern template Attitude<Precise> taylor_free_body<Precise>(const Vec3<Precise>&, const Vec3<Precise>&, const Mat3<Precise>&, const Precise&, int, double);
extern template Attitude<long double> taylor_free_body<long double>(const Vec3<long double>&, const Vec3<long double>&, const Mat3<long double>&, const long double&, int, double);
extern template Attitude<double> taylor_free_body<double>(const Vec3<double>&, const Vec3<double>&, const Mat3<double>&, const double&, int, double);

}  // namespace rigor::reference
