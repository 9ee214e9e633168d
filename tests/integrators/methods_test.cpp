#include <gtest/gtest.h>

#include <cmath>
#include <rigor/formulas/angular_acceleration.hpp>
#include <rigor/formulas/semi_implicit_step.hpp>
#include <rigor/formulas/world_inverse_inertia.hpp>
#include <rigor/integrators/runge_kutta.hpp>
#include <rigor/integrators/taylor.hpp>
#include <rigor/scalar/gamma.hpp>
#include <tests/integrators/laws.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;

const Cuboid<double> prism = *Cuboid<double>::make(2, {1, 1, 3});  // I1 = I2

const Method& method(const char* name) {
  const Method* found = find_method(name);
  EXPECT_NE(found, nullptr) << name;
  return *found;
}
template <class LoadAt>
State<double> fly(const char* name, const Cuboid<double>& body, const State<double>& start, double until, long steps, LoadAt load) {
  const Method& m = method(name);
  Motion now = motion_of(body, start);
  const double h = until / double(steps);
  for (long k = 0; k < steps; ++k) now = m.step(body, now, load(double(k) * h, now.state), h);
  return now.state;
}
const auto no_load = [](double, const State<double>&) { return Load{}; };

TEST(Methods, AreFoundByNameAndNotByAnother) {
  for (const Method& m : methods()) {
    EXPECT_EQ(find_method(m.name), &m);
    EXPECT_FALSE(m.source.empty());
  }
  EXPECT_EQ(find_method("sheets"), nullptr);
}

// case FB-01: without force a straight line; spin about a principal axis stays. Rounding only.
TEST(EveryMethod, FliesStraightAndKeepsAPrincipalSpin) {
  for (const Method& m : methods()) {
    State<double> s = tumbling();
    s.w_WB = 1.5 * s.R_WB.col(2);
    const State<double> end = fly(std::string(m.name).c_str(), plate, s, 2, 1000, no_load);
    EXPECT_LT(norm<double>(V(end.p_WB - s.p_WB - 2 * s.v_WB)), gamma_bound(2000) * 5) << m.name;
    EXPECT_EQ(end.v_WB, s.v_WB) << m.name;
    // the naive method stretches R across the axis by exp(h w^2 T/2) (case K-07), and the spin with it
    if (m.name != "euler-naive") {
      EXPECT_LT(norm<double>(V(end.w_WB - s.w_WB)), 1e-12) << m.name;
    }
  }
}

// cases D-01, D-02: free fall. Explicit Euler lags the parabola by g h T/2, the semi-implicit ones lead by as much.
TEST(FreeFall, LeadsOrLagsTheParabolaByHalfGHT) {
  const double T = 2, h = 0.01, g = -9.8;
  const auto weight = [&](double, const State<double>&) { return Load{V(0, plate.mass() * g, 0), zero3<double>()}; };
  const State<double> s = tumbling();
  const double parabola = s.p_WB[1] + T * s.v_WB[1] + g * T * T / 2, bound = gamma_bound(4 * 200) * 40;
  EXPECT_NEAR(fly("explicit-euler", plate, s, T, 200, weight).p_WB[1] - parabola, -g * h * T / 2, bound);
  for (const char* name : {"sheet", "euler-naive", "euler-exponential", "euler-momentum", "euler-momentum-cross"})
    EXPECT_NEAR(fly(name, plate, s, T, 200, weight).p_WB[1] - parabola, g * h * T / 2, bound) << name;
  EXPECT_NEAR(fly("rk4", plate, s, T, 200, weight).p_WB[1], parabola, bound);
}

// cases D-03, D-04: a linear spring on the centre, omega^2 = k/m.
TEST(Spring, ExplicitEulerGrowsByItsFactorAndSymplecticEulerKeepsItsModifiedEnergy) {
  const double k = 8, w2 = k / plate.mass(), h = 0.01;
  const long n = 500;
  const auto spring = [&](double, const State<double>& s) { return Load{V(-k * s.p_WB), zero3<double>()}; };
  State<double> s;
  s.p_WB = V(1, 0, 0);
  s.v_WB = V(0, 0.5, 0);
  const auto energy = [&](const State<double>& x) { return dot<double>(x.v_WB, x.v_WB) / 2 + w2 * dot<double>(x.p_WB, x.p_WB) / 2; };
  const double grown = energy(fly("explicit-euler", plate, s, n * h, n, spring)) / energy(s);
  EXPECT_NEAR(grown, std::pow(1 + h * h * w2, double(n)), 1e-12 * grown);
  const auto modified = [&](const State<double>& x) { return energy(x) - h * w2 * dot<double>(x.p_WB, x.v_WB) / 2; };  // kick, then drift
  EXPECT_NEAR(modified(fly("sheet", plate, s, n * h, n, spring)), modified(s), gamma_bound(8 * int(n)) * energy(s));
}

