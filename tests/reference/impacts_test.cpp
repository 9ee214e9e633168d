// The witnesses of impacts on closed forms and identities, and one against the other.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <reference/impacts.hpp>
#include <rigor/linalg/rotation.hpp>

namespace rigor::reference {
namespace {

using P = Precise;
using V = Vec3<double>;

Thrown<double> in_double(const Thrown<P>& s) {
  const auto number = [](const P& x) { return static_cast<double>(x); };
  return {s.p_WB.unaryExpr(number), s.v_WB.unaryExpr(number), s.w_WB.unaryExpr(number), s.R_WB.unaryExpr(number)};
}
double off(const P& a, const P& b) { return std::fabs(static_cast<double>(P(a - b))); }

// cases P-01, P-02: a cube that stands on its corner and spins about the vertical falls from height H below its corner. The
// impulse passes the centre, so it bounces as a point does, for ever on the same corner: t_n = t_1 (1 + 2e + ... + 2e^n).
TEST(Impacts, ACubeOnItsCornerBouncesInClosedForm) {
  for (const double e : {0.5, 0.75})
    for (const double mu : {0.0, 0.5}) {
      const Throw scene{{1, 1, 1}, 2, {0, -9.81, 0}, {{{0, 0, 0}, {0, 1, 0}}}, e, mu};
      Thrown<P> start{{P(0), P(1) + sqrt(P(3)) / 2, P(0)}, {P(0), P(0), P(0)}, {P(0), P(3), P(0)}, {}};
      const P root2 = sqrt(P(2)), root3 = sqrt(P(3)), root6 = sqrt(P(6));
      start.R_WB << 1 / root2, -1 / root2, P(0), 1 / root3, 1 / root3, 1 / root3, -1 / root6, -1 / root6, 2 / root6;
      const auto precise = precise_impacts(scene, start, 10, 5);
      const auto cvode = cvode_impacts(scene, in_double(start), 10, 5);
      ASSERT_TRUE(cvode);
      ASSERT_EQ(precise.size(), 5u);
      ASSERT_EQ(cvode->size(), 5u);
      const P t1 = sqrt(2 / P(9.81));
      P sum = t1, part = t1, speed = P(9.81) * t1;
      for (std::size_t n = 0; n < 5; ++n) {
        EXPECT_LT(off(precise[n].t, sum), 1e-40);
        EXPECT_LT(off(P((*cvode)[n].t), sum), 1e-12);
        speed *= P(e), part *= P(e), sum += 2 * part;
        EXPECT_LT(off(precise[n].after.v_WB[1], speed), 1e-40);
        EXPECT_LT(off(P((*cvode)[n].after.v_WB[1]), speed), 1e-12);
        EXPECT_LT(off(precise[n].after.w_WB[1], P(3)), 1e-40);
      }
    }
}

// case P-07: a slab that spins about a horizontal axis as it falls on an edge.
TEST(Impacts, ASpinningSlabLandsAtTheRootOfItsHeight) {
  const Throw scene{{1, 0.5, 2}, 3, {0, -9.81, 0}, {{{0, 0, 0}, {0, 1, 0}}}, 0.5, 0};
  const Thrown<P> start{{P(0), P(2), P(0)}, {P(0), P(0), P(0)}, {P(0), P(0), P(7)}, identity3<P>()};
  const auto precise = precise_impacts(scene, start, 2, 1);
  const auto cvode = cvode_impacts(scene, in_double(start), 2, 1);
  ASSERT_TRUE(cvode);
  const P t = precise[0].t, height = 2 - P(9.81) * t * t / 2 - abs(sin(7 * t)) / 2 - abs(cos(7 * t)) / 4;
  EXPECT_LT(off(height, P(0)), 1e-40);
  EXPECT_NEAR(static_cast<double>(t), 0.550155514682812044601547416719, 1e-15);
  EXPECT_LT(off(P((*cvode)[0].t), t), 1e-12);
}

TEST(Impacts, NothingIsHitByWhatFliesAway) {
  const Throw scene{{1, 1, 1}, 1, {0, 1, 0}, {{{0, -5, 0}, {0, 1, 0}}}, 0.5, 0};
  const Thrown<P> start{{P(0), P(0), P(0)}, {P(0), P(0), P(0)}, {P(1), P(2), P(3)}, identity3<P>()};
  EXPECT_TRUE(precise_impacts(scene, start, 0.5, 1).empty());
  const auto cvode = cvode_impacts(scene, in_double(start), 0.5, 1);
  ASSERT_TRUE(cvode);
  EXPECT_TRUE(cvode->empty());
  EXPECT_EQ(cvode_impacts(scene, in_double(start), 0.5, 1, 1e-16).fault().where, "tolerance");
}

// case P-05 and what stick and slide mean, on random poses: restitution, angular momentum about the contact, the energy that
// an impulse along n must take, and the tangential part that the law asks for.
TEST(Impacts, TheLawHasItsIdentities) {
  std::mt19937_64 random(20260414);
  std::normal_distribution<double> N;
  const auto vector = [&](double scale) {
    const double x = N(random), y = N(random), z = N(random);
    return Vec3<P>(P(scale * x), P(scale * y), P(scale * z));
  };
  int slid = 0, stuck = 0;
  for (int k = 0; k < 60; ++k) {
    const double mu = k % 3 == 0 ? 0 : k % 3 == 1 ? 0.05 : 4;
    const Throw scene{{0.5 + 0.01 * k, 0.75, 1.25}, 2, {0, 0, 0}, {}, 0.625, mu};
    const Thrown<P> before{vector(1), vector(3), vector(5), rotation_of<P>(Vec4<P>(P(N(random)), P(N(random)), P(N(random)), P(2)))};
    Vec3<P> r_B;
    for (int i = 0; i < 3; ++i) r_B[i] = P((k >> i) & 1 ? 0.5 : -0.5) * P(scene.size[i]);
    const Vec3<P> r = before.R_WB * r_B;
    V normal = V::Unit(k % 2);
    Vec3<P> n = normal.cast<P>();
    if (Vec3<P>(before.v_WB + before.w_WB.cross(r)).dot(n) > 0) normal = -normal, n = -n;
    const Thrown<P> after = struck<P>(scene, before, normal, r);
    const Vec3<P> u = before.v_WB + before.w_WB.cross(r), w = after.v_WB + after.w_WB.cross(r), j = 2 * Vec3<P>(after.v_WB - before.v_WB);
    EXPECT_LT(off(w.dot(n), P(-0.625) * u.dot(n)), 1e-50);
    // inertia from eight point masses at 1/sqrt 3 of the corners
    const auto angular = [&](const Thrown<P>& s) {
      Vec3<P> L = 2 * Vec3<P>(-r).cross(s.v_WB);
      for (int c = 0; c < 8; ++c) {
        Vec3<P> x_B;
        for (int i = 0; i < 3; ++i) x_B[i] = P((c >> i) & 1 ? 0.5 : -0.5) * P(scene.size[i]) / sqrt(P(3));
        const Vec3<P> x = before.R_WB * x_B;
        L += P(0.25) * x.cross(Vec3<P>(s.w_WB.cross(x)));
      }
      return L;
    };
    EXPECT_LT(static_cast<double>(Vec3<P>(angular(after) - angular(before)).norm()), 1e-50);
    const P along = j.dot(n);
    const Vec3<P> across = j - along * n, slip = u - u.dot(n) * n;
    EXPECT_GT(along, 0);
    if (mu == 0) {
      EXPECT_LT(static_cast<double>(across.norm()), 1e-50);
    } else if (Vec3<P>(w - w.dot(n) * n).norm() < P(1e-50)) {
      ++stuck;
      EXPECT_LE(across.norm(), P(mu) * along * (1 + P(1e-50)));
    } else {
      ++slid;
      EXPECT_LT(static_cast<double>(Vec3<P>(across + slip * (P(mu) * along / slip.norm())).norm()), 1e-50);
    }
  }
  EXPECT_GT(slid, 10);
  EXPECT_GT(stuck, 10);
}

// Twenty impacts of a tumbling cuboid in a room, CVODE restarted at each of the 60-digit witness and once from end to end.
TEST(Impacts, CvodeAgreesWithSixtyDigits) {
  for (const double mu : {0.0, 0.3}) {
    Throw scene{{0.5, 0.75, 1.25}, 2, {0, -9.8, 0}, {}, 0.75, mu};
    for (int i = 0; i < 3; ++i)
      for (const double side : {-1.0, 1.0}) scene.walls.push_back({V(side * 2.5 * V::Unit(i)), V(-side * V::Unit(i))});
    const Thrown<double> start{{0.5, 0.25, -1}, {6, 3, -7}, {2, -3, 1}, identity3<double>()};
    const std::size_t count = 20;
    const auto want = precise_impacts(scene, {start.p_WB.cast<P>(), start.v_WB.cast<P>(), start.w_WB.cast<P>(), identity3<P>()}, 60, count);
    ASSERT_EQ(want.size(), count);
    double worst_time = 0, worst_state = 0;
    Thrown<double> from = start;
    P began = 0;
    for (const auto& next : want) {
      const auto got = cvode_impacts(scene, from, 60, 1);
      ASSERT_TRUE(got);
      ASSERT_EQ(got->size(), 1u);
      EXPECT_EQ(got->front().wall, next.wall);
      worst_time = std::fmax(worst_time, off(P(got->front().t), next.t - began) / std::fmax(1, static_cast<double>(next.t - began)));
      const Thrown<double> there = in_double(next.before), &seen = got->front().before;
      const double v = there.v_WB.norm(), w = there.w_WB.norm();
      for (const double distance : {(seen.p_WB - there.p_WB).norm() / 2.5, (seen.v_WB - there.v_WB).norm() / v, (seen.w_WB - there.w_WB).norm() / w, (seen.R_WB - there.R_WB).norm()})
        worst_state = std::fmax(worst_state, distance);
      from = in_double(next.after), began = next.t;
    }
    const auto through = cvode_impacts(scene, start, 60, count);
    ASSERT_TRUE(through);
    ASSERT_EQ(through->size(), count);
    std::printf("impacts, CVODE against 60 digits, mu %.1f: %zu flights, time off by %.1e, state by %.1e; end to end (%.2f s) time off by %.1e\n", mu, count, worst_time, worst_state,
                static_cast<double>(want.back().t), off(P(through->back().t), want.back().t));
    EXPECT_LT(worst_time, 1e-12);
    EXPECT_LT(worst_state, 5e-12);
  }
}

}  // namespace
}  // namespace rigor::reference
