#include <algorithm>
#include <cmath>
#include <reference/theta_flight.hpp>

namespace rigor::reference {
namespace {

template <class T>
T half_turn() {
  return boost::math::constants::pi<T>();
}
template <class T>
T magnitude(const T& a) {
  return a < T(0) ? T(-a) : a;
}

/// F(φ | m) for 0 ≤ φ ≤ π/2, given 1 − m, by the mean's descent: φ' = φ + atan((b/a) tan φ) on the branch next to 2φ,
/// which is the angle of (a cos φ, b sin φ) (DLMF 19.8). `quarter` is F(π/2 | m).
template <class T>
struct Incomplete {
  T value, quarter;
};
template <class T>
Incomplete<T> first_kind(const T& s, const T& c, const T& m1) {
  using std::atan2, std::cos, std::floor, std::sin, std::sqrt;
  const T pi = half_turn<T>();
  T a = T(1), b = sqrt(m1), angle = atan2(s, c), power = T(1);
  for (int n = 0; n < 80 && magnitude(T(a - b)) > T(2) * std::numeric_limits<T>::epsilon() * a; ++n) {
    const T turns = floor(angle / pi + T(1) / T(2)), rest = angle - turns * pi;
    angle = angle + turns * pi + atan2(T(b * sin(rest)), T(a * cos(rest)));
    const T mean = (a + b) / T(2);
    b = sqrt(a * b), a = mean, power = T(2) * power;
  }
  return {angle / (power * a), pi / (T(2) * a)};
}

/// Σ (±1)ⁿ q^{n(n+1)} f(2n+1), and 1 + 2 Σ (±1)ⁿ q^{n²} g(2n): the two shapes of the theta functions.
template <class T, class F>
T odd_sum(const T& q, int sign, F f) {
  T sum = T(0), power = T(1), q2 = T(1);  // q^{n(n+1)}, q^{2n}
  for (int n = 0; n < 400; ++n) {
    const T term = power * f(2 * n + 1);
    sum = n % 2 == 1 && sign < 0 ? T(sum - term) : T(sum + term);
    if (n > 1 && magnitude(term) <= std::numeric_limits<T>::epsilon() / T(64) * magnitude(sum)) break;
    q2 = q2 * q * q, power = power * q2;
    if (!(power > T(0))) break;
  }
  return sum;
}
template <class T, class F>
T even_sum(const T& q, int sign, F g) {
  T sum = T(1), power = q, odd = q;  // q^{n²}, q^{2n-1}
  for (int n = 1; n < 400; ++n) {
    const T term = T(2) * power * g(2 * n);
    sum = n % 2 == 1 && sign < 0 ? T(sum - term) : T(sum + term);
    if (n > 1 && magnitude(term) <= std::numeric_limits<T>::epsilon() / T(64)) break;
    odd = odd * q * q, power = power * odd;
    if (!(power > T(0))) break;
  }
  return sum;
}

template <class T>
Mat3<T> about_third(const T& angle) {
  using std::cos, std::sin;
  const T c = cos(angle), s = sin(angle);
  Mat3<T> R;
  R << c, -s, T(0), s, c, T(0), T(0), T(0), T(1);
  return R;
}

}  // namespace

// Axis 2 has the middle moment, the motion goes round axis 3: the largest where D ≥ 0, else the smallest.
template <class T>
ThetaFlight<T>::ThetaFlight(const Vec3<T>& I_B, const Vec3<T>& w_B, const Mat3<T>& R_WB) : I_(I_B), w_(w_B), R0_(R_WB) {
  using std::cos, std::cosh, std::exp, std::sin, std::sinh, std::sqrt;
  std::array<int, 3> by_size{0, 1, 2};
  std::sort(by_size.begin(), by_size.end(), [&](int i, int j) { return I_B[i] < I_B[j]; });
  const auto [lo, mid, hi] = by_size;
  const T D = I_B[hi] * (I_B[hi] - I_B[mid]) * w_B[hi] * w_B[hi] - I_B[lo] * (I_B[mid] - I_B[lo]) * w_B[lo] * w_B[lo];
  axis_ = D < T(0) ? std::array<int, 3>{hi, mid, lo} : by_size;
  for (const int k : {0, 2}) sign_[std::size_t(k)] = w_B[axis_[std::size_t(k)]] < T(0) ? T(-1) : T(1);
  sign_[1] = sign_[0] * sign_[2] * ((axis_[0] + 1) % 3 == axis_[1] ? T(1) : T(-1));
  T I[3], w[3];
  int at_rest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    I[k] = I_B[axis_[k]], w[k] = sign_[k] * w_B[axis_[k]];
    at_rest += w[k] == T(0);
  }
  const T d12 = magnitude(T(I[0] - I[1])), d13 = magnitude(T(I[0] - I[2])), d23 = magnitude(T(I[1] - I[2]));
  const T P1 = I[1] * d12 * w[1] * w[1] + I[2] * d13 * w[2] * w[2], P3 = I[0] * d13 * w[0] * w[0] + I[1] * d23 * w[1] * w[1];
  speed_ = sqrt(P1 * d23 / (I[0] * I[1] * I[2]));
  if (at_rest >= 2 || !(speed_ > T(0))) return;
  if (I[2] < I[0]) speed_ = -speed_;
  G_ = sqrt(I[0] * I[0] * w[0] * w[0] + I[1] * I[1] * w[1] * w[1] + I[2] * I[2] * w[2] * w[2]);
  L_[0] = sqrt(I[0] * P3 / d13), L_[1] = sqrt(I[1] * P3 / d23), L_[2] = sqrt(I[2] * P1 / d13);
  across_ = sqrt(I[1] * d13 / (I[0] * d23));
  m_ = P3 * d12 / (P1 * d23), m1_ = magnitude(D) * d13 / (P1 * d23);
  kind_ = m_ > m1_ ? Kind::large : Kind::small;