// case D-06: linear drag by explicit Euler: (1 - ch)^N, unstable beyond ch = 2.
TEST(Drag, ExplicitEulerMultipliesByOneMinusCh) {
  const double c = 3;
  const auto drag = [&](double, const State<double>& s) { return Load{V(-c * plate.mass() * s.v_WB), zero3<double>()}; };
  for (const double h : {0.1, 0.5, 0.8}) {  // the last: ch = 2.4
    const long n = 20;
    const double want = std::pow(1 - c * h, double(n));
    EXPECT_NEAR(fly("explicit-euler", plate, tumbling(), double(n) * h, n, drag).v_WB[1], want, 1e-12 * std::fabs(want) + 1e-15);
  }
}

// case D-08: L in world axes as the state stays the same to the bit, for ever.
TEST(MomentumForm, KeepsAngularMomentumToTheBit) {
  Motion now = motion_of(plate, tumbling());
  const V L = now.L_W;
  for (int k = 0; k < 20000; ++k) now = method("euler-momentum").step(plate, now, {}, 0.01);
  EXPECT_EQ(now.L_W, L);
  EXPECT_LT(orthonormality_defect<double>(now.state.R_WB), 1e-14);
}

// case D-12: a step of no length changes nothing.
TEST(EveryMethod, AStepOfNoLengthChangesNothing) {
  for (const Method& m : methods()) {
    const State<double> s = tumbling(), end = m.step(plate, motion_of(plate, s), {V(1, 2, 3), V(4, 5, 6)}, 0).state;
    EXPECT_EQ(end.p_WB, s.p_WB) << m.name;
    EXPECT_EQ(end.v_WB, s.v_WB) << m.name;
    EXPECT_LT(norm<double>(V(end.w_WB - s.w_WB)), 1e-14) << m.name;
    EXPECT_LT(angle_between<double>(end.R_WB, s.R_WB), 1e-14) << m.name;
  }
}

// Many steps in one call are the same map as step after step: where the body ends differs by roundings only.
TEST(EveryMethod, FliesInOneCallAsItStepsOneByOne) {
  int flown = 0;
  for (const Cuboid<double>& body : {plate, *Cuboid<double>::make(2, {2, 3, 1}), *Cuboid<double>::make(2, {3, 1, 2})})  // the middle axis in every place
    for (const Method& m : methods()) {
      if (m.fly == nullptr) continue;
      ++flown;
      for (const double h : {0.01, 0.7}) {  // short steps, and angles beyond the series
        const bool spin_form = m.conserves.empty() && m.order == 1;
        if (h > 0.1 && (m.conserves == "L, energy" || m.order > 8 || spin_form)) continue;  // no one answer, no convergence, or no numbers at so long a step
        const long steps = 40;
        Motion now = motion_of(body, tumbling());
        const Motion end = m.fly(body, now, h, steps);
        for (long k = 0; k < steps; ++k) now = m.step(body, now, {}, h);
        if (spin_form) {
          EXPECT_EQ(end.state.p_WB, now.state.p_WB) << m.name;
          EXPECT_EQ(end.state.R_WB, now.state.R_WB) << m.name;
          EXPECT_EQ(end.state.v_WB, now.state.v_WB) << m.name;
          EXPECT_EQ(end.state.w_WB, now.state.w_WB) << m.name;
          EXPECT_EQ(end.L_W, now.L_W) << m.name;
          continue;
        }
        const double bound = h < 0.1 ? 1e-13 : 1e-10;  // steps of a few u each; at the long ones their sum is grown by the flow
        EXPECT_LT(angle_between<double>(end.state.R_WB, now.state.R_WB), bound) << m.name << ", h " << h;
        EXPECT_LT(norm<double>(V(end.state.w_WB - now.state.w_WB)), bound) << m.name << ", h " << h;
        EXPECT_LT(norm<double>(V(end.state.p_WB - now.state.p_WB)), gamma_bound(400) * 200) << m.name;
        EXPECT_EQ(end.state.v_WB, now.state.v_WB) << m.name;
        if (m.conserves.find('L') != std::string_view::npos) {
          EXPECT_EQ(end.L_W, now.L_W) << m.name;
        }
      }
    }
  EXPECT_GE(flown, 3 * 23);
}

