#pragma once
#include <array>
#include <rigor/engine/elliptic.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/scalar/constants.hpp>
#include <utility>

namespace rigor {

/// What torque-free motion of one body needs besides t, in precision T. Derivation: docs/exact-flight.md.
///
/// Axis 2 carries the middle moment; axis 3 is the one the spin circles about (the largest moment when
/// D = G² − 2E·I_mid ≥ 0, else the smallest); axis 1 is the third. Signs make w₁, w₃ ≥ 0. Then
///
///     L₁ = L₁m cn(u|m),  L₂ = L₂m sn(u|m),  L₃ = L₃m dn(u|m),  u = u₀ + ω_p t
///     R(t) = C · Rz(φ(t)) · F(sn, cn, dn) · P
///
/// Everything small near a degenerate case is a sum of terms of one sign; only D cancels.
template <Real T>
struct FlightConstants {
  enum class Kind {
    pure_rotation,  ///< sphere, spin about one principal axis, or no spin at all
    theta,          ///< m ≤ 1/2, nome q = exp(−πK'/K)
    theta_prime,    ///< m > 1/2, complementary nome q' = exp(−πK/K'); q' = 0 on the separatrix
  };
  Kind kind;
  bool symmetric;            ///< two equal moments: m = 0, one harmonic
  std::array<int, 3> axis;
  std::array<T, 3> sign;
  T G;                       ///< |L|
  T L1m, L2m, L3m;
  T rho;                     ///< L2m/L1m, defined even where both vanish
  T u0, w_p;                 ///< phase of the elliptic functions and its rate
  T half_period;             ///< 2K, in u; 0 on the separatrix
  T n0, nu;                  ///< u0 and w_p counted in half periods
  T q, beta;
  T omega;                   ///< π/2K' for theta_prime: w = omega·(u − 2Kj)
  T rate, jump;              ///< φ = rate·t + jump·j + arg θ₁; theta's jump is π and not kept
};

namespace detail {

/// Σ over odd harmonics a = 2n+1 of (−1)ⁿ q^{n(n+1)} f(a), until a term no longer matters.
template <class T, class F>
T odd_harmonics(const T& q, F f) {
  T sum = T(0), power = T(1), factor = T(1);  // power = q^{n(n+1)}, factor = q^{2n}
  for (int n = 0; n < 60; ++n) {
    const T term = power * f(2 * n + 1), before = sum;
    sum = sum + (n % 2 == 0 ? term : -term);
    if (n > 0 && sum == before) break;
    factor = factor * q * q;
    power = power * factor;
    if (!(power > T(0))) break;
  }
  return sum;
}

}  // namespace detail

/// Sets up one flight from principal moments and body spin.
///
/// shapes    I_B (3), w_B (3)
/// units     kg·m², rad/s; only ratios of the moments enter the motion
/// frames    body axes
/// domain    I_B > 0 and a cuboid's (triangle inequality); finite; scaled so that nothing under- or overflows
/// rounding  a few tens of eps(T), except D, whose cancellation near the separatrix costs its relative size
template <Real T>
FlightConstants<T> flight_constants(const Vec3<T>& I_B, const Vec3<T>& w_B) {
  using std::cos, std::cosh, std::exp, std::sin, std::sinh, std::sqrt;
  const auto size = [](const T& a) { return a < T(0) ? -a : a; };
  FlightConstants<T> c{};  // a pure rotation, until more is known
  int lo = 0, mid = 1, hi = 2;
  if (I_B[lo] > I_B[mid]) std::swap(lo, mid);
  if (I_B[mid] > I_B[hi]) std::swap(mid, hi);
  if (I_B[lo] > I_B[mid]) std::swap(lo, mid);
  const T D = I_B[hi] * (I_B[hi] - I_B[mid]) * w_B[hi] * w_B[hi] - I_B[lo] * (I_B[mid] - I_B[lo]) * w_B[lo] * w_B[lo];
  c.axis = D >= T(0) ? std::array<int, 3>{lo, mid, hi} : std::array<int, 3>{hi, mid, lo};
  c.sign[0] = w_B[c.axis[0]] < T(0) ? T(-1) : T(1);
  c.sign[2] = w_B[c.axis[2]] < T(0) ? T(-1) : T(1);
  const bool cyclic = c.axis[1] == (c.axis[0] + 1) % 3;  // keeps the signed permutation a rotation
  c.sign[1] = c.sign[0] * c.sign[2] * (cyclic ? T(1) : T(-1));

  const T w1 = c.sign[0] * w_B[c.axis[0]], w2 = c.sign[1] * w_B[c.axis[1]], w3 = c.sign[2] * w_B[c.axis[2]];
  const T I1 = I_B[c.axis[0]], I2 = I_B[c.axis[1]], I3 = I_B[c.axis[2]];
  const T d12 = size(I1 - I2), d13 = size(I1 - I3), d23 = size(I2 - I3);
  const T P3 = I1 * d13 * w1 * w1 + I2 * d23 * w2 * w2;  // |G² − 2E·I₃|
  const T P1 = I2 * d12 * w2 * w2 + I3 * d13 * w3 * w3;  // |G² − 2E·I₁|
  c.G = sqrt(I1 * I1 * w1 * w1 + I2 * I2 * w2 * w2 + I3 * I3 * w3 * w3);
  c.w_p = sqrt(P1 * d23 / (I1 * I2 * I3));
  const bool about_one_axis = (w1 == T(0)) + (w2 == T(0)) + (w3 == T(0)) >= 2;
  if (about_one_axis || !(c.w_p > T(0))) return c;

  c.L1m = sqrt(I1 * P3 / d13);
  c.L2m = sqrt(I2 * P3 / d23);
  c.L3m = sqrt(I3 * P1 / d13);
  c.rho = sqrt(I2 * d13 / (I1 * d23));
  if (I3 < I1) c.w_p = -c.w_p;
  c.symmetric = d12 == T(0);
  const T m = P3 * d12 / (P1 * d23), m1 = size(D) * d13 / (P1 * d23);  // m1 = 1 − m, never by subtraction
  T sn = T(0), cn = T(1), dn = T(1);
  if (P3 > T(0)) sn = I2 * w2 / c.L2m, cn = I1 * w1 / c.L1m, dn = I3 * w3 / c.L3m;
  c.u0 = sn * carlson_rf<T>(cn * cn, dn * dn, T(1));

  // b with sc(b|m1) = 1/√−n, n = −I₃d₁₂/(I₁d₂₃); it replaces the integral of the third kind
  const T n1 = c.rho * c.rho, minus_n = I3 * d12 / (I1 * d23);
  const T b = sqrt(T(1) / n1) * carlson_rf<T>(minus_n / n1, (m + minus_n) / n1, T(1));
  const T K_prime = m > T(0) ? pi<T>() / T(2) / agm<T>(T(1), sqrt(m)) : T(0);
  if (m <= T(1) / T(2)) {
    c.kind = FlightConstants<T>::Kind::theta;
    const T K = pi<T>() / T(2) / agm<T>(T(1), sqrt(m1));
    c.half_period = T(2) * K;
    c.q = m > T(0) ? T(exp(-pi<T>() * K_prime / K)) : T(0);
    T eta = T(1);
    if (!c.symmetric) {
      c.beta = pi<T>() * b / (T(2) * K);
      eta = detail::odd_harmonics<T>(c.q, [&](int a) { return T(T(a) * cosh(T(a) * c.beta)); }) /
            detail::odd_harmonics<T>(c.q, [&](int a) { return T(sinh(T(a) * c.beta)); });
    }
    c.rate = c.G / I1 - pi<T>() / (T(2) * K) * eta * c.w_p;
  } else {
    c.kind = FlightConstants<T>::Kind::theta_prime;
    const bool separatrix = !(m1 > T(0));  // K is infinite: no period, no range reduction
    const T K = separatrix ? T(0) : T(pi<T>() / T(2) / agm<T>(T(1), sqrt(m1)));
    c.half_period = T(2) * K;
    c.q = separatrix ? T(0) : T(exp(-pi<T>() * K / K_prime));
    c.omega = pi<T>() / (T(2) * K_prime);
    c.beta = c.omega * b;
    const T lambda = detail::odd_harmonics<T>(c.q, [&](int a) { return T(T(a) * cos(T(a) * c.beta)); }) /
                     detail::odd_harmonics<T>(c.q, [&](int a) { return T(sin(T(a) * c.beta)); });
    c.rate = c.G / I1 - c.w_p * c.omega * lambda;
    c.jump = pi<T>() - T(2) * c.beta;
  }
  if (c.half_period > T(0)) {
    c.n0 = c.u0 / c.half_period;
    c.nu = c.w_p / c.half_period;
  }
  return c;
}

}  // namespace rigor
