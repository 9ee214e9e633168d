// Located impacts against a second method that shares nothing with them: attitudes by the 60-digit Taylor series, the
// parabola and the corner distances in the same digits, roots by the secant rule.
#include <gtest/gtest.h>

#include <cmath>
#include <reference/taylor.hpp>
#include <rigor/engine/located.hpp>
#include <rigor/linalg/rotation.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;
using P = reference::Precise;

struct PreciseState {
  Vec3<P> p, v, w;
  Mat3<P> R;
};
PreciseState precise_at(const Cuboid<double>& shape, const State<double>& from, const V& g, const P& t) {
  reference::FreeBody body{shape.inertia(), V(from.R_WB.transpose() * from.w_WB), from.R_WB};
  // the spin in body axes exactly as the product of the given numbers
  Vec3<P> w_B;
  for (int i = 0; i < 3; ++i) {
    w_B[i] = 0;
    for (int k = 0; k < 3; ++k) w_B[i] += P(from.R_WB(k, i)) * P(from.w_WB[k]);
  }
  const auto a = reference::taylor_free_body<P>(Vec3<P>(body.I_B.cast<P>()), w_B, Mat3<P>(from.R_WB.cast<P>()), t, 40, 0.05);
  PreciseState s;
  s.R = a.R_WB;
  for (int i = 0; i < 3; ++i) {
    s.p[i] = P(from.p_WB[i]) + t * (P(from.v_WB[i]) + t * P(g[i]) / 2);
    s.v[i] = P(from.v_WB[i]) + t * P(g[i]);
    s.w[i] = 0;
    for (int k = 0; k < 3; ++k) s.w[i] += a.R_WB(i, k) * a.w_B[k];
  }
  return s;
}
P lowest_gap(const Scene& scene, const PreciseState& s, int& which) {
  P lowest = 1000;
  for (std::size_t p = 0; p < scene.planes.size(); ++p) {
    const V n = scene.planes[p].normal(), at = scene.planes[p].point();
    P gap = 0, reach = 0;
    for (int i = 0; i < 3; ++i) gap += (s.p[i] - P(at[i])) * P(n[i]);
    for (int k = 0; k < 3; ++k) {
      P along = 0;
      for (int i = 0; i < 3; ++i) along += s.R(i, k) * P(n[i]);
      reach += abs(along) * P(scene.bodies[0].shape.size()[k]) / 2;
    }
    if (gap - reach < lowest) lowest = gap - reach, which = int(p);
  }
  return lowest;
}

void compare_impacts(double mu, double e, int impacts) {
  Scene s;
  s.method = "located";
  s.gravity = V(0, -9.8, 0);
  s.surface = *Surface<double>::make(e, mu, mu);
  s.friction_law = FrictionLaw::coulomb;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      V n = zero3<double>();
      n[axis] = -side;
      s.planes.push_back(*Plane<double>::make(V(-2 * n), n));
    }
  State<double> start;
  start.p_WB = V(0.1, 0.3, -0.2);
  start.R_WB = rotation_of<double>(Vec4<double>(1, 2, -1, 3));
  start.v_WB = V(2, 1, -3);
  start.w_WB = V(2, -3, 1);
  s.bodies = {{*Cuboid<double>::make(2, {0.5, 0.25, 1}), start}};
  s.until = 20;
  std::vector<LocatedImpact> seen;
  const auto done = simulate_located(s, [](double, const std::vector<State<double>>&) {}, [&](const LocatedImpact& i) { seen.push_back(i); });
  ASSERT_TRUE(done);
  ASSERT_GE(int(seen.size()), impacts);
  double worst_time = 0, worst_state = 0;
  for (int k = 0; k < impacts; ++k) {
    const LocatedImpact& i = seen[std::size_t(k)];
    const Cuboid<double>& shape = s.bodies[0].shape;
    int which = 0, other = 0;
    // no plane is met before: 6 moments of the segment (its first hundredth belongs to the impact it began with)
    for (int n = 0; n < 6; ++n) {
      const double t = i.tau * (0.01 + 0.98 * n / 5);
      EXPECT_GT(lowest_gap(s, precise_at(shape, i.from, s.gravity, P(t)), other), 0) << "impact " << k;
    }
    P t0 = P(i.tau), t1 = t0 - P(1e-9), g0 = lowest_gap(s, precise_at(shape, i.from, s.gravity, t0), which), g1 = lowest_gap(s, precise_at(shape, i.from, s.gravity, t1), which);
    for (int n = 0; n < 4 && g0 != g1; ++n) {
      const P t2 = t0 - g0 * (t0 - t1) / (g0 - g1);
      t1 = t0, g1 = g0;
      t0 = t2, g0 = lowest_gap(s, precise_at(shape, i.from, s.gravity, t0), which);
    }
    const PreciseState want = precise_at(shape, i.from, s.gravity, t0);
    worst_time = std::fmax(worst_time, std::fabs(double(P(i.tau) - t0)) / i.tau);
    for (int a = 0; a < 3; ++a) {
      worst_state = std::fmax(worst_state, std::fabs(double(P(i.before.p_WB[a]) - want.p[a])) / 2);
      worst_state = std::fmax(worst_state, std::fabs(double(P(i.before.v_WB[a]) - want.v[a])) / norm<double>(i.before.v_WB));
      worst_state = std::fmax(worst_state, std::fabs(double(P(i.before.w_WB[a]) - want.w[a])) / norm<double>(i.before.w_WB));
      for (int b = 0; b < 3; ++b) worst_state = std::fmax(worst_state, std::fabs(double(P(i.before.R_WB(a, b)) - want.R(a, b))));
    }
    // what the impact must keep: the law of restitution at the corner nearest to the plane, and the far corner's gap
    EXPECT_LT(std::fabs(double(g0)), 1e-25) << "the secant rule has converged";
  }
  std::printf("located, mu %.1f, e %.1f: %d impacts, time off by %.1e of the segment, state by %.1e\n", mu, e, impacts, worst_time, worst_state);
  EXPECT_LT(worst_time, 1e-11);
  EXPECT_LT(worst_state, 1e-11);
  EXPECT_GT(worst_state, 0) << "no difference at all would mean the reference is the engine";
}

TEST(LocatedOracle, TwentyFrictionlessImpactsOfATumblingCuboid) { compare_impacts(0, 1, 20); }
TEST(LocatedOracle, TwentyImpactsWithFriction) { compare_impacts(0.3, 0.9, 20); }

}  // namespace
}  // namespace rigor
