// The bounds that the searches for impacts rest on, against the motion itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <rigor/engine/flight.hpp>
#include <rigor/formulas/angular_acceleration.hpp>
#include <rigor/formulas/world_inertia.hpp>
#include <rigor/formulas/world_inverse_inertia.hpp>
#include <rigor/linalg/rotation.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;

/// |α × r + ω × (ω × r)| of a free body, by Euler's equation.
double acceleration(const Cuboid<double>& body, const State<double>& s, const V& r) {
  const V alpha = angular_acceleration<double>(world_inertia<double>(s.R_WB, body.inertia()), world_inverse_inertia<double>(s.R_WB, body.inverse_inertia()), s.w_WB, zero3<double>());
  return norm<double>(V(cross<double>(alpha, r) + cross<double>(s.w_WB, cross<double>(s.w_WB, r))));
}

TEST(Flight, BoundsItsSpinAndTheAccelerationOfItsCorners) {
  const Mat3<double> R = rotation_of<double>(Vec4<double>(1, 2, -1, 3));
  double idle = 0, idle_acceleration = 0;
  for (const V& size : {V(1, 2, 3), V(3, 0.1, 2), V(0.2, 5, 0.3), V(1, 1, 1)})
    for (const V& w_B : {V(1, 0, 0), V(0, 1, 0), V(0, 0, 1), V(0.3, -1, 0.7), V(1e-6, 1, 1e-6), V(5, 0.01, -4)}) {
      const auto body = *Cuboid<double>::make(2, size);
      State<double> s;
      s.p_WB = V(1, -2, 3), s.R_WB = R, s.v_WB = V(0.5, 1, -0.25), s.w_WB = V(R * w_B);
      const Flight flight(body, s, V(0, -9.81, 0));
      double spin = 0, worst = 0;
      for (int k = 0; k <= 400; ++k) {
        const State<double> now = flight.at(0.05 * k);
        spin = std::fmax(spin, norm<double>(now.w_WB));
        for (int corner = 0; corner < 8; ++corner) {
          const V r = apply<double>(now.R_WB, body.corner(corner));
          worst = std::fmax(worst, acceleration(body, now, r) / norm<double>(r));
        }
      }
      EXPECT_LE(spin, flight.spin_bound()) << size.transpose() << "; " << w_B.transpose();
      EXPECT_LE(worst, flight.acceleration_bound(1));
      EXPECT_EQ(flight.acceleration_bound(3), 3 * flight.acceleration_bound(1));
      idle = std::fmax(idle, spin / flight.spin_bound());
      idle_acceleration = std::fmax(idle_acceleration, worst / flight.acceleration_bound(1));
    }
  EXPECT_GT(idle, 1 - 1e-11) << "reached by a spin about the axis of the least moment";
  EXPECT_GT(idle_acceleration, 0.5) << "not idle";
}

// Half a diagonal 7/2 that turns by 1/8 (about the axis of the least moment, where the bound on the spin is the spin),
// |p| = 1 + 2 + 4, |v| τ = 56/4 and |a| τ²/2 = 3.5/32, each a sum over the axes.
TEST(Flight, RoundingIsSixteenUnitsOfTheTermsOfACornersPlace) {
  const auto body = *Cuboid<double>::make(2, {2, 3, 6});
  State<double> s;
  s.p_WB = V(1, -2, 4), s.v_WB = V(8, -16, 32), s.w_WB = V(0, 0, 0.5);
  const Flight flight(body, s, V(0.5, -1, 2));
  const double terms = 3.5 * (1 + 0.125) + 7 + 14 + 0.109375;
  EXPECT_NEAR(flight.rounding(0.25) / (16 * 0x1p-53 * terms), 1, 1e-11);  // the spin's bound is 1e-12 above it
}

}  // namespace
}  // namespace rigor
