#include <gtest/gtest.h>

#include <rigor/formulas/angular_acceleration.hpp>
#include <rigor/formulas/force_sum.hpp>
#include <rigor/formulas/kinetic_energy.hpp>
#include <rigor/formulas/linear_acceleration.hpp>
#include <rigor/formulas/momentum.hpp>
#include <rigor/formulas/point_velocity.hpp>
#include <tests/exact/draw.hpp>
#include <tests/exact/dual.hpp>
#include <tests/exact/point_masses.hpp>

namespace rigor {
namespace {

std::vector<PointMass> points_of(const Body& body) {
  return point_masses(body.mass(), body.shape.size(), body.state.R_WB);
}

/// The velocity field of a rigid body, from the axioms of a rigid motion.
auto velocity_field(const Vec3<Q>& v, const Vec3<Q>& w) {
  return [v, w](const Vec3<Q>& p) { return Vec3<Q>(v + cross<Q>(w, p)); };
}

}  // namespace

// Two sets of forces are the same to a rigid body when they do the same work in every rigid motion.
// id: force.torque, force.sum
TEST(Wrench, DoesTheWorkOfTheForcesItSums) {
  Draw draw(11);
  for (int i = 0; i < draws; ++i) {
    const Vec3<Q> v = draw.vector(), w = draw.vector();
    Wrench<Q> sum;
    Q power = 0;
    for (int k = 0; k < 4; ++k) {
      const Vec3<Q> p = draw.vector(), f = draw.vector();
      sum = add_force<Q>(sum, p, f);
      power += f.dot(velocity_field(v, w)(p));
      EXPECT_EQ(torque_of_force<Q>(p, f).dot(w), f.dot(velocity_field(zero3<Q>(), w)(p)));
    }
    EXPECT_EQ(sum.f_W.dot(v) + sum.tau_W.dot(w), power);
  }
}

// id: motion.linear
TEST(LinearAcceleration, OfTheMassPointsAddsUpToTheForce) {
  Draw draw(12);
  for (int i = 0; i < draws; ++i) {
    const Body body = draw_body(draw);
    const Vec3<Q> f = draw.vector(), v_dot = linear_acceleration<Q>(body.shape.inverse_mass(), f);
    EXPECT_EQ(sum_of(points_of(body), [&](const Vec3<Q>&) { return v_dot; }), f);
  }
}

// The acceleration of a point of a rigid body is v̇ + ω̇ × p + ω × (ω × p); Newton's law for every mass point,
// internal forces along their lines, leaves Σ m p × a = τ.
// id: motion.euler
TEST(EulersEquation, GivesMassPointsAccelerationsWhoseMomentsAddUpToTheTorque) {
  Draw draw(13);
  for (int i = 0; i < draws; ++i) {
    const Body body = draw_body(draw);
    const Vec3<Q> tau = draw.vector(), w = body.state.w_WB;
    const Vec3<Q> w_dot = angular_acceleration<Q>(body.inertia(), body.at(zero3<Q>()).inverse_I_B_W, w, tau);
    const auto acceleration = [&](const Vec3<Q>& p) {
      return Vec3<Q>(cross<Q>(w_dot, p) + cross<Q>(w, cross<Q>(w, p)));
    };
    EXPECT_EQ(moment_of(points_of(body), acceleration), tau);
  }
}

// case D-07: E(w + h ẇ) = E + h ẇ·Iw + h²/2 ẇ·Iẇ and Iw·ẇ = −w·(w × Iw) = 0 without torque; the same with L².
TEST(EulersEquation, SteppedExplicitlyGainsEnergyByExactlyItsSecondOrderTerm) {
  Draw draw(14);
  for (int i = 0; i < draws; ++i) {
    const Body body = draw_body(draw);
    const Vec3<Q> moments = body.shape.inertia(), w = body.state.w_WB;
    const Mat3<Q> I = world_inertia<Q>(identity3<Q>(), moments);  // body axes
    const Mat3<Q> inverse = world_inverse_inertia<Q>(identity3<Q>(), body.shape.inverse_inertia());
    const Q h = draw.positive();
    const Vec3<Q> rate = angular_acceleration<Q>(I, inverse, w, zero3<Q>()), next = w + h * rate;
    const auto energy = [&](const Vec3<Q>& a) { return kinetic_energy<Q>(body.mass(), I, zero3<Q>(), a); };
    EXPECT_EQ(energy(next) - energy(w), h * h * energy(rate));
    EXPECT_GT(energy(next), energy(w));
    const Vec3<Q> L = I * w, L_next = I * next, L_rate = I * rate;
    EXPECT_EQ(L_next.dot(L_next) - L.dot(L), h * h * L_rate.dot(L_rate));
  }
}

// case FB-12, over the rationals: a cube has no gyroscopic torque.
TEST(EulersEquation, LeavesTheSpinOfACubeAlone) {
  Draw draw(15);
  for (int i = 0; i < draws; ++i) {
    const Q edge = draw.positive(), m = draw.positive();
    const auto cube = *Cuboid<Q>::make(m, Vec3<Q>(edge, edge, edge));
    const Mat3<Q> R = draw.rotation();
    const Vec3<Q> w_dot = angular_acceleration<Q>(world_inertia<Q>(R, cube.inertia()),
                                                  world_inverse_inertia<Q>(R, cube.inverse_inertia()),
                                                  draw.vector(), zero3<Q>());
    EXPECT_EQ(w_dot, zero3<Q>());
  }
}

// R(t) along a straight line of quaternions q + t q̇ turns with ω = 2 vec(q̇ q̄)/|q|²; the exact derivative of
// p + R p_BC_B is the velocity of the point. case K-06, with the derivative taken exactly.
// id: motion.point_velocity
TEST(PointVelocity, IsTheDerivativeOfThePointsPosition) {
  Draw draw(16);
  for (int i = 0; i < draws; ++i) {
    const Q s = draw.number(), s_dot = draw.number();
    const Vec3<Q> u = draw.vector(), u_dot = draw.vector();
    const Vec4<Q> q(s, u[0], u[1], u[2]), q_dot(s_dot, u_dot[0], u_dot[1], u_dot[2]);
    const Vec3<Q> w = (s * u_dot - s_dot * u - cross<Q>(u_dot, u)) * (Q(2) / q.dot(q));
    const Mat3<Dual> R = rotation_of<Dual>(moving<4>(q, q_dot));
    const Vec3<Q> p = draw.vector(), v = draw.vector(), p_BC_B = draw.vector();
    const Vec3<Dual> turned = apply<Dual>(R, moving<3>(p_BC_B, zero3<Q>())), centre = moving<3>(p, v);
    Vec3<Q> rate, p_BC_W;
    for (int k = 0; k < 3; ++k) rate[k] = (centre[k] + turned[k]).slope, p_BC_W[k] = turned[k].value;
    EXPECT_EQ(point_velocity<Q>(v, w, p_BC_W), rate);
  }
}

// König's theorem against the sum over the mass points.
// id: energy.kinetic
TEST(KineticEnergy, IsThatOfTheMassPoints) {
  Draw draw(17);
  for (int i = 0; i < draws; ++i) {
    const Body body = draw_body(draw);
    const auto& [p, R, v, w] = body.state;
    EXPECT_EQ(kinetic_energy<Q>(body.mass(), body.inertia(), v, w),
              half_square_of(points_of(body), velocity_field(v, w)));
  }
}

// case F-10 in its differential form: dT/dt = F·v + τ·ω, with the inertia turning along.
TEST(KineticEnergy, GrowsByThePowerOfTheForces) {
  Draw draw(18);
  for (int i = 0; i < draws; ++i) {
    const Body body = draw_body(draw);
    const Vec3<Q> f = draw.vector(), tau = draw.vector(), &v = body.state.v_WB, &w = body.state.w_WB;
    const Mat3<Q> I = body.inertia();
    const Vec3<Q> v_dot = linear_acceleration<Q>(body.shape.inverse_mass(), f);
    const Vec3<Q> w_dot = angular_acceleration<Q>(I, body.at(zero3<Q>()).inverse_I_B_W, w, tau);
    const Mat3<Q> W = skew<Q>(w), I_dot = W * I - I * W;
    Mat3<Dual> moving_I;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) moving_I(a, b) = Dual(I(a, b), I_dot(a, b));
    const Dual T =
        kinetic_energy<Dual>(Dual(body.mass(), 0), moving_I, moving<3>(v, v_dot), moving<3>(w, w_dot));
    EXPECT_EQ(T.slope, f.dot(v) + tau.dot(w));
  }
}

// id: momentum.linear, momentum.angular
TEST(Momentum, IsThatOfTheMassPoints) {
  Draw draw(19);
  for (int i = 0; i < draws; ++i) {
    const Body body = draw_body(draw);
    const auto& [p, R, v, w] = body.state;
    const Vec3<Q> p_WO = draw.vector();
    const auto field = velocity_field(v, w);
    EXPECT_EQ(linear_momentum<Q>(body.mass(), v), sum_of(points_of(body), field));
    const Vec3<Q> arm = p - p_WO;
    Vec3<Q> about_O = zero3<Q>();
    for (const PointMass& point : points_of(body))
      about_O += point.mass * cross<Q>(Vec3<Q>(arm + point.p_BP_W), field(point.p_BP_W));
    EXPECT_EQ(angular_momentum<Q>(body.mass(), body.inertia(), p, v, w, p_WO), about_O);
  }
}

}  // namespace rigor
