#include <cmath>
#include <rigor/engine/exact_flight.hpp>
#include <rigor/engine/flight_constants.hpp>
#include <rigor/engine/sincospi.hpp>

namespace rigor {
namespace {

using Tuned = ExactFlight::Tuned;
using Cubic = std::array<double, 4>;

template <class T>
void split(const T& x, double& hi, double& lo) {
  hi = double(x);
  lo = double(x - T(hi));
}

// Σ eₙ·(harmonic 2n+1)/(harmonic 1) as a cubic in y = scale·X, X = cos 2v or cosh 2w:
// sine-like ratios 1, 2X+1, 4X²+2X−1, 8X³+4X²−4X−1; cosine-like 1, 2X−1, 4X²−2X−1, 8X³−4X²−4X+1.
template <class T>
Cubic odd_cubic(const std::array<T, 4>& e, bool sine_like, const T& scale, const T& factor) {
  const T g = sine_like ? T(1) : T(-1), i = T(1) / scale;
  return {double(factor * (e[0] + g * e[1] - e[2] - g * e[3])),
          double(factor * ((T(2) * e[1] + T(2) * g * e[2] - T(4) * e[3]) * i)),
          double(factor * (((T(4) * e[2] + T(4) * g * e[3]) * i) * i)),
          double(factor * (((T(8) * e[3] * i) * i) * i))};
}

// θ₃ (s = 1) or θ₄ (s = −1) = 1 + 2s q X + 2q⁴(2X² − 1) + 2s q⁹(4X³ − 3X)
template <class T>
Cubic even_cubic(const T& q, const T& s, const T& scale, const T& factor) {
  const T i = T(1) / scale, q4 = q * q * q * q, q9 = q4 * q4 * q;
  return {double(factor * (T(1) - T(2) * q4)), double(factor * ((T(2) * s * q - T(6) * s * q9) * i)),
          double(factor * ((T(4) * q4 * i) * i)), double(factor * (((T(8) * s * q9 * i) * i) * i))};
}

// The four-term theta series (q ≤ e^−π, so the fifth term is below 1e−27) folded into six cubics.
template <class T>
void fold_series(const FlightConstants<T>& c, Tuned& f) {
  using std::cos, std::cosh, std::sin, std::sinh;
  const bool prime = c.kind == FlightConstants<T>::Kind::theta_prime;
  const T q = c.q, q2 = q * q, q6 = q2 * q2 * q2, q12 = q6 * q6;
  const T scale = !prime ? T(1) : q > T(1e-300) ? q : T(1e-300);  // cosh 2w ≤ 1/q': y stays ≤ 1
  f.y_scale = double(scale);
  const std::array<T, 4> alternating{T(1), -q2, q6, -q12}, plain{T(1), q2, q6, q12};
  std::array<T, 4> along{T(0), T(0), T(0), T(0)}, across = along;
  for (int n = 0; n < 4; ++n) {
    const T a = T(2 * n + 1), power = alternating[n];
    if (prime) {
      along[n] = power * sin(a * c.beta);
      across[n] = power * cos(a * c.beta);
    } else if (c.symmetric || q == T(0)) {
      along[n] = n == 0 ? T(1) : T(0);
      across[n] = n == 0 ? (c.symmetric ? T(1) : T(sinh(c.beta) / cosh(c.beta))) : T(0);
    } else {
      along[n] = power * cosh(a * c.beta) / cosh(c.beta);
      across[n] = power * sinh(a * c.beta) / cosh(c.beta);
    }
  }
  const T z2 = T(1) + q2 + q6 + q12, q4 = q2 * q2, q9 = q4 * q4 * q;
  const T z3 = T(1) + T(2) * q + T(2) * q4 + T(2) * q9, z4 = T(1) - T(2) * q + T(2) * q4 - T(2) * q9;
  if (!prime) {
    f.sn = odd_cubic<T>(alternating, true, scale, z3 / z2);
    f.cn = odd_cubic<T>(plain, false, scale, z4 / z2);
    f.dn = even_cubic<T>(q, T(1), scale, z4 / z3);
    f.denominator = even_cubic<T>(q, T(-1), scale, T(1));
    f.arg_x = odd_cubic<T>(along, true, scale, T(1));
    f.arg_y = odd_cubic<T>(across, false, scale, T(-1));
  } else {
    f.sn = odd_cubic<T>(alternating, true, scale, z3 / z4);
    f.cn = even_cubic<T>(q, T(-1), scale, z2 / z4);
    f.dn = even_cubic<T>(q, T(1), scale, z2 / z3);
    f.denominator = odd_cubic<T>(plain, false, scale, T(1));
    f.arg_x = odd_cubic<T>(along, false, scale, T(1));
    f.arg_y = odd_cubic<T>(across, true, scale, T(1));
  }
}

[[gnu::always_inline]] inline double cubic(const Cubic& p, double y) {
  return __builtin_fma(__builtin_fma(__builtin_fma(p[3], y, p[2]), y, p[1]), y, p[0]);
}

// hi·t + lo·t as a leading part and a correction, exact to the last bit of the sum's 106.
struct Long {
  double lead, rest;
};
[[gnu::always_inline]] inline Long times(double hi, double lo, double t) {
  const double lead = hi * t;
  return {lead, __builtin_fma(lo, t, __builtin_fma(hi, t, -lead))};
}

// sinh w without cancellation near 0.
[[gnu::always_inline]] inline double sinh_of(double w, double grow, double shrink) {
  if (__builtin_fabs(w) >= 0.35) return 0.5 * (grow - shrink);
  const double z = w * w;
  return w * (1 + z * (1 / 6. + z * (1 / 120. + z * (1 / 5040. + z * (1 / 362880. + z * (1 / 39916800. +
              z * (1 / 6227020800.)))))));
}

// sn, cn, dn and the complex θ₁ whose argument is the periodic part of the precession.
struct Elliptic {
  double sn, cn, dn, arg_x, arg_y;
};

[[gnu::always_inline]] inline Elliptic theta_series(const Tuned& f, double half_periods) {
  double s, c;
  detail::sincospi(half_periods, s, c);
  const double y = __builtin_fma(-2 * s, s, 1.0), inverse = 1 / cubic(f.denominator, y);
  return {s * cubic(f.sn, y) * inverse, c * cubic(f.cn, y) * inverse, cubic(f.dn, y) * inverse,
          s * cubic(f.arg_x, y), c * cubic(f.arg_y, y)};
}

[[gnu::always_inline]] inline Elliptic theta_prime_series(const Tuned& f, double t, double j) {
  const Long u = times(f.w_hi, f.w_lo, t), back = times(f.period_hi, f.period_lo, j);
  const double w = f.omega * (((u.lead - back.lead) + f.u0) + (u.rest - back.rest));
  const double grow = std::exp(w), shrink = 1 / grow, ch = 0.5 * (grow + shrink), sh = sinh_of(w, grow, shrink);
  const double y = f.y_scale * __builtin_fma(2 * sh, sh, 1.0), inverse = 1 / (ch * cubic(f.denominator, y));
  return {sh * cubic(f.sn, y) * inverse, cubic(f.cn, y) * inverse, cubic(f.dn, y) * inverse,
          ch * cubic(f.arg_x, y), sh * cubic(f.arg_y, y)};
}

Attitude pure_rotation(const Tuned& f, double t) {
  const Mat3<double> turn = exp_so3<double>(Vec3<double>(f.w_B * t));
  Attitude a;
  for (int k = 0; k < 3; ++k) a.R_WB.col(k) = apply<double>(f.R0, turn.col(k));
  a.L_B = f.L_B;
  return a;
}

__attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4"))) void evaluate(const Tuned& f, double t,
                                                                                            double* R, double* L) {
  const Long count = times(f.nu_hi, f.nu_lo, t);
  const double j = __builtin_rint(count.lead + f.n0);  // the nearest half period
  Elliptic e = f.kind == Tuned::Kind::theta ? theta_series(f, ((count.lead - j) + f.n0) + count.rest)
                                            : theta_prime_series(f, t, j);
  const double half = j * 0.5, sign = half - __builtin_floor(half) > 0.25 ? -1.0 : 1.0;
  e.sn *= sign, e.cn *= sign;

  const Long drift = times(f.rate_hi, f.rate_lo, t), jumps = times(f.jump_hi, f.jump_lo, j);
  double sin_linear, cos_linear;
  detail::sincospi(((drift.lead - 2 * __builtin_rint(0.5 * drift.lead)) +
                    (jumps.lead - 2 * __builtin_rint(0.5 * jumps.lead))) + (drift.rest + jumps.rest),
                   sin_linear, cos_linear);
  const double unit = 1 / __builtin_sqrt(e.arg_x * e.arg_x + e.arg_y * e.arg_y);
  const double cos_phi = (cos_linear * e.arg_x - sin_linear * e.arg_y) * unit;
  const double sin_phi = (sin_linear * e.arg_x + cos_linear * e.arg_y) * unit;

  const double across = f.rho * e.sn, length = __builtin_sqrt(e.cn * e.cn + across * across), inverse = 1 / length;
  const double ca = e.cn * inverse, sa = across * inverse, ct = f.cos_tilt * e.dn, st = f.sin_tilt * length;
  const double F[3][3] = {{cos_phi * ca * ct + sin_phi * sa, cos_phi * sa * ct - sin_phi * ca, -cos_phi * st},
                          {sin_phi * ca * ct - cos_phi * sa, sin_phi * sa * ct + cos_phi * ca, -sin_phi * st},
                          {st * ca, st * sa, ct}};
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i)
      R[3 * f.axis[k] + i] = f.sign[k] * (f.C[3 * i] * F[0][k] + f.C[3 * i + 1] * F[1][k] + f.C[3 * i + 2] * F[2][k]);
  L[f.axis[0]] = f.L[0] * e.cn;
  L[f.axis[1]] = f.L[1] * e.sn;
  L[f.axis[2]] = f.L[2] * e.dn;
}

