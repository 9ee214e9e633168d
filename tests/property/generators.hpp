#pragma once
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <ostream>
#include <rigor/formulas/apply_pair_impulse.hpp>
#include <rigor/formulas/cuboid_inertia.hpp>
#include <rigor/formulas/cuboid_inverse_inertia.hpp>
#include <rigor/formulas/normal_effective_mass.hpp>
#include <rigor/formulas/state.hpp>
#include <rigor/formulas/world_inverse_inertia.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/scalar/gamma.hpp>
#include <rigor/scalar/magnitude.hpp>

namespace rigor {

/// A body in any scalar, with what impacts need of it.
template <class T>
struct Body {
  T m;
  Vec3<T> s_B, I_B, inverse_I_B;
  State<T> state;

  Mat3<T> inertia() const { return world_inertia<T>(state.R_WB, I_B); }
  Velocity<T> velocity() const { return {state.v_WB, state.w_WB}; }
  ImpactBody<T> at(const Vec3<T>& p_WC) const {
    ImpactBody<T> B{T(1) / m, world_inverse_inertia<T>(state.R_WB, inverse_I_B), p_WC};
    for (int i = 0; i < 3; ++i) B.p_BC_W[i] = p_WC[i] - state.p_WB[i];
    return B;
  }
};

template <class T>
struct Meeting {
  Body<T> a, b;
  Vec3<T> p_WC, n_AB_W;
  T e;

  ImpactBody<T> A() const { return a.at(p_WC); }
  ImpactBody<T> B() const { return b.at(p_WC); }
  PairVelocity<T> before() const { return {a.velocity(), b.velocity()}; }
};

/// Small integers, which shrink well; `body` and `meeting` turn them into numbers of any scalar. Two cuboids
/// with three different edges each, generic rotations, centres off the origin, spin on both, a skew normal.
struct Numbers {
  static constexpr int per_body = 17, count = 2 * per_body + 6;
  std::array<int, count> n{};

  template <class T>
  Body<T> body(int which) const {
    const int* k = n.data() + which * per_body;
    const auto number = [](int i) { return T(i) / T(64); };
    const auto size = [](int i) { return i < 0 ? -i : i; };
    const auto vector = [&](const int* i) { return Vec3<T>(number(i[0]), number(i[1]), number(i[2])); };
    Body<T> body;
    body.m = number(64 + size(k[0]));
    const T a = number(16 + size(k[1])), b = a + number(1 + size(k[2])), c = b + number(1 + size(k[3]));
    body.s_B = Vec3<T>(b, c, a);
    body.I_B = cuboid_inertia<T>(body.m, body.s_B);
    body.inverse_I_B = cuboid_inverse_inertia<T>(body.I_B);
    body.state.R_WB = rotation_of<T>(Vec4<T>(T(100 + k[4] / 16), T(k[5]), T(k[6]), T(k[7])));
    body.state.p_WB = vector(k + 8);
    body.state.v_WB = vector(k + 11);
    body.state.w_WB = vector(k + 14);
    return body;
  }

  template <class T>
  Meeting<T> meeting() const {
    const int* k = n.data() + 2 * per_body;
    const T a = T(k[3]) / T(512), b = T(k[4]) / T(512), d = T(1) + a * a + b * b;
    return {body<T>(0), body<T>(1), Vec3<T>(T(k[0]) / T(64), T(k[1]) / T(64), T(k[2]) / T(64)),
            Vec3<T>((a + a) / d, (b + b) / d, (T(1) - a * a - b * b) / d),  // stereographic: of unit length
            T(k[5] < 0 ? -k[5] : k[5]) / T(1024)};
  }

  friend std::ostream& operator<<(std::ostream& out, const Numbers& numbers) {
    for (int which : {0, 1}) {
      const Body<double> b = numbers.body<double>(which);
      out << (which ? "\nB: " : "A: ") << "m " << b.m << ", s " << b.s_B.transpose() << ", p "
          << b.state.p_WB.transpose() << ", v " << b.state.v_WB.transpose() << ", w "
          << b.state.w_WB.transpose() << "\nR\n"
          << b.state.R_WB;
    }
    const Meeting<double> m = numbers.meeting<double>();
    return out << "\nC: " << m.p_WC.transpose() << ", n " << m.n_AB_W.transpose() << ", e " << m.e;
  }
};

}  // namespace rigor

namespace rc {
template <>
struct Arbitrary<rigor::Numbers> {
  static Gen<rigor::Numbers> arbitrary() {
    const auto zigzag = gen::map(gen::inRange(0, 2048), [](int i) { return i % 2 ? -(i + 1) / 2 : i / 2; });
    return gen::map(gen::container<std::array<int, rigor::Numbers::count>>(zigzag),
                    [](const std::array<int, rigor::Numbers::count>& n) { return rigor::Numbers{n}; });
  }
};
}  // namespace rc

namespace rigor {

/// The bound of a property: `residual` is zero over the reals and a straight line of + − × ÷ √ from the
/// integers on, so in double it is at most γ_k times the absolute sum of its terms, k the roundings on its
/// longest path. Magnitude computes that sum by running the same lines.
template <class Residual>
double worst_ratio(const Numbers& numbers, int k, const Residual& residual) {
  const auto got = residual.template operator()<double>(numbers);
  const auto sum = residual.template operator()<Magnitude>(numbers);
  double worst = 0;
  for (std::size_t i = 0; i < got.size(); ++i) {
    const double ratio = got[i] == 0 ? 0 : std::abs(got[i]) / (gamma_bound(k) * sum[i].size);
    if (!(ratio <= worst)) worst = ratio;  // NaN is kept
  }
  return worst;
}

}  // namespace rigor
