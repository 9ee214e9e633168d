// How far the searches for impacts go at once: the bounds of their docstrings, computed another way. The first advance is the limit
// at which a search that ended without one begins to make one; it is found by halving.
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <rigor/engine/pair_search.hpp>
#include <rigor/engine/plane_search.hpp>
#include <rigor/linalg/rotation.hpp>
#include <tuple>

#include "pair_courses.hpp"

namespace rigor {
namespace {

using X = long double;
using W3 = Vec3<X>;

// Least of the positive roots of s + r δ + c δ²/2, by the formula of school; s ≥ 0 > c.
X root(X s, X r, X c) { return (r + std::sqrt(r * r - 2 * c * s)) / -c; }

// The largest limit up to which `search` needs no advance.
double first_advance(double from, double longest, const std::function<long(double)>& search) {
  double low = from, high = from + longest;
  EXPECT_EQ(search(low), 0);
  EXPECT_GT(search(high), 0);
  for (int k = 0; k < 80; ++k) (search((low + high) / 2) == 0 ? low : high) = (low + high) / 2;
  return low - from;
}

struct Witness {
  W3 half, I, p, v, w, a;
  Mat3<X> R;
  X mass, r, W;  // half a diagonal, m; bound on the spin, rad/s
  Witness(const Cuboid<double>& shape, const State<double>& s, const V& pull)
      : half(shape.size().cast<X>() / 2), p(s.p_WB.cast<X>()), v(s.v_WB.cast<X>()), w(s.w_WB.cast<X>()), a(pull.cast<X>()), R(s.R_WB.cast<X>()), mass(shape.mass()), r(half.norm()) {
    for (int k = 0; k < 3; ++k) I[k] = mass * (half[(k + 1) % 3] * half[(k + 1) % 3] + half[(k + 2) % 3] * half[(k + 2) % 3]) / 3;
    const W3 w_B = R.transpose() * w, L_B = I.cwiseProduct(w_B);
    W = std::sqrt(L_B.dot(w_B) / I.minCoeff());
  }
  W3 arm(int k) const { return R * W3(k & 1 ? half[0] : -half[0], k & 2 ? half[1] : -half[1], k & 4 ? half[2] : -half[2]); }
  W3 velocity(int k) const { return v + w.cross(arm(k)); }
  // of corner k, from I ω' = −ω × I ω in world axes
  W3 acceleration(int k) const {
    const Mat3<X> I_W = R * I.asDiagonal() * R.transpose();
    const W3 alpha = -(I_W.inverse() * w.cross(I_W * w));
    return a + alpha.cross(arm(k)) + w.cross(w.cross(arm(k)));
  }
};
const X k_bound = 1 + 1 / std::sqrt(3.0L);

struct Approach {
  Cuboid<double> shape = *Cuboid<double>::make(2, {1, 2, 3});
  State<double> s;
  V pull{0.5, -1, 0.25};
  Plane<double> plane = *Plane<double>::make(V(0.2, -0.1, 0.3), V(2, 1, -2) / 3);
  Approach() {
    s.R_WB = rotation_of<double>(Vec4<double>(1, 2, -1, 3));
    s.v_WB = V(-1, 0.5, 0.25), s.w_WB = V(0.7, -1.1, 0.4);
    s.p_WB = plane.point() + V(0.4, -0.3, 0.7) + 2.5 * plane.normal();
  }
  Witness body() const { return Witness(shape, s, pull); }
  X gap(const Witness& b, int k) const { return plane.normal().cast<X>().dot(b.p + b.arm(k) - plane.point().cast<X>()); }
  int lowest() const {
    int found = 0;
    for (int k = 1; k < 8; ++k)
      if (gap(body(), k) < gap(body(), found)) found = k;
    return found;
  }
  double advance(double longest, double from = 0) const {
    const Flight flight(shape, s, pull);
    return first_advance(from, longest, [&](double limit) { return next_plane_contact(shape, flight, plane, from, limit).advances; });
  }
};

// s + r δ + (n·a − Ω) δ²/2 of each corner, Ω = (1 + 1/√3) W² |r|.
TEST(PlaneAdvance, IsTheLeastOfEightCorners) {
  for (const double pull : {-1.0, 3.0}) {
    Approach m;
    m.pull *= pull;
    const Witness b = m.body();
    const W3 n = m.plane.normal().cast<X>();
    X want = 1e9;
    for (int k = 0; k < 8; ++k) want = std::min(want, root(m.gap(b, k), n.dot(b.velocity(k)), n.dot(b.a) - k_bound * b.W * b.W * b.r));
    EXPECT_NEAR(m.advance(5) / double(want), 1, 1e-12) << pull;  // what the bound on the spin has to spare
  }
}
// The same from a moment on the way.
TEST(PlaneAdvance, CountsFromWhereTheSearchBegins) {
  Approach m;
  const State<double> later = Flight(m.shape, m.s, m.pull).at(0.125);
  Approach on_the_way = m;
  on_the_way.s = later;
  EXPECT_NEAR(m.advance(5, 0.125) / on_the_way.advance(5), 1, 1e-12);  // the two bounds on the spin, each with 1e-12 to spare
}
// Far away it is the sphere's, on its parabola.
TEST(PlaneAdvance, IsTheSpheresFromFarAway) {
  for (const auto& [pull, away, speed] : {std::tuple{-2.0, 40.0, 9.0}, std::tuple{0.5, 40.0, 9.0}, std::tuple{-2.0, 0.25, 0.1}}) {
    Approach m;
    const double gap = dot<double>(m.plane.normal(), V(m.s.p_WB - m.plane.point())) - norm<double>(m.shape.size()) / 2;
    m.s.p_WB += (away - gap) * m.plane.normal();
    m.s.w_WB *= 50;
    m.pull = pull * m.plane.normal();
    m.s.v_WB = V(0.5, 0, 0.5) - speed * m.plane.normal();
    const Witness b = m.body();
    const W3 n = m.plane.normal().cast<X>();
    const X s = n.dot(b.p - m.plane.point().cast<X>()) - b.r, r = n.dot(b.v), c = n.dot(b.a);
    const X want = (-r - std::sqrt(r * r - 2 * c * s)) / c;
    EXPECT_NEAR(m.advance(10) / double(want), 1, 1e-12) << pull;
  }
}
// A corner that has just been hit leaves with rate r: 2r/(Ω − n·a). One that touches without a rate and is accelerated away by b:
// 3b/J, J = 5 |r| W³.
TEST(PlaneAdvance, OfACornerThatTouches) {
  for (const auto& [leave, spin, press] : {std::tuple{0.25, 1.0, 0.03}, std::tuple{0.0, 1.0, 0.03}, std::tuple{0.0, 0.1, 1e-5}}) {
    Approach m;
    m.s.w_WB *= spin;
    const int k = m.lowest();
    const V n = m.plane.normal(), arm = apply<double>(m.s.R_WB, m.shape.corner(k));
    m.s.p_WB -= double(m.gap(m.body(), k)) * n;
    m.s.v_WB = leave * n - cross<double>(m.s.w_WB, arm);
    m.pull = V(m.pull + (press - double(n.cast<X>().dot(m.body().acceleration(k)))) * n);  // so much in m/s² away
    const Witness b = m.body();
    const W3 N = n.cast<X>();
    const X omega = k_bound * b.W * b.W * b.r, away = N.dot(b.acceleration(k));
    ASSERT_NEAR(double(away), press, 1e-14);
    X want = leave > 0 ? 2 * N.dot(b.velocity(k)) / (omega - N.dot(b.a)) : 3 * away / (5 * b.r * b.W * b.W * b.W);
    for (int other = 0; other < 8; ++other)
      ASSERT_TRUE(other == k || root(m.gap(b, other), N.dot(b.velocity(other)), N.dot(b.a) - omega) > want) << other;
    EXPECT_NEAR(m.advance(5) / double(want), 1, 1e-9) << leave << ", " << spin;  // the rounding of `away`
  }
}

// The bounds of next_pair_contact's docstring over 15 axes and 64 pairs of corners each; D and V hold for as long as the distance
// of the centres could have grown by half the sizes.
X pair_advance(const Witness& A, const Witness& B) {
  const W3 d = B.p - A.p, v = B.v - A.v;
  const X pull = (B.a - A.a).norm(), fastest = v.norm() + A.W * A.r + B.W * B.r;
  // (r_A + r_B)/2 covered at `fastest` and with `pull`
  const X longest = pull > 0 ? (std::sqrt(fastest * fastest + pull * (A.r + B.r)) - fastest) / pull : (A.r + B.r) / 2 / fastest;
  const X D = d.norm() + 1.5L * (A.r + B.r), V = fastest + pull * longest;
  const X rest = k_bound * (A.W * A.W * A.r + B.W * B.W * B.r) + pull;
  X best = 0;
  const auto axis = [&](W3 N, W3 N1, X bound1, X bound2) {
    if (N.norm() < 1e-8L) return;
    if (N.dot(d) < 0) N = -N, N1 = -N1;
    X least = longest;
    for (int i = 0; i < 8; ++i)
      for (int j = 0; j < 8; ++j) {
        const W3 between = B.p + B.arm(j) - A.p - A.arm(i), speed = B.velocity(j) - A.velocity(i);
        const X gap = N.dot(between);
        if (gap < 0) return;
        least = std::min(least, root(gap, N1.dot(between) + N.dot(speed), -(bound2 * D + 2 * bound1 * V + rest)));
      }
    best = std::max(best, least);
  };
  const auto of = [](const Witness& b, int i) { return W3(b.R.col(i)); };
  for (int i = 0; i < 3; ++i) {
    axis(of(A, i), A.w.cross(of(A, i)), A.W, k_bound * A.W * A.W);
    axis(of(B, i), B.w.cross(of(B, i)), B.W, k_bound * B.W * B.W);
    for (int j = 0; j < 3; ++j)
      axis(of(A, i).cross(of(B, j)), A.w.cross(of(A, i)).cross(of(B, j)) + of(A, i).cross(B.w.cross(of(B, j))), A.W + B.W,
           k_bound * A.W * A.W + 2 * A.W * B.W + k_bound * B.W * B.W);
  }
  return best;
}
TEST(PairAdvance, IsTheBestOfFifteenAxes) {
  Draw draw;
  int seen = 0;
  for (int c = 0; c < 400; ++c) {
    const auto A = draw.cuboid(0.5, 5, 0.1, 1), B = draw.cuboid(0.5, 5, 0.1, 1);
    State<double> a, b;
    a.R_WB = draw.rotation(), b.R_WB = draw.rotation();
    const double spin = c % 3 == 0 ? 0.01 : 3, speed = c % 4 == 0 ? 0.1 : 4;
    a.w_WB = draw.vector(spin), b.w_WB = draw.vector(spin), a.v_WB = draw.vector(speed), b.v_WB = draw.vector(speed);
    a.p_WB = draw.vector(2);
    V towards = draw.vector(1);
    towards /= norm<double>(towards);
    const double reach = (norm<double>(A.size()) + norm<double>(B.size())) / 2, far = draw.in(0.4, 0.999);
    b.p_WB = a.p_WB + far * reach * towards;  // within the spheres around them
    const V pull_a = c % 5 == 0 ? V(0, -9.8, 0) : draw.vector(10), pull_b = c % 5 == 0 ? V(0, -9.8, 0) : draw.vector(10);
    const X want = pair_advance(Witness(A, a, pull_a), Witness(B, b, pull_b));
    if (want < 1e-4L) continue;  // they overlap or nearly touch
    ++seen;
    const Flight fa(A, a, pull_a), fb(B, b, pull_b);
    const double got = first_advance(0, 3 * double(want), [&](double limit) { return next_pair_contact(A, fa, 0, B, fb, 0, 0, limit).advances; });
    EXPECT_NEAR(got / double(want), 1, 1e-9) << c;  // a gap of 1e-16 m in a time of 1e-4 s
  }
  EXPECT_GT(seen, 100);
}
// Apart from each other by more than their spheres: those meet first. Both falling alike, on a straight line; otherwise the gap is
// covered at their relative speed and acceleration, whatever their directions.
TEST(PairAdvance, IsTheSpheresFromFarAway) {
  Draw draw;
  for (int c = 0; c < 60; ++c) {
    const auto A = draw.cuboid(0.5, 5, 0.1, 1), B = draw.cuboid(0.5, 5, 0.1, 1);
    State<double> a, b;
    a.R_WB = draw.rotation(), b.R_WB = draw.rotation(), a.w_WB = draw.vector(0.5), b.w_WB = draw.vector(0.5);
    a.v_WB = draw.vector(2), a.p_WB = draw.vector(2);
    V towards = draw.vector(1);
    towards /= norm<double>(towards);
    b.p_WB = a.p_WB + 20 * towards;
    const V aside = c % 2 == 0 ? zero3<double>() : draw.vector(0.1);  // some meet off the middle
    b.v_WB = a.v_WB - 3 * towards + aside;
    const V pull_a = draw.vector(3), pull_b = c % 3 == 0 ? pull_a : draw.vector(3);
    const Witness x(A, a, pull_a), y(B, b, pull_b);
    const W3 d = y.p - x.p, v = y.v - x.v;
    const X R = x.r + y.r, pull = (y.a - x.a).norm();
    X want;
    if (pull == 0) {  // |d + v t| = R
      const X vv = v.dot(v), dv = d.dot(v), cc = d.dot(d) - R * R, disc = dv * dv - vv * cc;
      if (disc < 0) continue;
      want = (-dv - std::sqrt(disc)) / vv;
    } else {
      want = (std::sqrt(v.dot(v) + 2 * pull * (d.norm() - R)) - v.norm()) / pull;
    }
    const Flight fa(A, a, pull_a), fb(B, b, pull_b);
    const double got = first_advance(0, 30, [&](double limit) { return next_pair_contact(A, fa, 0, B, fb, 0, 0, limit).advances; });
    EXPECT_NEAR(got / double(want), 1, 1e-12) << c;
  }
}

// Two that miss each other by less than what the flight to where they are nearest, 2^40 m off, will have rounded, 16 u of a metre for
// each metre of a coordinate: no answer yet, and half the way there is gone, whichever flies.
TEST(PairAdvance, IsHalfTheWayWhereRoundingsMayMakeThemMeet) {
  const auto A = *Cuboid<double>::make(2, {2, 3, 6}), B = *Cuboid<double>::make(1, {1, 2, 2});
  const double far = 0x1p40, growth = 16 * 0x1p-53 * far * 5 / 3;  // along (2, 1, -2)/3
  for (const double speed : {4., 0x1p-42})
    for (const bool first_flies : {true, false}) {
      State<double> still, flies;
      still.R_WB = rotation_of<double>(Vec4<double>(1, 2, -1, 3)), still.p_WB = V(0.5, -1, 2);
      flies.p_WB = still.p_WB + far * V(2, 1, -2) / 3 + (3.5 + 1.5 + 1.5 * growth) * V(1, 2, 2) / 3, flies.v_WB = -speed * V(2, 1, -2) / 3;
      const Flight a(A, first_flies ? flies : still, zero3<double>()), b(B, first_flies ? still : flies, zero3<double>());
      const auto advances = [&](double limit) { return next_pair_contact(A, a, 0, B, b, 0, 0, limit).advances; };
      EXPECT_NEAR(first_advance(0, far / speed, advances) / (far / speed / 2), 1, 1e-11) << speed << ' ' << first_flies;  // 4 m of 2^40
    }
}

// 16 u of the distance, of half a diagonal of each and of every coordinate.
TEST(PairAdvance, TouchingIsSixteenUnitsOfTheTermsOfAGap) {
  const auto A = *Cuboid<double>::make(2, {2, 3, 6}), B = *Cuboid<double>::make(1, {1, 2, 2});
  State<double> a, b;
  a.p_WB = V(1, -2, 4), b.p_WB = V(1 + 3, -2 - 4, 4 + 12);
  EXPECT_NEAR(touching_gap(A, a, B, b) / (16 * 0x1p-53 * (13 + 3.5 + 1.5 + 7 + (4 + 6 + 16))), 1, 1e-15);
}

// A parabola along each axis: one that turns on the way, one that turned before, one without a pull. To spare: a thousandth of the
// radius, 1e-12 of the places, the rounding of a flight, and the way in 8 u of the time.
TEST(SweptBox, HoldsThreeParabolasAndWhatIsToSpare) {
  State<double> start;
  start.p_WB = V(3, -5, 7), start.v_WB = V(2, 1, -4);
  const auto shape = *Cuboid<double>::make(2, {2, 3, 6});
  const Flight flight(shape, start, V(-4, 2, 0));
  const double from = 0.25, to = 1.5;
  const V low(3 + 2 * to - 2 * to * to, -5 + from + from * from, 7 - 4 * to), high(3 + 2 * 0.5 - 2 * 0.25, -5 + to + to * to, 7 - 4 * from);
  for (const double radius : {0.0, 0.5})
    for (const double t : {0.0, -1e9}) {
      const AxisBox box = swept_box(flight, radius, from, to, t);
      const double places = std::fmax(std::fabs(low[0]), high[0]) + std::fmax(std::fabs(low[1]), std::fabs(high[1])) + high[2];
      const double late = 8 * 0x1p-53 * (std::fabs(t) + to), speed = std::sqrt(4 + 1 + 16), pull = std::sqrt(16 + 4);
      const double reach = 1.001 * radius + 1e-12 * places + flight.rounding(to) + late * (speed + (to + late) * pull);
      for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR((low[k] - box.low[k]) / reach, 1, radius > 0 ? 1e-14 : t == 0 ? 1e-3 : 1e-8) << k << ' ' << radius << ' ' << t;
        EXPECT_NEAR((box.high[k] - high[k]) / reach, 1, radius > 0 ? 1e-14 : t == 0 ? 1e-3 : 1e-8) << k << ' ' << radius << ' ' << t;
      }
    }
}

// Pulled back along one edge alone, the way out and home: the box reaches to where it turns, a quarter metre on.
TEST(SweptBox, HoldsTheTurnAlongEachEdge) {
  const auto shape = *Cuboid<double>::make(2, {2, 3, 6});
  for (int k = 0; k < 3; ++k)
    for (const double way : {1.0, -1.0}) {
      State<double> start;
      start.v_WB[k] = way;
      V pull = zero3<double>();
      pull[k] = -2 * way;
      const AxisBox box = swept_box(Flight(shape, start, pull), 0, 0, 1, 0);
      EXPECT_NEAR(way > 0 ? box.high[k] : -box.low[k], 0.25, 1e-11) << k;
      EXPECT_NEAR(way > 0 ? box.low[k] : box.high[k], 0, 1e-11) << k;
    }
}

}  // namespace
}  // namespace rigor