  const T pi = half_turn<T>();
  const bool on_separatrix = !(m1_ > T(0));
  const T s = P3 > T(0) ? T(I[1] * w[1] / L_[1]) : T(0), c = P3 > T(0) ? T(I[0] * w[0] / L_[0]) : T(1);
  if (on_separatrix) {
    using std::atanh;
    u0_ = atanh(s);  // K is infinite, sn is tanh
  } else {
    const Incomplete<T> F = first_kind<T>(s, c, m1_);  // c ≥ 0, as w1 ≥ 0
    u0_ = F.value, K_ = F.quarter;
  }
  // sc(b | 1 − m) = 1/√−n takes the place of the integral of the third kind
  const T minus_n = I[2] * d12 / (I[0] * d23);
  if (m_ > T(0)) {
    const Incomplete<T> B = first_kind<T>(T(1), sqrt(minus_n), m_);
    K1_ = B.quarter;
    beta_ = pi * B.value / (T(2) * (kind_ == Kind::small ? K_ : K1_));
  }
  T slope = T(1);  // d/dv of log θ₁ at the point iβ, or β
  if (kind_ == Kind::small) {
    nome_ = m_ > T(0) ? T(exp(-pi * K1_ / K_)) : T(0);
    if (m_ > T(0))
      slope = odd_sum<T>(nome_, -1, [&](int a) { return T(T(a) * cosh(T(a) * beta_)); }) / odd_sum<T>(nome_, -1, [&](int a) { return T(sinh(T(a) * beta_)); });
    uniform_ = G_ / I[0] - speed_ * pi / (T(2) * K_) * slope;
  } else {
    nome_ = on_separatrix ? T(0) : T(exp(-pi * K_ / K1_));
    slope = odd_sum<T>(nome_, -1, [&](int a) { return T(T(a) * cos(T(a) * beta_)); }) / odd_sum<T>(nome_, -1, [&](int a) { return T(sin(T(a) * beta_)); });
    uniform_ = G_ / I[0] - speed_ * pi / (T(2) * K1_) * slope;
  }
  const Phase start = phase(u0_);
  Mat3<T> P = Mat3<T>::Zero();
  for (int k = 0; k < 3; ++k) P(k, axis_[std::size_t(k)]) = sign_[std::size_t(k)];
  from_ = R0_ * P.transpose() * frame(start).transpose() * about_third<T>(T(-start.angle));
}

