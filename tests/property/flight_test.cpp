#include <rigor/integrators/method.hpp>
#include <tests/property/generators.hpp>

// What every fixed-step method must do whatever its order: properties of the free and of the pushed body.
namespace rigor {
namespace {

Cuboid<double> shape_of(const Body<double>& body) { return *Cuboid<double>::make(body.m, body.s_B); }

/// One body and a load, from the generator's numbers: the load from the second body's.
struct Flight {
  Cuboid<double> shape;
  Motion start;
  Load load;
  double h;
};

Flight flight_of(const Numbers& numbers, int halvings) {
  const Body<double> a = numbers.body<double>(0), b = numbers.body<double>(1);
  const Cuboid<double> shape = shape_of(a);
  return {shape, motion_of(shape, a.state), {b.state.v_WB, b.state.w_WB}, std::ldexp(1, -halvings)};
}

Motion fly(const Method& method, const Flight& f, int steps) {
  Motion m = f.start;
  for (int i = 0; i < steps; ++i) m = method.step(f.shape, m, f.load, f.h);
  return m;
}

Vec3<double> scaled(Vec3<double> a, int k) {
  for (int i = 0; i < 3; ++i) a[i] = std::ldexp(a[i], k);
  return a;
}

}  // namespace

// case S-01: a change of units by powers of two changes no significand, in any method: h ω and R have no
// unit.
RC_GTEST_PROP(EveryMethod, HasTheSameSignificandsInUnitsOfPowersOfTwo, (const Numbers& numbers)) {
  const int length = *rc::gen::inRange(-27, 28), mass = *rc::gen::inRange(-27, 28),
            time = *rc::gen::inRange(-27, 28);
  const Flight f = flight_of(numbers, 8);
  Flight g = f;
  g.shape = *Cuboid<double>::make(std::ldexp(f.shape.mass(), mass), scaled(f.shape.size(), length));
  State<double>& s = g.start.state;
  s.p_WB = scaled(s.p_WB, length), s.v_WB = scaled(s.v_WB, length - time), s.w_WB = scaled(s.w_WB, -time);
  g.start = motion_of(g.shape, s);
  g.load = {scaled(f.load.f_W, mass + length - 2 * time), scaled(f.load.tau_W, mass + 2 * length - 2 * time)};
  g.h = std::ldexp(f.h, time);
  for (const Method& method : methods()) {
    const Motion x = fly(method, f, 5), y = fly(method, g, 5);
    RC_ASSERT(y.state.p_WB == scaled(x.state.p_WB, length));
    RC_ASSERT(y.state.v_WB == scaled(x.state.v_WB, length - time));
    RC_ASSERT(y.state.w_WB == scaled(x.state.w_WB, -time));
    RC_ASSERT(y.state.R_WB == x.state.R_WB);
    RC_ASSERT(y.L_W == scaled(x.L_W, mass + 2 * length - time));
  }
}

// case FB-11: the centre of mass and the attitude do not know of each other: another place and another
// velocity change no bit of the attitude, another attitude and spin no bit of the path.
RC_GTEST_PROP(EveryMethod, KeepsPathAndAttitudeApart, (const Numbers& numbers)) {
  const Flight f = flight_of(numbers, 6);
  Flight moved = f, turned = f;
  moved.start.state.p_WB += Vec3<double>(3, -5, 7);
  moved.start.state.v_WB += Vec3<double>(-1, 2, 0.5);
  State<double> s = f.start.state;
  s.R_WB = rotation_of<double>(Vec4<double>(2, -1, 3, 1)), s.w_WB = Vec3<double>(1, -2, 3);
  turned.start = motion_of(f.shape, s);
  for (const Method& method : methods()) {
    const Motion x = fly(method, f, 5), y = fly(method, moved, 5), z = fly(method, turned, 5);
    RC_ASSERT(x.state.R_WB == y.state.R_WB && x.state.w_WB == y.state.w_WB);
    RC_ASSERT(x.state.p_WB == z.state.p_WB && x.state.v_WB == z.state.v_WB);
  }
}

// case FB-11: the world turned by Q turns the flight. Gram-Schmidt favours a body axis, not a world one, so
// this holds for the repaired methods too. Rounding: a few hundred operations a step on numbers of the size
// of the largest.
RC_GTEST_PROP(EveryMethod, TurnsWithTheWorld, (const Numbers& numbers)) {
  const Flight f = flight_of(numbers, 8);
  const Mat3<double> Q = rotation_of<double>(Vec4<double>(1, 2, -1, 3));
  Flight g = f;
  State<double> s = f.start.state;
  s.R_WB = Q * s.R_WB, s.p_WB = Q * s.p_WB, s.v_WB = Q * s.v_WB, s.w_WB = Q * s.w_WB;
  g.start = motion_of(f.shape, s);
  g.load = {Q * f.load.f_W, Q * f.load.tau_W};
  const double condition = f.shape.inertia().maxCoeff() / f.shape.inertia().minCoeff();
  for (const Method& method : methods()) {
    const Motion x = fly(method, f, 5), y = fly(method, g, 5);
    const double reach = 1 + norm<double>(f.start.state.w_WB) + norm<double>(x.state.w_WB) +
                         norm<double>(f.load.tau_W) * f.h / f.shape.inertia().minCoeff();
    const double bound = 5 * 200 * unit_roundoff<double>() * condition * reach;
    RC_ASSERT(norm<double>(Q * x.state.w_WB - y.state.w_WB) <= bound * reach);
    RC_ASSERT((Q * x.state.R_WB - y.state.R_WB).norm() <= bound * reach);
  }
}

// Without load, and with one, L changes by h τ a step in the momentum form: to the bit. case D-08
TEST(MomentumForm, KeepsTheAngularMomentumToTheBit) {
  const Cuboid<double> box = *Cuboid<double>::make(10, {0.1, 0.4, 0.9});
  State<double> s;
  s.R_WB = rotation_of<double>(Vec4<double>(1, 2, -1, 3));
  s.w_WB = Vec3<double>(0.1, 5, 0.1);
  const Flight f{box, motion_of(box, s), {}, 0.01};
  for (const char* name : {"euler-momentum", "euler-momentum-cross", "euler-momentum-exponential"}) EXPECT_EQ(fly(*find_method(name), f, 100000).L_W, f.start.L_W) << name;
  EXPECT_NE(fly(*find_method("sheet"), f, 100).L_W, f.start.L_W);  // the comparison can fail
}

// case D-01, D-02: n steps of free fall against the parabola: explicit Euler lags by g t h/2, the methods
// that move with the new velocity lead by it, Runge-Kutta is on it. Rounding: two operations a step on
// numbers below 2^7 m.
TEST(EveryMethod, FallsAsItsClosedFormSays) {
  const Cuboid<double> box = *Cuboid<double>::make(2, {1, 2, 3});
  State<double> s;
  s.p_WB = Vec3<double>(0, 10, 0), s.v_WB = Vec3<double>(3, 1, -2);
  const double g = -9.8, h = 1.0 / 64;
  const int n = 256;
  const double t = n * h, bound = n * 3 * unit_roundoff<double>() * 128;
  const Flight f{box, motion_of(box, s), {Vec3<double>(0, 2 * g, 0), zero3<double>()}, h};
  for (const Method& method : methods()) {
    const double sign = method.name == "explicit-euler" ? -1 : method.order > 1 ? 0 : 1;
    const State<double> end = fly(method, f, n).state;
    EXPECT_NEAR(end.p_WB[1], 10 + t + g * t * t / 2 + sign * g * t * h / 2, bound) << method.name;
    EXPECT_NEAR(end.p_WB[0], 3 * t, bound) << method.name;
    EXPECT_NEAR(end.v_WB[1], 1 + g * t, bound) << method.name;
    EXPECT_EQ(end.R_WB, s.R_WB) << method.name;  // no torque, no spin
  }
  EXPECT_GT(std::abs(g * t * h / 2), 1e9 * bound);  // the lead is what was measured
}

// case FB-01, FB-12: no load. A straight line; spin about a principal axis stays, and any spin of a cube.
TEST(EveryMethod, KeepsSpinAboutAPrincipalAxisAndOfACube) {
  const double h = 1.0 / 128;
  const int n = 512;
  for (const bool cube : {false, true}) {
    const Cuboid<double> box = *Cuboid<double>::make(2, cube ? Vec3<double>(1, 1, 1) : Vec3<double>(1, 2, 3));
    State<double> s;
    s.R_WB = rotation_of<double>(Vec4<double>(1, 2, -1, 3));
    s.v_WB = Vec3<double>(1, -2, 0.5);
    s.w_WB = cube ? Vec3<double>(0.7, -1.1, 0.4) : Vec3<double>(1.5 * s.R_WB.col(2));
    for (const Method& method : methods()) {
      if (method.name == "euler-naive")
        continue;  // its R is no rotation, so what it takes for the inertia is none
      const State<double> end = fly(method, {box, motion_of(box, s), {}, h}, n).state;
      // Rounding leaves ω and the axis some 10 u a step apart; about an extreme axis that does not grow.
      EXPECT_LE((end.w_WB - s.w_WB).norm(), n * 32 * unit_roundoff<double>()) << method.name;
      EXPECT_LE((end.p_WB - n * h * s.v_WB).norm(), n * 8 * unit_roundoff<double>() * 8) << method.name;
    }
  }
}

}  // namespace rigor