// Power of two near x, so that scaling by it rounds nothing.
double power_of_two_near(double x) { return std::ldexp(1.0, std::ilogb(x)); }

template <class T>
Tuned tune(const Vec3<double>& I_B, const Vec3<double>& w_B, const Mat3<double>& R_WB) {
  Tuned f;
  f.R0 = R_WB;
  f.w_B = w_B;
  for (int i = 0; i < 3; ++i) f.L_B[i] = I_B[i] * w_B[i];
  const double spin = w_B.cwiseAbs().maxCoeff(), inertia = I_B.maxCoeff();
  if (spin == 0) return f;
  const double w_unit = power_of_two_near(spin), I_unit = power_of_two_near(inertia);
  const Vec3<T> I(T(I_B[0] / I_unit), T(I_B[1] / I_unit), T(I_B[2] / I_unit));
  const Vec3<T> w(T(w_B[0] / w_unit), T(w_B[1] / w_unit), T(w_B[2] / w_unit));
  const FlightConstants<T> c = flight_constants<T>(I, w);
  if (c.kind == FlightConstants<T>::Kind::pure_rotation) return f;

  f.kind = c.kind == FlightConstants<T>::Kind::theta ? Tuned::Kind::theta : Tuned::Kind::theta_prime;
  f.axis = c.axis;
  f.time_scale = w_unit;
  for (int k = 0; k < 3; ++k) f.sign[k] = double(c.sign[k]);
  f.n0 = double(c.n0);
  f.u0 = double(c.u0);
  f.omega = double(c.omega);
  split<T>(c.nu, f.nu_hi, f.nu_lo);
  split<T>(c.w_p, f.w_hi, f.w_lo);
  split<T>(c.half_period, f.period_hi, f.period_lo);
  split<T>(c.rate / pi<T>(), f.rate_hi, f.rate_lo);
  split<T>(c.jump / pi<T>(), f.jump_hi, f.jump_lo);
  f.rho = double(c.rho);
  f.cos_tilt = double(c.L3m / c.G);
  f.sin_tilt = double(c.L1m / c.G);
  const double unit = I_unit * w_unit;
  f.L = {unit * f.sign[0] * double(c.L1m), unit * f.sign[1] * double(c.L2m), unit * f.sign[2] * double(c.L3m)};
  fold_series<T>(c, f);

  // C from R(0): evaluate the moving frame at t = 0 with C = 1, then C = R0 · frameᵀ.
  f.C = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  Mat3<double> frame;
  Vec3<double> L;
  evaluate(f, 0, frame.data(), L.data());
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      f.C[3 * i + j] = R_WB(i, 0) * frame(j, 0) + R_WB(i, 1) * frame(j, 1) + R_WB(i, 2) * frame(j, 2);
  return f;
}

}  // namespace

Outcome<ExactFlight> ExactFlight::make(const Vec3<double>& I_B, const Vec3<double>& w_B, const Mat3<double>& R_WB,
                                       Precision precision) {
  for (int i = 0; i < 3; ++i) {
    if (!std::isfinite(w_B[i]))
      return Fault{Fault::Kind::not_finite, "spin[" + std::to_string(i) + "]", "must be finite"};
    if (!(I_B[i] > 0) || !std::isfinite(I_B[i]))
      return Fault{Fault::Kind::not_positive, "inertia[" + std::to_string(i) + "]", "must be > 0 and finite"};
  }
  return ExactFlight(precision == Precision::plain ? tune<double>(I_B, w_B, R_WB) : tune<long double>(I_B, w_B, R_WB));
}

Attitude ExactFlight::at(double t) const {
  if (tuned_.kind == Tuned::Kind::pure_rotation) return pure_rotation(tuned_, t);
  Attitude a;
  evaluate(tuned_, tuned_.time_scale * t, a.R_WB.data(), a.L_B.data());
  return a;
}

}  // namespace rigor