template <class T>
typename ThetaFlight<T>::Phase ThetaFlight<T>::phase(const T& u) const {
  using std::atan2, std::cos, std::cosh, std::floor, std::fmod, std::sin, std::sinh;
  const T pi = half_turn<T>();
  const T halves = K_ > T(0) ? T(floor(u / (T(2) * K_) + T(1) / T(2))) : T(0), r = u - T(2) * K_ * halves;
  const T sign = halves - T(2) * floor(halves / T(2)) > T(0) ? T(-1) : T(1);  // odd half periods turn sn and cn round
  const auto sum = [&](int s, auto f) { return odd_sum<T>(nome_, s, f); };
  const auto other = [&](int s, auto f) { return even_sum<T>(nome_, s, f); };
  const auto one = [](int) { return T(1); };
  const T z2 = sum(1, one), z3 = other(1, one), z4 = other(-1, one);
  if (kind_ == Kind::small) {
    const T v = pi * r / (T(2) * K_);
    const T t1 = sum(-1, [&](int a) { return T(sin(T(a) * v)); }), t2 = sum(1, [&](int a) { return T(cos(T(a) * v)); });
    const T t3 = other(1, [&](int a) { return T(cos(T(a) * v)); }), t4 = other(-1, [&](int a) { return T(cos(T(a) * v)); });
    T angle = pi * halves;
    if (m_ > T(0))
      angle = angle + atan2(T(-sum(-1, [&](int a) { return T(cos(T(a) * v) * sinh(T(a) * beta_)); })), T(sum(-1, [&](int a) { return T(sin(T(a) * v) * cosh(T(a) * beta_)); })));
    else
      angle = angle + v;  // a symmetric body: one harmonic
    return {sign * z3 / z2 * t1 / t4, sign * z4 / z2 * t2 / t4, z4 / z3 * t3 / t4, angle};
  }
  const T w = pi * r / (T(2) * K1_);
  const T t1 = sum(-1, [&](int a) { return T(sinh(T(a) * w)); }), t2 = sum(1, [&](int a) { return T(cosh(T(a) * w)); });
  const T t3 = other(1, [&](int a) { return T(cosh(T(a) * w)); }), t4 = other(-1, [&](int a) { return T(cosh(T(a) * w)); });
  const T angle = (pi - T(2) * beta_) * halves + atan2(sum(-1, [&](int a) { return T(cos(T(a) * beta_) * sinh(T(a) * w)); }), sum(-1, [&](int a) { return T(sin(T(a) * beta_) * cosh(T(a) * w)); }));
  return {sign * z3 / z4 * t1 / t2, sign * z2 / z4 * t4 / t2, z2 / z3 * t3 / t2, angle};
}

// Rows: two that turn with the body about L, and L itself, in the sorted body axes.
template <class T>
Mat3<T> ThetaFlight<T>::frame(const Phase& p) const {
  using std::sqrt;
  const T y = across_ * p.sn, length = sqrt(p.cn * p.cn + y * y), c = p.cn / length, s = y / length;
  const T along = L_[2] * p.dn / G_, off = L_[0] * length / G_;
  Mat3<T> F;
  F << c * along, s * along, -off, -s, c, T(0), off * c, off * s, along;
  return F;
}

template <class T>
Attitude<T> ThetaFlight<T>::at(const T& t) const {
  using std::cos, std::sin, std::sqrt;
  Attitude<T> end{R0_, w_};
  if (kind_ == Kind::one_axis) {
    const T w = sqrt(w_.dot(w_));
    if (!(w > T(0))) return end;
    const Vec3<T> n = w_ / w;
    const T c = cos(w * t), s = sin(w * t);
    Mat3<T> turn;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) turn(i, k) = (i == k ? c : T(0)) + (T(1) - c) * n[i] * n[k];
    for (int i = 0; i < 3; ++i) turn((i + 2) % 3, (i + 1) % 3) += s * n[i], turn((i + 1) % 3, (i + 2) % 3) -= s * n[i];
    end.R_WB = R0_ * turn;
    return end;
  }
  const Phase p = phase(T(u0_ + speed_ * t));
  Mat3<T> P = Mat3<T>::Zero();
  for (int k = 0; k < 3; ++k) P(k, axis_[std::size_t(k)]) = sign_[std::size_t(k)];
  end.R_WB = from_ * about_third<T>(T(uniform_ * t + p.angle)) * frame(p) * P;
  const T L[3] = {L_[0] * p.cn, L_[1] * p.sn, L_[2] * p.dn};
  for (std::size_t k = 0; k < 3; ++k) end.w_B[axis_[k]] = sign_[k] * L[k] / I_[axis_[k]];
  return end;
}

template class ThetaFlight<double>;
template class ThetaFlight<long double>;
template class ThetaFlight<Quad>;
template class ThetaFlight<Precise>;

}  // namespace rigor::reference
