#include <cmath>
#include <rigor/engine/exact_flight.hpp>
#include <rigor/engine/flight_constants.hpp>

namespace rigor {
namespace {

using Tuned = ExactFlight::Tuned;
using Numbers = detail::FlightNumbers<double>;

template <class T>
void split(const T& x, double& hi, double& lo) {
  hi = double(x);
  lo = double(x - T(hi));
}

// Σ eₙ·(harmonic 2n+1)/(harmonic 1) as a cubic in y = scale·X, X = cos 2v or cosh 2w:
// sine-like ratios 1, 2X+1, 4X²+2X−1, 8X³+4X²−4X−1; cosine-like 1, 2X−1, 4X²−2X−1, 8X³−4X²−4X+1.
template <class T>
void odd_cubic(double (&cubic)[4], const std::array<T, 4>& e, bool sine_like, const T& scale, const T& factor) {
  const T g = sine_like ? T(1) : T(-1), i = T(1) / scale;
  cubic[0] = double(factor * (e[0] + g * e[1] - e[2] - g * e[3]));
  cubic[1] = double(factor * ((T(2) * e[1] + T(2) * g * e[2] - T(4) * e[3]) * i));
  cubic[2] = double(factor * (((T(4) * e[2] + T(4) * g * e[3]) * i) * i));
  cubic[3] = double(factor * (((T(8) * e[3] * i) * i) * i));
}

// θ₃ (s = 1) or θ₄ (s = −1) = 1 + 2s q X + 2q⁴(2X² − 1) + 2s q⁹(4X³ − 3X)
template <class T>
void even_cubic(double (&cubic)[4], const T& q, const T& s, const T& scale, const T& factor) {
  const T i = T(1) / scale, q4 = q * q * q * q, q9 = q4 * q4 * q;
  cubic[0] = double(factor * (T(1) - T(2) * q4));
  cubic[1] = double(factor * ((T(2) * s * q - T(6) * s * q9) * i));
  cubic[2] = double(factor * ((T(4) * q4 * i) * i));
  cubic[3] = double(factor * (((T(8) * s * q9 * i) * i) * i));
}

// The four-term theta series (q ≤ e^−π, so the fifth term is below 1e−27) folded into six cubics.
template <class T>
void fold_series(const FlightConstants<T>& c, Numbers& f) {
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
    } else if (c.symmetric) {  // one harmonic, and β without bound
      along[n] = across[n] = n == 0 ? T(1) : T(0);
    } else {
      along[n] = power * cosh(a * c.beta) / cosh(c.beta);
      across[n] = power * sinh(a * c.beta) / cosh(c.beta);
    }
  }
  const T z2 = T(1) + q2 + q6 + q12, q4 = q2 * q2, q9 = q4 * q4 * q;
  const T z3 = T(1) + T(2) * q + T(2) * q4 + T(2) * q9, z4 = T(1) - T(2) * q + T(2) * q4 - T(2) * q9;
  if (!prime) {
    odd_cubic<T>(f.sn, alternating, true, scale, z3 / z2);
    odd_cubic<T>(f.cn, plain, false, scale, z4 / z2);
    even_cubic<T>(f.dn, q, T(1), scale, z4 / z3);
    even_cubic<T>(f.denominator, q, T(-1), scale, T(1));
    odd_cubic<T>(f.arg_x, along, true, scale, T(1));
    odd_cubic<T>(f.arg_y, across, false, scale, T(-1));
  } else {
    odd_cubic<T>(f.sn, alternating, true, scale, z3 / z4);
    even_cubic<T>(f.cn, q, T(-1), scale, z2 / z4);
    even_cubic<T>(f.dn, q, T(1), scale, z2 / z3);
    odd_cubic<T>(f.denominator, plain, false, scale, T(1));
    odd_cubic<T>(f.arg_x, along, false, scale, T(1));
    odd_cubic<T>(f.arg_y, across, true, scale, T(1));
  }
}

void rotate(const Tuned& f, double t, Attitude& a) {
  const Mat3<double> turn = exp_so3<double>(Vec3<double>(f.w_B * t));
  for (int k = 0; k < 3; ++k) a.R_WB.col(k) = apply<double>(f.R0, turn.col(k));
  a.L_B = f.L_B;
}

__attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4"))) void evaluate(const Tuned& f, double t,
                                                                                            double* R, double* L) {
  const detail::FlightColumns now = f.kind == Tuned::Kind::theta ? detail::evaluate_flight<false>(f.numbers, 0, t)
                                                                 : detail::evaluate_flight<true>(f.numbers, 0, t);
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i) R[3 * f.axis[k] + i] = now.R[k][i];
    L[f.axis[k]] = now.L[k];
  }
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
  Numbers& n = f.numbers;
  n.time_scale = w_unit;
  for (int k = 0; k < 3; ++k) n.sign[k] = double(c.sign[k]);
  n.n0 = double(c.n0);
  n.u0 = double(c.u0);
  n.omega = double(c.omega);
  split<T>(c.nu, n.nu_hi, n.nu_lo);
  split<T>(c.w_p, n.w_hi, n.w_lo);
  split<T>(c.half_period, n.period_hi, n.period_lo);
  split<T>(c.rate / pi<T>(), n.rate_hi, n.rate_lo);
  split<T>(c.jump / pi<T>(), n.jump_hi, n.jump_lo);
  n.rho = double(c.rho);
  n.cos_tilt = double(c.L3m / c.G);
  n.sin_tilt = double(c.L1m / c.G);
  const double unit = I_unit * w_unit;
  const T amplitude[3] = {c.L1m, c.L2m, c.L3m};
  for (int k = 0; k < 3; ++k) n.L[k] = unit * n.sign[k] * double(amplitude[k]);
  fold_series<T>(c, n);

  // C from R(0): evaluate the moving frame at t = 0 with C = 1, then C = R0 · frameᵀ.
  for (int k = 0; k < 9; ++k) n.C[k] = k % 4 == 0;
  Mat3<double> frame;
  Vec3<double> L;
  evaluate(f, 0, frame.data(), L.data());
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      n.C[3 * i + j] = R_WB(i, 0) * frame(j, 0) + R_WB(i, 1) * frame(j, 1) + R_WB(i, 2) * frame(j, 2);
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

Attitude ExactFlight::at(double t) const noexcept {
  Attitude a;  // the one object returned: a copy of what was just written would cost half as much again
  if (tuned_.kind == Tuned::Kind::pure_rotation) rotate(tuned_, t, a);
  else evaluate(tuned_, t, a.R_WB.data(), a.L_B.data());
  return a;
}

}  // namespace rigor
