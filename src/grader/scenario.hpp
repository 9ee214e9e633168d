#pragma once
#include <random>
#include <rigor/bodies/cuboid.hpp>
#include <rigor/formulas/world_inverse_inertia.hpp>
#include <rigor/grader/records.hpp>
#include <rigor/grader/worker.hpp>
#include <rigor/linalg/rotation.hpp>

namespace rigor::grader {

using Random = std::mt19937_64;

/// An integer in [low, high], the same on every platform.
inline int integer(Random& random, int low, int high) {
  return low + int((random() >> 33) % std::uint64_t(high - low + 1));
}
/// A multiple of 1/64 in [low, high]: exact, short to print, easy to shrink.
inline double grid(Random& random, double low, double high) { return integer(random, int(low * 64), int(high * 64)) / 64.0; }
inline double sign(Random& random) { return integer(random, 0, 1) == 0 ? -1.0 : 1.0; }
/// Each component of either sign, at least `least` in size. (One draw a statement, here and in every check: the order
/// of operands and arguments is the compiler's choice, and the graded cases must not be.)
inline Vec3<double> arrow(Random& random, double least, double most) {
  Vec3<double> a;
  for (int i = 0; i < 3; ++i) {
    const double s = sign(random);
    a[i] = s * grid(random, least, most);
  }
  return a;
}

/// One cuboid of a case, by the numbers a person would write down. The shrinker works on these.
struct Box {
  Vec3<double> size{1, 1, 1};
  double mass = 1;
  Vec4<double> turn{1, 0, 0, 0};  ///< quaternion (w, x, y, z), any length
  Vec3<double> position = zero3<double>(), velocity = position, spin = position, force = position, torque = position;

  Mat3<double> R_WB() const { return rotation_of<double>(turn); }
  Vec3<double> I_B() const { return cuboid_inertia<double>(mass, size); }
  Vec3<double> inverse_I_B() const { return cuboid_inverse_inertia<double>(I_B()); }
  Mat3<double> world_inertia() const { return rigor::world_inertia<double>(R_WB(), I_B()); }
  Mat3<double> world_inverse() const { return world_inverse_inertia<double>(R_WB(), inverse_I_B()); }
  double reach() const { return norm<double>(size) / 2; }  ///< bounding radius
};

/// Everything a case is made of; a check reads what it needs.
struct Scenario {
  Box A, B;
  Vec3<double> plane_point = zero3<double>();
  Vec3<double> normal{0, 1, 0};     ///< of the plane, or from A to B
  Vec3<double> point = zero3<double>();   ///< of a force or a contact
  Vec3<double> vector = zero3<double>();
  Constants constants;
  double h = 1.0 / 256;
  int variant = 0;                  ///< which of a check's kinds of case; fixed by the case number
};

/// Three different edges, inertia moments at least a factor 1.2 apart, m.
inline Vec3<double> draw_edges(Random& random) {
  const double a = grid(random, 0.5, 0.75), b = a * 2, c = b + grid(random, 0.75, 1.25);
  Vec3<double> s(a, b, c);
  for (int k = 2; k > 0; --k) std::swap(s[k], s[integer(random, 0, k)]);
  return s;
}
/// A turn of 0.5 to 1.3 rad about an axis with no small component.
inline Vec4<double> draw_turn(Random& random) {
  Vec4<double> q(integer(random, 5, 8), 0, 0, 0);
  for (int k = 1; k < 4; ++k) {
    const double s = sign(random);
    q[k] = s * integer(random, 1, 2);
  }
  return q;
}
/// A unit vector with no small component.
inline Vec3<double> draw_direction(Random& random) {
  const Vec3<double> a = arrow(random, 0.5, 1.5);
  return a / norm<double>(a);
}

/// A body with generic numbers: three edges, off the origin, moving and spinning; turned or with R = 1.
inline Box draw_box(Random& random, bool turned) {
  Box b;
  b.size = draw_edges(random);
  b.mass = grid(random, 1.25, 4);
  if (turned) b.turn = draw_turn(random);
  b.position = arrow(random, 1, 4);
  b.velocity = arrow(random, 0.5, 2);
  b.spin = arrow(random, 0.5, 1.5);
  return b;
}

/// State and loads as drawn, tensors consistent with size and mass.
inline BodyRecord record(const Box& b) {
  BodyRecord r = record(b.size, b.mass, {b.position, b.R_WB(), b.velocity, b.spin}, b.I_B(), b.inverse_I_B());
  put(r.net_force, b.force);
  put(r.net_torque, b.torque);
  return r;
}

inline Request request(Function function, const Scenario& s) {
  Request q{};
  q.magic = request_magic;
  q.function = std::uint32_t(function);
  q.count = 1;
  q.direct = 1;
  q.h = s.h;
  q.A = record(s.A);
  q.B = record(s.B);
  put(q.plane_point, s.plane_point);
  put(q.plane_normal, s.normal);
  put(q.point, s.point);
  put(q.vector, s.vector);
  return q;
}

}  // namespace rigor::grader
