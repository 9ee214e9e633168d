#pragma once
#include <rigor/engine/sincospi.hpp>

// One evaluation of an exact flight, for one body or for one lane of a block: the same operations in the same order, so
// the same bits. No Eigen and no standard containers, as in batch_kernel.hpp; formulas in docs/exact-flight.md.
#define RIGOR_INLINE [[gnu::always_inline]] inline

namespace rigor::detail {

/// The constants of a flight: T is double, or double[lanes] for a block of them.
template <class T>
struct FlightNumbers {
  T time_scale;                                        // power of two: evaluator time = time_scale · t
  T n0, nu_hi, nu_lo;                                  // half periods
  T w_hi, w_lo, period_hi, period_lo, u0, omega;       // theta_prime reduction
  T rate_hi, rate_lo, jump_hi, jump_lo;                // precession, in half turns
  T y_scale;
  T sn[4], cn[4], dn[4], denominator[4], arg_x[4], arg_y[4];  // cubics in y
  T rho, cos_tilt, sin_tilt;
  T sign[3];                                           // of the permuted axes
  T L[3];                                              // amplitudes, with sign
  T C[9];                                              // by rows
};

RIGOR_INLINE double lane_of(const double& x, int) { return x; }
RIGOR_INLINE double lane_of(const double* x, int lane) { return x[lane]; }

template <class T>
RIGOR_INLINE double cubic(const T (&p)[4], int lane, double y) {
  return __builtin_fma(__builtin_fma(__builtin_fma(lane_of(p[3], lane), y, lane_of(p[2], lane)), y, lane_of(p[1], lane)), y, lane_of(p[0], lane));
}

/// hi·t + lo·t as a leading part and a correction, exact to the last bit of the sum's 106.
struct Long {
  double lead, rest;
};
RIGOR_INLINE Long times(double hi, double lo, double t) {
  const double lead = hi * t;
  return {lead, __builtin_fma(lo, t, __builtin_fma(hi, t, -lead))};
}

/// exp(x) for |x| ≤ 700 within about 1 ulp, without branches or libm. Taylor series on |r| ≤ ln 2/2 after x = k ln 2 + r;
/// the first term left out is below 1e-17.
RIGOR_INLINE double exp_of(double x) {
  const double k = __builtin_rint(x * 1.4426950408889634);
  const double r = __builtin_fma(k, -2.3190468138462996e-17, __builtin_fma(k, -0.69314718055994529, x));  // ln 2 = hi + lo
  const double z = r * r;  // even and odd terms side by side: half the wait
  double even = 1 / 479001600., odd = 1 / 6227020800.;
  even = __builtin_fma(even, z, 1 / 3628800.), odd = __builtin_fma(odd, z, 1 / 39916800.);
  even = __builtin_fma(even, z, 1 / 40320.), odd = __builtin_fma(odd, z, 1 / 362880.);
  even = __builtin_fma(even, z, 1 / 720.), odd = __builtin_fma(odd, z, 1 / 5040.);
  even = __builtin_fma(even, z, 1 / 24.), odd = __builtin_fma(odd, z, 1 / 120.);
  even = __builtin_fma(even, z, 0.5), odd = __builtin_fma(odd, z, 1 / 6.);
  const double p = __builtin_fma(__builtin_fma(odd, r, even), z, r) + 1;
  const double shifted = k + (6755399441055744. + 1023);  // 1.5 · 2^52: the last bits of the sum are k's exponent
  unsigned long long bits;
  __builtin_memcpy(&bits, &shifted, sizeof bits);
  bits <<= 52;
  double power;
  __builtin_memcpy(&power, &bits, sizeof power);
  return p * power;
}

/// sinh(w) and cosh(w) for |w| ≤ 345 within about 3 ulp. Near 0 the series of sinh, where the difference of the two
/// exponentials would cancel.
RIGOR_INLINE void sinh_cosh(double w, double& sh, double& ch) {
  const double grow = exp_of(w), shrink = 1 / grow, z = w * w;
  const double near_zero = w * (1 + z * (1 / 6. + z * (1 / 120. + z * (1 / 5040. + z * (1 / 362880. + z * (1 / 39916800. + z * (1 / 6227020800.)))))));
  sh = __builtin_fabs(w) < 0.35 ? near_zero : 0.5 * (grow - shrink);
  ch = 0.5 * (grow + shrink);
}

/// sn, cn, dn and the complex θ₁ whose argument is the periodic part of the precession.
struct Elliptic {
  double sn, cn, dn, arg_x, arg_y;
};

template <class T>
RIGOR_INLINE Elliptic theta_series(const FlightNumbers<T>& f, int lane, double half_periods) {
  double s, c;
  sincospi(half_periods, s, c);
  const double y = __builtin_fma(-2 * s, s, 1.0), inverse = 1 / cubic(f.denominator, lane, y);
  return {s * cubic(f.sn, lane, y) * inverse, c * cubic(f.cn, lane, y) * inverse, cubic(f.dn, lane, y) * inverse,
          s * cubic(f.arg_x, lane, y), c * cubic(f.arg_y, lane, y)};
}

template <class T>
RIGOR_INLINE Elliptic theta_prime_series(const FlightNumbers<T>& f, int lane, double t, double j) {
  const Long u = times(lane_of(f.w_hi, lane), lane_of(f.w_lo, lane), t);
  const Long back = times(lane_of(f.period_hi, lane), lane_of(f.period_lo, lane), j);
  const double reach = lane_of(f.omega, lane) * (((u.lead - back.lead) + lane_of(f.u0, lane)) + (u.rest - back.rest));
  // 1/q' ≥ cosh 2w keeps |w| below 346; on the separatrix, which has no period, the motion is over by then (sech w = 1e-150)
  const double w = reach > 345 ? 345 : reach < -345 ? -345 : reach;
  double sh, ch;
  sinh_cosh(w, sh, ch);
  const double y = lane_of(f.y_scale, lane) * __builtin_fma(2 * sh, sh, 1.0), inverse = 1 / (ch * cubic(f.denominator, lane, y));
  return {sh * cubic(f.sn, lane, y) * inverse, cubic(f.cn, lane, y) * inverse, cubic(f.dn, lane, y) * inverse,
          ch * cubic(f.arg_x, lane, y), sh * cubic(f.arg_y, lane, y)};
}

/// Columns of R_WB in the order of the permuted axes, and the components of L_B in that order.
struct FlightColumns {
  double R[3][3], L[3];
};

/// prime: the theta_prime series (m > 1/2) instead of theta.
template <bool prime, class T>
RIGOR_INLINE FlightColumns evaluate_flight(const FlightNumbers<T>& f, int lane, double seconds) {
  const auto n = [lane](const T& x) { return lane_of(x, lane); };
  const double t = n(f.time_scale) * seconds;
  const Long count = times(n(f.nu_hi), n(f.nu_lo), t);
  const double j = __builtin_rint(count.lead + n(f.n0));  // the nearest half period
  const double half = j * 0.5, odd = 2 * (half - __builtin_floor(half)), sign = 1 - 2 * odd;
  Elliptic e;
  if constexpr (prime) e = theta_prime_series(f, lane, t, j);
  else e = theta_series(f, lane, ((count.lead - j) + n(f.n0)) + count.rest);
  e.sn *= sign, e.cn *= sign;

  const Long drift = times(n(f.rate_hi), n(f.rate_lo), t);
  double turned = drift.lead - 2 * __builtin_rint(0.5 * drift.lead), rest = drift.rest;  // in half turns
  if constexpr (prime) {
    const Long jumps = times(n(f.jump_hi), n(f.jump_lo), j);
    turned += jumps.lead - 2 * __builtin_rint(0.5 * jumps.lead);
    rest += jumps.rest;
  } else {
    turned += odd;  // a half turn each
  }
  double sin_linear, cos_linear;
  sincospi(turned + rest, sin_linear, cos_linear);
  const double unit = 1 / __builtin_sqrt(__builtin_fma(e.arg_x, e.arg_x, e.arg_y * e.arg_y));
  const double cos_phi = __builtin_fma(cos_linear, e.arg_x, -(sin_linear * e.arg_y)) * unit;
  const double sin_phi = __builtin_fma(sin_linear, e.arg_x, cos_linear * e.arg_y) * unit;

  const double across = n(f.rho) * e.sn, length = __builtin_sqrt(__builtin_fma(e.cn, e.cn, across * across)), inverse = 1 / length;
  const double ca = e.cn * inverse, sa = across * inverse, ct = n(f.cos_tilt) * e.dn, st = n(f.sin_tilt) * length;
  const double ca0 = n(f.sign[0]) * ca, sa0 = n(f.sign[0]) * sa, ca1 = n(f.sign[1]) * ca, sa1 = n(f.sign[1]) * sa;
  const double ct2 = n(f.sign[2]) * ct, st2 = n(f.sign[2]) * st, tilt0 = ca0 * ct, tilt1 = sa1 * ct;
  const double F[3][3] = {{__builtin_fma(cos_phi, tilt0, sin_phi * sa0), __builtin_fma(sin_phi, tilt0, -(cos_phi * sa0)), st * ca0},
                          {__builtin_fma(cos_phi, tilt1, -(sin_phi * ca1)), __builtin_fma(sin_phi, tilt1, cos_phi * ca1), st * sa1},
                          {-cos_phi * st2, -sin_phi * st2, ct2}};
  FlightColumns out;
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i) out.R[k][i] = __builtin_fma(n(f.C[3 * i]), F[k][0], __builtin_fma(n(f.C[3 * i + 1]), F[k][1], n(f.C[3 * i + 2]) * F[k][2]));
  out.L[0] = n(f.L[0]) * e.cn;
  out.L[1] = n(f.L[1]) * e.sn;
  out.L[2] = n(f.L[2]) * e.dn;
  return out;
}

}  // namespace rigor::detail

#undef RIGOR_INLINE
