#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <rigor/engine/located.hpp>
#include <rigor/engine/pair_search.hpp>

#include "pair_courses.hpp"

namespace rigor {
namespace {

struct Record {
  std::vector<std::uint64_t> rows;  // the bits of every number of every output
  std::vector<std::size_t> met;
  RunSummary summary;
};
Record run(const Scene& s, const Skips& skips) {
  Record r;
  const auto keep = [&](const State<double>& b) {
    for (const V& v : {b.p_WB, b.v_WB, b.w_WB, V(b.R_WB.col(0)), V(b.R_WB.col(1)), V(b.R_WB.col(2))})
      for (const double x : v) r.rows.push_back(std::bit_cast<std::uint64_t>(x));
  };
  const auto done = simulate_located(s, [&](double t, const std::vector<State<double>>& states) {
    r.rows.push_back(std::bit_cast<std::uint64_t>(t));
    for (const State<double>& b : states) keep(b);
  }, [&](const LocatedImpact& impact) {
    r.met.push_back(impact.body);
    r.rows.push_back(std::bit_cast<std::uint64_t>(impact.t)), keep(impact.after);
  }, skips);
  r.summary = *done;
  return r;
}
void expect_same_bits(const Record& a, const Record& b, int world) {
  EXPECT_EQ(a.met, b.met) << "world " << world;
  EXPECT_EQ(a.rows, b.rows) << "world " << world;
  const Ledger &x = a.summary.ledger, &y = b.summary.ledger;
  EXPECT_EQ(x.impacts, y.impacts);
  EXPECT_EQ(a.summary.finite, b.summary.finite);
  if (a.summary.finite) {
    EXPECT_EQ(x.energy.end, y.energy.end);
    EXPECT_EQ(x.energy.restitution_loss, y.energy.restitution_loss);
    EXPECT_EQ(x.energy.correction, y.energy.correction);
  }
  ASSERT_EQ(a.summary.handed_over.size(), b.summary.handed_over.size());
  for (std::size_t k = 0; k < a.summary.handed_over.size(); ++k) {
    EXPECT_EQ(a.summary.handed_over[k].body, b.summary.handed_over[k].body);
    EXPECT_EQ(a.summary.handed_over[k].from, b.summary.handed_over[k].from);
    EXPECT_EQ(a.summary.handed_over[k].to, b.summary.handed_over[k].to);
    EXPECT_EQ(a.summary.handed_over[k].why, b.summary.handed_over[k].why);
  }
}
// Everything between a crowd and a gas; giants, grains and plates; with and without a room, gravity and its switch, friction.
Scene world_of(Draw& draw, int w) {
  Scene s;
  s.surface = *Surface<double>::make(w % 6 == 0 ? 1 : draw.in(0, 1), w % 3 == 0 ? 0 : 0.4, w % 3 == 0 ? 0 : 0.3);
  s.gravity = w % 4 == 0 ? zero3<double>() : V{draw.in(-1, 1), draw.in(-12, 2), draw.in(-1, 1)};
  const double room = draw.in(1.5, 6);
  if (w % 5 != 4)
    for (int axis = 0; axis < 3; ++axis)
      for (const double side : {-1.0, 1.0}) {
        V n = zero3<double>();
        n[axis] = -side;
        s.planes.push_back(*Plane<double>::make(V(-room * n), n));
      }
  const int bodies = 2 + int(draw.in(0, w % 2 == 0 ? 6 : 40));
  for (int k = 0; k < bodies; ++k) {
    State<double> b;
    b.p_WB = draw.vector(room - 1), b.R_WB = draw.rotation(), b.v_WB = draw.vector(w % 7 == 0 ? 60 : 5), b.w_WB = draw.vector(9);
    const double giant = draw.in(0, 9) < 1 ? 3 : 1, thin = draw.in(0, 4) < 1 ? 1e-3 : 1;
    const double mass = draw.in(0.1, 5);
    s.bodies.push_back({*Cuboid<double>::make(mass, V(giant, thin, 1).cwiseProduct(draw.sizes(0.1, 0.8))), b});
  }
  if (w % 4 == 1) s.actions = {{0.4, SceneAction::Do::gravity_off}, {0.8, SceneAction::Do::gravity_on}};
  s.method = "located";
  s.until = 1.2, s.every = 0.1, s.dt = 1.0 / 480;
  return s;
}

// Pairs whose boxes do not overlap, and planes a flight's sphere stays clear of, against the search of all: same bits.
TEST(LocatedSkip, ChangesNoBit) {
  Draw draw;
  const int worlds = std::getenv("RIGOR_ALL") != nullptr ? 3000 : 80;
  long left_out = 0, pairs = 0, planes = 0, impacts = 0, meetings = 0, advances = 0;
  for (int w = 0; w < worlds; ++w) {
    const Scene s = world_of(draw, w);
    const Record with = run(s, {});
    for (const char* id : {"pairs", "planes", "all"}) {
      const Skips fewer = *without({}, {id});
      const Record other = run(s, fewer);
      SCOPED_TRACE(id);
      expect_same_bits(with, other, w);
      EXPECT_LE(with.summary.steps, other.summary.steps) << w << ": advances of the searches made";
      advances += other.summary.steps - with.summary.steps;
      for (const PlanLine& line : plan(fewer, other.summary.ledger.skips)) EXPECT_TRUE(line.skipped || line.left_out == 0) << line.id;
    }
    const Ledger& l = with.summary.ledger;
    EXPECT_LE(0, l.skips.pairs);
    left_out += l.skips.pairs, pairs += l.skips.pairs_of, planes += l.skips.planes, impacts += l.impacts, meetings += l.pair_impacts;
  }
  EXPECT_GT(meetings, 10 * worlds);
  EXPECT_GT(left_out, pairs / 2);
  EXPECT_LT(left_out, pairs);
  EXPECT_GT(advances, 0) << "what is left out has advances";
  EXPECT_GT(planes, impacts);
}

// A box holds the sphere around a cuboid for as long as it says, also where the flight turns inside it.
TEST(LocatedSkip, ABoxHoldsItsFlight) {
  Draw draw;
  for (int k = 0; k < 2000; ++k) {
    const auto shape = *Cuboid<double>::make(1, draw.sizes(0.1, 1));
    State<double> start;
    start.p_WB = draw.vector(k % 3 == 0 ? 1e6 : 3), start.v_WB = draw.vector(10), start.w_WB = draw.vector(5);
    const Flight flight(shape, start, k % 5 == 0 ? zero3<double>() : k % 5 == 1 ? V(1, -1, -9.81) : draw.vector(10));
    const double from = draw.in(0, 2), to = from + draw.in(0, 3), radius = norm<double>(shape.size()) / 2;
    const AxisBox box = swept_box(flight, radius, from, to, 0);
    double room = 1e9;  // to spare on the tightest side
    for (int n = 0; n <= 200; ++n) {
      const V p = flight.at(from + (to - from) * n / 200).p_WB, low = p - box.low, high = box.high - p;
      EXPECT_GE(low.minCoeff(), radius) << k;
      EXPECT_GE(high.minCoeff(), radius) << k;
      room = std::fmin(room, std::fmin(low.minCoeff(), high.minCoeff()) - radius);
    }
    EXPECT_LT(room, 0.01) << k << ": no larger than need be";
  }
}

// A pair is searched if its spheres, 1.001 of their radii and a thousandth of the way to spare, could meet before the run is over. The
// end from which on it is: where what is left out becomes less, by halving.
double searched_from(Scene s, double low, double high) {
  const auto left_out = [&](double until) {
    s.until = s.every = until;
    return run(s, {}).summary.ledger.skips.pairs;
  };
  const long before = left_out(low);
  EXPECT_EQ(left_out(high), before - 1);
  for (int k = 0; k < 60; ++k) (left_out((low + high) / 2) == before ? low : high) = (low + high) / 2;
  return low;
}
TEST(LocatedSkip, SearchesAPairFromWhereItsSpheresCouldMeet) {
  Scene s;
  s.method = "located";
  s.friction_law = FrictionLaw::coulomb;
  const auto A = *Cuboid<double>::make(2, {0.5, 0.25, 1}), B = *Cuboid<double>::make(1, {0.75, 0.5, 0.25});
  const double spheres = 1.001 * (norm<double>(A.size()) + norm<double>(B.size())) / 2;
  State<double> a, b;
  for (const double far : {0.0, 1e3}) {  // what places are rounded by, 16 u of their terms, is to spare too
    const auto expect_from = [&](double got, double want, double speed, int places) {
      const double earlier = 16 * 0x1p-53 * places * 2 * far / 1.001 / speed;  // of two coordinates each
      EXPECT_NEAR(got, want - earlier, far > 0 ? earlier / 10 : 1e-13);
    };
    // one rests on the floor, the other is thrown at it
    s.gravity = V(0, -9.8, 0);
    s.surface = *Surface<double>::make(0, 0.5, 0.5);
    s.planes = {*Plane<double>::make(V(0, 0, 0), V(0, 1, 0))};
    a.p_WB = V(far, 0.125, -far), b.p_WB = a.p_WB + V(2, 2, 2), b.v_WB = V(-12, -12, -12);
    s.bodies = {{A, a}, {B, b}};
    const double d = norm<double>(V(2, 2, 2)), v = norm<double>(b.v_WB), g = 9.8;
    const double way = (d - spheres) / 1.001, after = (std::sqrt(v * v + 2 * g * way) - v) / g;
    expect_from(searched_from(s, 0.01, 0.13), after, v + g * after, 2);

    // both fall, one after it has met a wall flat after a quarter of a second; it is then 3 m along the diagonal and closes in on it
    s.gravity = V(1, -9.8, 2);
    s.surface = *Surface<double>::make(1, 0, 0);
    s.planes = {*Plane<double>::make(V(5 + far, 0, 0), V(-1, 0, 0))};
    const double t = 0.25;
    const V hit(5 + far - 0.375, 7, -far), fall = t * t / 2 * s.gravity;
    b.v_WB = V(3 - 2 * t * s.gravity[0], -3, -3), b.p_WB = hit - t * b.v_WB - fall;
    a.v_WB = zero3<double>(), a.p_WB = hit - V(3, 3, 3) / std::sqrt(3) - fall;
    s.bodies = {{A, a}, {B, b}};
    const double closing = norm<double>(V(3, 3, 3));
    expect_from(searched_from(s, t + 0.01, t + 0.5), t + (3 - spheres) / 1.001 / closing, closing, 3);  // the flight to the wall too
  }
  // a million metres in each second, and no place to begin with: the terms of a place are those of the way
  s.gravity = zero3<double>(), s.planes.clear();
  a.p_WB = zero3<double>(), a.v_WB = V(0x1p20, 0x1p20, 0x1p20), b.p_WB = V(2, 2, 2), b.v_WB = a.v_WB - V(2, 2, 2);
  s.bodies = {{A, a}, {B, b}};
  const double closing = norm<double>(V(2, 2, 2)), want = (closing - spheres) / 1.001 / closing;
  const double earlier = 16 * 0x1p-53 * 2 * 3 * 0x1p20 * want / 1.001 / closing;
  EXPECT_NEAR(searched_from(s, 0.1, 0.9), want - earlier, earlier / 10);
}

// Spread out in space, each has to do with few: the searches are as many for each, however many they are.
TEST(LocatedSkip, SearchesNoMorePairsForEachOfMany) {
  for (const int side : {5, 10, 20}) {
    Scene s;
    s.method = "located";
    s.surface = *Surface<double>::make(0.6, 0.3, 0.3);
    s.planes.push_back(*Plane<double>::make({0, 0, 0}, {0, 1, 0}));
    Draw draw;
    for (int k = 0; k < side * side; ++k) {
      State<double> b;
      b.p_WB = V(4 * (k % side), 1.5, 4 * (k / side)), b.R_WB = draw.rotation(), b.v_WB = draw.vector(3), b.w_WB = draw.vector(3);
      s.bodies.push_back({*Cuboid<double>::make(2, {0.5, 0.8, 1.1}), b});
    }
    s.until = 1;
    const Ledger::Skips skips = run(s, {}).summary.ledger.skips;
    EXPECT_LT(skips.pairs_of - skips.pairs, 3 * side * side) << "0.4, 0.8 and 1.2 were seen: at the border one has fewer neighbours";
    EXPECT_GT(skips.pairs_of, 2L * side * side * (side * side - 1));
  }
}

}  // namespace
}  // namespace rigor