// The assignment's flight in one loop, against the formulas one by one: the same bits.
TEST(Sheet, FliesAsTheFormulasSay) {
  State<double> s = tumbling();
  const Motion end = method("sheet").fly(plate, motion_of(plate, s), 0.01, 500);
  for (int k = 0; k < 500; ++k) {
    const Mat3<double> I = world_inertia<double>(s.R_WB, plate.inertia()), inverse_I = world_inverse_inertia<double>(s.R_WB, plate.inverse_inertia());
    s = semi_implicit_step<double>(0.01, s, zero3<double>(), angular_acceleration<double>(I, inverse_I, s.w_WB, zero3<double>()));
  }
  EXPECT_EQ(end.state.p_WB, s.p_WB);
  EXPECT_EQ(end.state.R_WB, s.R_WB);
  EXPECT_EQ(end.state.v_WB, s.v_WB);
  EXPECT_EQ(end.state.w_WB, s.w_WB);
}

// case FB-12: a cube feels no gyroscopic torque.
TEST(EveryMethod, ACubeKeepsItsSpin) {
  const Cuboid<double> cube = *Cuboid<double>::make(2, {1.5, 1.5, 1.5});
  for (const Method& m : methods()) {
    if (m.name == "euler-naive") continue;  // its R is no rotation, so its inertia is no cube's
    const State<double> s = tumbling(), end = fly(std::string(m.name).c_str(), cube, s, 1, 200, no_load);
    EXPECT_LT(norm<double>(V(end.w_WB - s.w_WB)), 1e-12) << m.name;
  }
}

// The closed form of a square prism: body precession k w3, k = (I3 - I1)/I1, and space precession L/I1.
State<double> prism_at(const State<double>& s, double t) {
  const V I = prism.inertia(), w_B = apply_transposed<double>(s.R_WB, s.w_WB), L = motion_of(prism, s).L_W;
  const double rate = (I[2] - I[0]) / I[0] * w_B[2];
  State<double> end = s;
  end.R_WB = exp_so3<double>(V(t / I[0] * L)) * s.R_WB * exp_so3<double>(V(0, 0, -rate * t));
  end.w_WB = apply<double>(end.R_WB, V(w_B[0] * std::cos(rate * t) - w_B[1] * std::sin(rate * t), w_B[0] * std::sin(rate * t) + w_B[1] * std::cos(rate * t), w_B[2]));
  return end;
}
// case FB-03, with the observed order of each method over three halvings.
TEST(EveryMethod, ShowsItsOrderOnASquarePrism) {
  for (const Method& m : methods()) {
    const State<double> s = tumbling(), want = prism_at(s, 1);
    const auto error = [&](long n) { return angle_between<double>(fly(std::string(m.name).c_str(), prism, s, 1, n, no_load).R_WB, want.R_WB); };
    if (error(400) < 1e-12) continue;  // order 6 and above is at rounding; split2 turns a symmetric body exactly
    const double order = std::log2(error(200) / error(400));
    EXPECT_NEAR(order, m.order, 0.1) << m.name;
  }
}

// case FB-10: negate the velocities at T and fly back; a method of order p misses the start by order p, rk4 by little.
TEST(RungeKutta, FliesBackToWhereItCameFrom) {
  const State<double> s = tumbling();
  State<double> half = fly("rk4", plate, s, 2, 400, no_load);
  half.v_WB = -half.v_WB;
  half.w_WB = -half.w_WB;
  const State<double> back = fly("rk4", plate, half, 2, 400, no_load);
  EXPECT_LT(angle_between<double>(back.R_WB, s.R_WB), 1e-12);  // measured 4.2e-14: the way back undoes the leading error
  EXPECT_LT(norm<double>(V(back.p_WB - s.p_WB)), 1e-13);
}

// case FB-08: next to the middle axis the disturbance grows as exp(lambda t), lambda = w sqrt((I1-I2)(I2-I3)/(I1 I3)).
TEST(RungeKutta, LeavesTheMiddleAxisAtTheRateOfTheTennisRacket) {
  const V I = plate.inertia();  // falling from x to z
  State<double> s;
  const double w = 2, lambda = w * std::sqrt((I[0] - I[1]) * (I[1] - I[2]) / (I[0] * I[2]));
  // on the growing mode: w1/w3 = sqrt(I3 (I2 - I3) / (I1 (I1 - I2)))
  s.w_WB = V(1e-8 * std::sqrt(I[2] * (I[1] - I[2]) / (I[0] * (I[0] - I[1]))), w, 1e-8);
  const State<double> end = fly("rk4", plate, s, 6, 6000, no_load);
  const V w_B = apply_transposed<double>(end.R_WB, end.w_WB);
  const double rate = std::log(std::hypot(w_B[0], w_B[2]) / std::hypot(s.w_WB[0], s.w_WB[2])) / 6;
  EXPECT_NEAR(std::fabs(rate), lambda, 0.01 * lambda);
}

