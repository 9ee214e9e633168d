#pragma once
#include <cstdint>
#include <random>
#include <vector>
#include <rigor/formulas/apply_pair_impulse.hpp>
#include <rigor/formulas/cuboid_inertia.hpp>
#include <rigor/formulas/cuboid_inverse_inertia.hpp>
#include <rigor/formulas/world_inverse_inertia.hpp>
#include <rigor/linalg/rotation.hpp>

namespace rigor::verify {

/// One random set of everything a formula may ask for, consistent: two cuboids with three different edges, generic
/// poses, spin on both, centres off the origin, one contact with a skew unit normal. Over ℚ exact: R orthogonal,
/// n a unit vector, inertias the cuboids' own.
template <class T>
struct Inputs {
  T m, m_B, e, mu, h;
  Vec3<T> s_B, I_B, inverse_I_B, p_WB, p_WO, v_WB, w_WB, f_W, tau_W, p_BC_W, n_W, j_W;
  Mat3<T> R_WB, I_B_W, inverse_I_B_W, M;  ///< M: independent columns near a rotation
  ImpactBody<T> A, B;
  PairVelocity<T> u;

  /// Every number, for conversion to another scalar field by field.
  template <class F>
  void each(F visit) {
    for (T* x : {&m, &m_B, &e, &mu, &h}) visit(*x);
    for (Vec3<T>* x : {&s_B, &I_B, &inverse_I_B, &p_WB, &p_WO, &v_WB, &w_WB, &f_W, &tau_W, &p_BC_W, &n_W, &j_W,
                       &A.p_BC_W, &B.p_BC_W, &u.A.v_WB, &u.A.w_WB, &u.B.v_WB, &u.B.w_WB})
      for (int i = 0; i < 3; ++i) visit((*x)[i]);
    for (Mat3<T>* x : {&R_WB, &I_B_W, &inverse_I_B_W, &M, &A.inverse_I_B_W, &B.inverse_I_B_W})
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) visit((*x)(i, j));
    visit(A.inverse_mass), visit(B.inverse_mass);
  }
};

using Random = std::mt19937_64;

/// An integer in [low, high]; the same stream on every platform (std::uniform_int_distribution's is not).
inline int integer(Random& random, int low, int high) {
  return low + int((random() >> 33) % std::uint64_t(high - low + 1));
}

template <class T>
T fraction(Random& random, int low, int high, int denominator) {
  return T(integer(random, low * denominator, high * denominator)) / T(denominator);
}

template <class T>
Vec3<T> vector(Random& random, int reach) {
  const T x = fraction<T>(random, -reach, reach, 1024), y = fraction<T>(random, -reach, reach, 1024);
  return Vec3<T>(x, y, fraction<T>(random, -reach, reach, 1024));
}

/// Three edges at least 1/4 apart, m.
template <class T>
Vec3<T> edges(Random& random) {
  const T a = fraction<T>(random, 1, 3, 256), b = a + T(1) / T(4) + fraction<T>(random, 0, 2, 256);
  return Vec3<T>(b, a, b + T(1) / T(4) + fraction<T>(random, 0, 2, 256));
}

template <class T>
Mat3<T> rotation(Random& random) {
  Vec4<T> q;
  for (int i = 0; i < 4; ++i) {
    const int size = integer(random, 1, 9);
    q[i] = T(integer(random, 0, 1) != 0 ? size : -size);
  }
  return rotation_of<T>(q);
}

/// Stereographic: rational and of unit length.
template <class T>
Vec3<T> unit_vector(Random& random) {
  const T a = fraction<T>(random, -2, 2, 64), b = fraction<T>(random, -2, 2, 64), n = T(1) + a * a + b * b;
  return Vec3<T>(T(2) * a / n, T(2) * b / n, (T(1) - a * a - b * b) / n);
}

template <class T>
Inputs<T> draw(Random& random) {
  Inputs<T> in;
  in.m = fraction<T>(random, 1, 4, 256);
  in.m_B = fraction<T>(random, 1, 4, 256);
  in.e = fraction<T>(random, 0, 1, 16);
  in.mu = fraction<T>(random, 0, 1, 16);
  in.h = T(1) / T(1 << integer(random, 4, 12));
  in.s_B = edges<T>(random);
  in.I_B = cuboid_inertia<T>(in.m, in.s_B);
  in.inverse_I_B = cuboid_inverse_inertia<T>(in.I_B);
  in.p_WB = vector<T>(random, 8);
  in.p_WO = vector<T>(random, 8);
  in.v_WB = vector<T>(random, 4);
  in.w_WB = vector<T>(random, 4);
  in.f_W = vector<T>(random, 16);
  in.tau_W = vector<T>(random, 16);
  in.p_BC_W = vector<T>(random, 2);
  in.n_W = unit_vector<T>(random);
  in.j_W = vector<T>(random, 4);
  in.R_WB = rotation<T>(random);
  in.I_B_W = world_inertia<T>(in.R_WB, in.I_B);
  in.inverse_I_B_W = world_inverse_inertia<T>(in.R_WB, in.inverse_I_B);
  for (int k = 0; k < 3; ++k) {  // R with small errors, as a step leaves it
    const Vec3<T> off = vector<T>(random, 1);
    for (int i = 0; i < 3; ++i) in.M(i, k) = in.R_WB(i, k) + off[i] / T(64);
  }
  const Vec3<T> s_other = edges<T>(random);
  const Mat3<T> R_other = rotation<T>(random);
  const Vec3<T> I_other = cuboid_inertia<T>(in.m_B, s_other);
  in.A = {T(1) / in.m, in.inverse_I_B_W, in.p_BC_W};
  in.B = {T(1) / in.m_B, world_inverse_inertia<T>(R_other, cuboid_inverse_inertia<T>(I_other)), vector<T>(random, 2)};
  in.u.A.v_WB = in.v_WB;
  in.u.A.w_WB = in.w_WB;
  in.u.B.v_WB = vector<T>(random, 4);
  in.u.B.w_WB = vector<T>(random, 4);
  return in;
}

/// The same numbers in another scalar.
template <class To, class From, class Convert>
Inputs<To> converted(Inputs<From> from, Convert convert) {
  std::vector<From> numbers;
  from.each([&](const From& x) { numbers.push_back(x); });
  Inputs<To> to;
  std::size_t next = 0;
  to.each([&](To& x) { x = convert(numbers[next++]); });
  return to;
}

}  // namespace rigor::verify
