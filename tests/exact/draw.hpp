#pragma once
#include <cstdint>
#include <random>
#include <rigor/bodies/cuboid.hpp>
#include <rigor/formulas/apply_pair_impulse.hpp>
#include <rigor/formulas/state.hpp>
#include <rigor/formulas/world_inverse_inertia.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/scalar/rational.hpp>

namespace rigor {

using Q = Rational;

inline Q determinant(const Mat3<Q>& M) { return cross<Q>(M.col(0), M.col(1)).dot(M.col(2)); }

/// Draws per identity. A wrong identity whose cleared numerator has degree d vanishes at a random point with
/// probability at most d/|S| (Schwartz-Zippel), S the numerators drawn from: here |S| = 2^32, so for d = 1000
/// eight draws let it pass with probability below 1e-52.
constexpr int draws = 8;

/// Seeded random rationals and what is made of them. Every constraint (unit length, orthogonality, positive
/// inertia) holds exactly, by a rational parametrisation.
class Draw {
 public:
  /// `reach` bounds the numerators; small ones make long computations cheap and identities easier to pass by
  /// accident.
  explicit Draw(std::uint64_t seed, long reach = 1L << 31) : reach_(reach), random_(seed) {}

  /// In [low, high], the same on every standard library (the distributions of <random> are not).
  long integer(long low, long high) { return low + long(random_() % std::uint64_t(high - low + 1)); }
  /// In [−8, 8], 2 reach numerators.
  Q number() {
    const long numerator = integer(-reach_, reach_);
    return Q(numerator, reach_ / 8 + integer(0, 63));
  }
  Q positive() {
    const long numerator = integer(1, reach_);
    return Q(numerator, reach_ / 8 + integer(0, 63));
  }
  /// In [0, 1].
  Q fraction() { return Q(integer(0, reach_), reach_); }
  Vec3<Q> vector() {
    const Q x = number(), y = number(), z = number();
    return Vec3<Q>(x, y, z);
  }
  Vec3<Q> lengths() {
    const Q x = positive(), y = positive(), z = positive();
    return Vec3<Q>(x, y, z);
  }
  /// A unit vector, by stereographic projection.
  Vec3<Q> unit() {
    const Q s = number() / Q(4), t = number() / Q(4), d = Q(1) + s * s + t * t;
    return Vec3<Q>(Q(2) * s / d, Q(2) * t / d, (Q(1) - s * s - t * t) / d);
  }
  /// A rotation, from a quaternion of rationals: orthogonal exactly.
  Mat3<Q> rotation() {
    const Q w = number(), x = number(), y = number(), z = number();
    return rotation_of<Q>(Vec4<Q>(w, x, y, z));
  }
  /// A cuboid with three different edges, a generic pose and generic velocities.
  Cuboid<Q> cuboid() {
    const Q mass = positive();
    return *Cuboid<Q>::make(mass, lengths());
  }
  State<Q> state() {
    State<Q> s;
    s.p_WB = vector();
    s.R_WB = rotation();
    s.v_WB = vector();
    s.w_WB = vector();
    return s;
  }

 private:
  long reach_;
  std::mt19937_64 random_;
};

/// A cuboid somewhere, with its inertia in world axes.
struct Body {
  Cuboid<Q> shape;
  State<Q> state;

  Q mass() const { return shape.mass(); }
  Mat3<Q> inertia() const { return world_inertia<Q>(state.R_WB, shape.inertia()); }
  Velocity<Q> velocity() const { return {state.v_WB, state.w_WB}; }
  ImpactBody<Q> at(const Vec3<Q>& p_WC) const {
    return {shape.inverse_mass(), world_inverse_inertia<Q>(state.R_WB, shape.inverse_inertia()),
            Vec3<Q>(p_WC - state.p_WB)};
  }
};

inline Body draw_body(Draw& draw) {
  const Cuboid<Q> shape = draw.cuboid();
  return {shape, draw.state()};
}

/// Two cuboids with a contact at C (any point in space: no law here asks whether the point is on a surface).
struct Meeting {
  Body a, b;
  Vec3<Q> p_WC, n_AB_W;
  Q e;

  ImpactBody<Q> A() const { return a.at(p_WC); }
  ImpactBody<Q> B() const { return b.at(p_WC); }
  PairVelocity<Q> before() const { return {a.velocity(), b.velocity()}; }
};

inline Meeting draw_meeting(Draw& draw) {
  const Body a = draw_body(draw), b = draw_body(draw);
  const Vec3<Q> p_WC = draw.vector(), n = draw.unit();
  return {a, b, p_WC, n, draw.fraction()};
}

/// The same with v_n < 0: n is turned round if need be.
inline Meeting draw_approach(Draw& draw) {
  Meeting m = draw_meeting(draw);
  if (Q(0) < relative_velocity<Q>(m.A(), m.B(), m.before()).dot(m.n_AB_W)) m.n_AB_W = Vec3<Q>(-m.n_AB_W);
  return m;
}

}  // namespace rigor