// case F-01: constant force and a constant torque about a principal axis, from rest.
TEST(EveryMethod, FollowsAConstantForceAndAPrincipalTorque) {
  for (const Method& m : methods()) {
    const auto push = [](double, const State<double>&) { return Load{V(2, -1, 3), V(0, 0, 1.5)}; };
    const State<double> end = fly(std::string(m.name).c_str(), plate, {}, 1, 2000, push);
    EXPECT_LT(norm<double>(V(end.p_WB - V(2, -1, 3) / plate.mass() / 2)), 2e-3) << m.name;  // h F T/(2 m)
    EXPECT_NEAR(end.w_WB[2], 1.5 / plate.inertia()[2], 1e-3) << m.name;
    if (m.name != "euler-naive") {
      EXPECT_NEAR(std::atan2(end.R_WB(1, 0), end.R_WB(0, 0)), 1.5 / plate.inertia()[2] / 2, 2e-3) << m.name;
    }
  }
}

// case F-02: a square prism under a constant axial torque held in body axes:
// w1 + i w2 = (w1 + i w2)_0 exp(-i k (w3_0 t + tau t^2/(2 I3))), k = (I1 - I3)/I1.
TEST(RungeKutta, FollowsAPrismUnderAnAxialTorque) {
  const double tau = 0.7, T = 1.5;
  State<double> s;
  s.w_WB = V(0.4, -0.3, 1.1);
  const auto axial = [&](double, const State<double>& x) { return Load{zero3<double>(), V(tau * x.R_WB.col(2))}; };
  const V I = prism.inertia();
  const double phase = -(I[0] - I[2]) / I[0] * (1.1 * T + tau * T * T / (2 * I[2]));
  const auto error = [&](long n) {
    const State<double> end = fly("rk4", prism, s, T, n, axial);
    const V w = apply_transposed<double>(end.R_WB, end.w_WB);
    const V want(0.4 * std::cos(phase) + 0.3 * std::sin(phase), 0.4 * std::sin(phase) - 0.3 * std::cos(phase), 1.1 + tau * T / I[2]);
    return norm<double>(V(w - want));
  };
  // the load is held in world axes over a step, so the torque's axis lags by half a step: order 1
  EXPECT_NEAR(std::log2(error(400) / error(800)), 1, 0.1);
  EXPECT_LT(error(6400), 1e-3);
}

// Twenty radians a step: the series is far from a rotation, its quaternion grows some hundredfold a step, and 160 steps
// at a time still turn as one at a time do.
TEST(Methods, TaylorKeepsItsQuaternionAmongTheNumbersOverLongSteps) {
  State<double> start;
  start.w_WB = V(0, 0, 20);
  for (const long steps : {16L, 160L}) {
    Motion one = motion_of(prism, start);
    const Motion all = fly_taylor16(prism, one, 1, steps);
    for (long k = 0; k < steps; ++k) one = step_taylor16(prism, one, {}, 1);
    EXPECT_LT((all.state.R_WB - one.state.R_WB).norm(), 1e-11) << steps;
  }
}

// A step whose quaternion leaves the numbers must not pass for no turn at all.
TEST(Methods, RungeKuttaTellsAStepThatLeavesTheNumbers) {
  State<double> start;
  start.w_WB = V(0, 0, 1);
  EXPECT_FALSE(step_rk4(prism, motion_of(prism, start), {}, 1e40).state.R_WB.allFinite());
}

// A free body's turning knows no length: with edges 2^66 (7e19) or 2^-66 times as long, and moments 2^132 times, it is the same, and by
// powers of two it is the same but for the order of operations. At 2^99 (6e29) too, near the longest edge of a scene.
TEST(Methods, TurnTheSameAtEverySize) {
  State<double> start;
  start.w_WB = V(1, 2, 3);
  for (const Method& m : methods()) {
    const auto turned = [&](double scale) {
      const auto body = *Cuboid<double>::make(2, V(scale * V(1, 0.5, 0.75)));
      Motion now = motion_of(body, start);
      for (int k = 0; k < 100; ++k) now = m.step(body, now, {}, 0.01);
      return now.state;
    };
    const State<double> one = turned(1);
    for (const int power : {66, -66, 99, -99}) {
      const State<double> s = turned(std::ldexp(1, power));
      ASSERT_TRUE(is_finite(s)) << m.name << ' ' << power;
      EXPECT_LT((s.R_WB - one.R_WB).cwiseAbs().maxCoeff(), 1e-13) << m.name << ' ' << power << ": roundings of a hundred steps of up to 0.04 rad";
    }
  }
}

}  // namespace
}  // namespace rigor
