#pragma once
// Random courses of two cuboids thrown at each other. Draws stand in braces or in statements of their own: from left to
// right with every compiler.
#include <random>
#include <rigor/bodies/cuboid.hpp>
#include <rigor/linalg/rotation.hpp>

namespace rigor {

using V = Vec3<double>;

struct Draw {
  std::mt19937_64 random{20260414};
  double in(double low, double high) { return low + (high - low) * (double(random() >> 11) * 0x1p-53); }
  V sizes(double low, double high) { return V{in(low, high), in(low, high), in(low, high)}; }
  Cuboid<double> cuboid(double lightest, double heaviest, double low, double high) {
    const double mass = in(lightest, heaviest);
    return *Cuboid<double>::make(mass, sizes(low, high));
  }
  V vector(double size) { return V{in(-size, size), in(-size, size), in(-size, size)}; }
  Mat3<double> rotation() {
    std::normal_distribution<double> N;
    return rotation_of<double>(Vec4<double>{N(random), N(random), N(random), N(random)});
  }
};
struct Course {
  Cuboid<double> A, B;
  State<double> a, b;
};
inline Course course(Draw& draw) {
  Course c{draw.cuboid(0.5, 5, 0.1, 1), draw.cuboid(0.5, 5, 0.1, 1), {}, {}};
  c.a.R_WB = draw.rotation(), c.b.R_WB = draw.rotation();
  c.a.w_WB = draw.vector(6), c.b.w_WB = draw.vector(6);
  c.a.p_WB = draw.vector(1);
  V towards = draw.vector(1);
  towards /= norm<double>(towards);
  c.b.p_WB = c.a.p_WB + 3 * towards;
  c.a.v_WB = draw.vector(0.5);
  const double speed = draw.in(0.5, 8);
  c.b.v_WB = c.a.v_WB - speed * towards + draw.vector(0.6);
  return c;
}

}  // namespace rigor
