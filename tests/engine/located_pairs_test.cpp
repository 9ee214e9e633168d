#include <gtest/gtest.h>

#include <cmath>
#include <rigor/collision/box_box.hpp>
#include <rigor/engine/located.hpp>
#include <rigor/engine/pair_search.hpp>
#include <rigor/formulas/world_inertia.hpp>

#include "pair_courses.hpp"

namespace rigor {
namespace {

// case BB-14. Dense sampling with another test of separation: the 15 axes of box_box, at fixed poses. No overlap before the time
// found, none at all where none was found, and a gap of rounding at the time itself.
TEST(PairSearch, FindsEveryFirstContactOfAThousandCourses) {
  Draw draw;
  int met = 0;
  long advances = 0;
  for (int c = 0; c < 1000; ++c) {
    const Course x = course(draw);
    const V g(0, -9.8, 0);
    const Flight a(x.A, x.a, g), b(x.B, x.b, g);
    const PairContact found = next_pair_contact(x.A, a, 0, x.B, b, 0, 0, 3);
    ASSERT_NE(found.kind, PairContact::Kind::endless);
    advances += found.advances;
    const auto gap = [&](double t) { return separation(x.A, a.at(t), x.B, b.at(t)).gap; };
    const bool touch = found.kind == PairContact::Kind::touch;
    met += touch;
    const double end = touch ? found.time : 3;
    for (int k = 0; k < 400; ++k) EXPECT_GT(gap(end * k / 400), -1e-14) << "course " << c << " at " << end * k / 400;
    if (touch) {
      EXPECT_LT(std::fabs(gap(found.time)), 1e-13) << c;
      EXPECT_LT(gap(found.time + 1e-6), 0) << c << ": it was about to overlap";
    }
  }
  EXPECT_GT(met, 300);
  EXPECT_LT(met, 1000);
  EXPECT_LT(advances, 200 * 1000);
}

// Corner against corner the spheres around the two meet at the same moment as they do: when the gap of 0.6 or 1 edge is run through.
TEST(PairSearch, FindsCornersThatMeetHeadOn) {
  const auto cube = *Cuboid<double>::make(1, {1, 1, 1});
  for (const double gap : {0.6, 1.0})
    for (const double speed : {1.0, 0.7, 1e-3}) {
      State<double> a, b;
      const double away = 1 + gap;
      a.p_WB = V(0.3, -0.2, 0.1), b.p_WB = a.p_WB + V(away, away, away), b.v_WB = V(-speed, -speed, -speed);
      const Flight fa(cube, a, zero3<double>()), fb(cube, b, zero3<double>());
      const PairContact found = next_pair_contact(cube, fa, 0, cube, fb, 0, 0, 2 / speed);
      EXPECT_EQ(found.kind, PairContact::Kind::touch) << speed;
      EXPECT_NEAR(found.time * speed, gap, 1e-14) << speed;
      EXPECT_LT(found.advances, 100) << speed;
    }
}

// Faces level with each other and closing in, and the two past each other along another edge: nothing touches.
TEST(PairSearch, LetsPassWhatOneAxisKeepsApart) {
  const V size(1, 1.5, 0.5);
  const auto box = *Cuboid<double>::make(1, size);
  for (int level = 0; level < 3; ++level)
    for (const int apart : {(level + 1) % 3, (level + 2) % 3}) {
      State<double> a, b;
      b.p_WB[level] = size[level], b.p_WB[apart] = size[apart] + 0.0625;
      b.v_WB[level] = -1;
      const Flight fa(box, a, zero3<double>()), fb(box, b, zero3<double>());
      const PairContact found = next_pair_contact(box, fa, 0, box, fb, 0, 0, 3);
      EXPECT_EQ(found.kind, PairContact::Kind::none) << level << ' ' << apart << ", " << found.time << " s";
    }
}

// Places known to half the thinnest edge, 1/2 m, are enough to say what touches what: it is told when the gap is no more than what is
// not known. Known to less, that is said when the spheres around the two are as near.
TEST(PairSearch, SaysFromWhereItCannotTell) {
  const auto A = *Cuboid<double>::make(1, {2, 1, 4}), B = *Cuboid<double>::make(1, {1, 2, 2});
  const double spheres = std::sqrt(4.0 + 1 + 16) / 2 + 1.5, gap = 3.5;
  State<double> a, b;
  b.p_WB[0] = 1.5 + gap, b.v_WB[0] = -4;
  const Flight fa(A, a, zero3<double>()), fb(B, b, zero3<double>());
  for (const double slack : {0.4, 0.499, 0.501, 0.7}) {
    const PairContact found = next_pair_contact(A, fa, 0, B, fb, 0, 0, 2, slack);
    EXPECT_EQ(found.kind, slack < 0.5 ? PairContact::Kind::touch : PairContact::Kind::blurred) << slack;
    if (slack > 0.5) {
      EXPECT_NEAR(found.time, (1.5 + gap - spheres - slack) / 4, 1e-13) << slack;
    } else {
      EXPECT_TRUE(found.time >= (gap - slack) / 4 && found.time <= gap / 4 * (1 + 1e-15)) << slack << ", " << found.time;
    }
  }
}

// The time does not depend on when the flights began.
TEST(PairSearch, GivesTheSameMeetingHoweverTheFlightsAreDated) {
  Draw draw;
  for (int c = 0; c < 50; ++c) {
    const Course x = course(draw);
    const Flight a(x.A, x.a, V(0, -9.8, 0)), b(x.B, x.b, V(0, -9.8, 0));
    const PairContact found = next_pair_contact(x.A, a, 0, x.B, b, 0, 0, 3);
    if (found.kind == PairContact::Kind::none) continue;
    const double early = found.time / 3;
    const Flight later(x.B, b.at(early), V(0, -9.8, 0));
    const PairContact again = next_pair_contact(x.A, a, early, x.B, later, 0, 0, 3);
    EXPECT_NEAR(again.time + early, found.time, 1e-12) << c;
  }
}

// Two cuboids in free space: momenta kept, energy by the law, v_n' = -e v_n is in the energy account. A few courses end in
// a persistent contact, which the stepper takes over: those are judged up to that moment.
TEST(LocatedPairs, KeepMomentaAndLoseTheEnergyOfRestitution) {
  Draw draw;
  int impacts = 0, handed_over = 0;
  for (int c = 0; c < 1000; ++c) {
    const Course x = course(draw);
    Scene s;
    s.gravity = zero3<double>();
    s.surface = *Surface<double>::make(c % 2 == 0 ? 1.0 : 0.6, 0.3, 0.3);
    s.bodies = {{x.A, x.a}, {x.B, x.b}};
    s.until = 3;
    std::vector<State<double>> end;
    const auto run = [&] { return simulate_located(s, [&](double, const std::vector<State<double>>& states) { end = states; }); };
    auto done = run();
    ASSERT_TRUE(done);
    if (!done->handed_over.empty()) {
      ++handed_over;
      s.until = std::nextafter(done->handed_over[0].from, 0);
      done = run();
      ASSERT_TRUE(done && done->handed_over.empty()) << c;
    }
    impacts += int(done->ledger.pair_impacts);
    V P = zero3<double>(), L = zero3<double>();
    double size = 0;
    for (const double sign : {1.0, -1.0})
      for (int k = 0; k < 2; ++k) {
        const Cuboid<double>& shape = k == 0 ? x.A : x.B;
        const State<double>& state = sign > 0 ? (k == 0 ? x.a : x.b) : end[std::size_t(k)];
        const V spin = world_inertia<double>(state.R_WB, shape.inertia()) * state.w_WB;
        P += sign * shape.mass() * state.v_WB;
        L += sign * (shape.mass() * cross<double>(state.p_WB, state.v_WB) + spin);
        size += shape.mass() * norm<double>(state.v_WB) * (1 + norm<double>(state.p_WB)) + norm<double>(spin);
      }
    EXPECT_LT(norm<double>(P), 1e-14 * size) << c;
    EXPECT_LT(norm<double>(L), 2e-14 * size) << c;  // positions of up to 25 m, attitudes to 1e-15, a few impacts
    EXPECT_LT(done->ledger.energy.worst_drift, 1e-13 * done->ledger.energy.start) << c;
    EXPECT_LT(done->ledger.angular.worst_drift, 2e-14 * size) << c;
    EXPECT_EQ(norm<double>(done->ledger.angular.external), 0) << "nothing from outside";
    if (c % 2 == 0) {
      EXPECT_LT(std::fabs(done->ledger.energy.restitution_loss), 1e-13 * done->ledger.energy.start);
    } else {
      EXPECT_GE(done->ledger.energy.restitution_loss, 0);
    }
  }
  EXPECT_GT(impacts, 250);
  EXPECT_LE(handed_over, 20) << "thirteen were seen";
}

// Dropped 0.45 m onto another, as large and half as heavy, that has fallen 5 mm onto the floor and lies there, e = 0: what both
// observers see, and that they go on down together, into the floor.
TEST(LocatedPairs, WhatRestsIsMet) {
  for (const bool below_first : {true, false}) {
    Scene s;
    s.method = "located";
    s.gravity = V(0, -10, 0);
    s.surface = *Surface<double>::make(0, 0.4, 0.3);
    s.planes.push_back(*Plane<double>::make(V(0, 0, 0), V(0, 1, 0)));
    State<double> below, above;
    below.p_WB = V(1, 0.125 + 0.005, -2), above.p_WB = V(1, 0.25 + 0.45 + 0.125, -2);
    const SceneBody low{*Cuboid<double>::make(1, {0.5, 0.25, 1}), below}, high{*Cuboid<double>::make(2, {0.5, 0.25, 1}), above};
    s.bodies = {below_first ? low : high, below_first ? high : low};
    s.until = s.every = 0.3005;
    std::vector<LocatedImpact> seen;
    const auto done = simulate_located(s, [](double, const auto&) {}, [&](const LocatedImpact& impact) { seen.push_back(impact); });
    ASSERT_TRUE(done);
    EXPECT_GE(done->ledger.pair_impacts, 1);
    ASSERT_GE(seen.size(), 3u);
    const double landed = std::sqrt(2 * 0.005 / 10);
    EXPECT_NEAR(seen[0].t, landed, 1e-14);
    for (std::size_t k = 0; k < 2; ++k) {
      const LocatedImpact& impact = seen[1 + k];
      const bool is_low = (impact.body == 0) == below_first;
      EXPECT_EQ(impact.body, k) << "in order of index";
      EXPECT_NEAR(impact.t, 0.3, 1e-14);
      EXPECT_NEAR(impact.tau, is_low ? 0.3 - landed : 0.3, 1e-14);
      EXPECT_NEAR(impact.from.p_WB[1], is_low ? 0.125 : 0.825, 1e-15);
      EXPECT_NEAR(impact.before.v_WB[1], is_low ? 0 : -3, 1e-14);
      EXPECT_NEAR(impact.after.v_WB[1], -2, 1e-13) << "2 kg at 3 m/s and 1 kg at rest";
    }
  }
}

// Two that begin a centimetre inside each other are handed over, and each is pushed out by half of it.
TEST(LocatedPairs, AnOverlapIsTakenOutByHalves) {
  Scene s;
  s.method = "located", s.gravity = zero3<double>(), s.until = 0.01;
  State<double> a, b;
  a.p_WB = V(1, 2, 3), b.p_WB = V(1 + 2 - 0.01, 2.01, 3.02);  // beams end to end, as far from each other as they can be
  s.bodies = {{*Cuboid<double>::make(2, {2, 0.1, 0.15}), a}, {*Cuboid<double>::make(1, {2, 0.15, 0.1}), b}};
  std::vector<State<double>> end;
  const auto run = simulate_located(s, [&](double, const std::vector<State<double>>& states) { end = states; });
  ASSERT_TRUE(run);
  ASSERT_EQ(run->handed_over.size(), 2u);
  EXPECT_EQ(run->handed_over[0].why, "begins inside another cuboid");
  EXPECT_LT(norm<double>(V(end[0].p_WB - a.p_WB - V(-0.005, 0, 0))), 1e-15);
  EXPECT_LT(norm<double>(V(end[1].p_WB - b.p_WB - V(0.005, 0, 0))), 1e-15);
  EXPECT_NEAR(run->ledger.deepest_penetration, 0.005, 1e-15) << "the way of each";
  EXPECT_EQ(run->ledger.impacts, 0);
}

// The stepper pushes two apart without friction: what slides goes on sliding. They step until ten steps met nothing after that one.
// Between them in the list stands one that has nothing to do with it.
TEST(LocatedPairs, APushInTheStepperHasNoFriction) {
  Scene s;
  s.method = "located", s.gravity = zero3<double>(), s.dt = 1.0 / 256, s.until = 0.1;
  s.surface = *Surface<double>::make(0.5, 0.7, 0.6), s.friction_law = FrictionLaw::coulomb;
  State<double> a, b, other;
  a.v_WB = V(1, 0, 0), b.p_WB = V(0.99, 0, 0), b.v_WB = V(-1, 3, 0), other.p_WB = V(50, 0, 0);
  const auto cube = [](double mass) { return *Cuboid<double>::make(mass, {1, 1, 1}); };
  s.bodies = {{cube(2), a}, {cube(1), other}, {cube(1), b}};
  std::vector<State<double>> end;
  const auto run = simulate_located(s, [&](double, const std::vector<State<double>>& states) { end = states; });
  ASSERT_TRUE(run);
  ASSERT_EQ(run->handed_over.size(), 2u);
  for (const auto& handed : run->handed_over) EXPECT_NEAR(handed.to, 11 * s.dt, 1e-15) << handed.body;
  EXPECT_EQ(run->ledger.pair_impacts, 1);
  EXPECT_EQ(end[0].v_WB[1], 0);
  EXPECT_EQ(end[2].v_WB[1], 3);
  EXPECT_LT(end[0].v_WB[0], end[2].v_WB[0]) << "they part";
  EXPECT_NEAR(2 * end[0].v_WB[0] + end[2].v_WB[0], 1, 1e-14);
}

// What flies past one in the stepper, within the spheres around the two, flies on.
TEST(LocatedPairs, OnlyWhatMeetsTheStepperJoinsIt) {
  Scene s;
  s.method = "located", s.dt = 1.0 / 64, s.until = 0.5;
  s.planes.push_back(*Plane<double>::make(V(0, 5, 0), V(0, -1, 0)));
  const auto box = *Cuboid<double>::make(2, {0.5, 0.5, 1});
  State<double> inside, beside;
  inside.p_WB = V(0.3, 4.9, -0.2), beside.p_WB = V(0.9, 4.6, -0.2);
  s.bodies = {{box, inside}, {box, beside}};
  const auto run = simulate_located(s, [](double, const auto&) {});
  ASSERT_TRUE(run);
  ASSERT_EQ(run->handed_over.size(), 1u) << run->handed_over[1].why;
  EXPECT_EQ(run->handed_over[0].body, 0u);
  EXPECT_EQ(run->ledger.pair_impacts, 0);
}

// Two cubes of which one comes 2^41 m at 2^41 m/s, all of it without a rounding: bounds of 16 u of such places are a hundredth of a
// cube, and yet nothing is wrong with where they meet.
TEST(LocatedPairs, ABoundOnRoundingsIsNoRounding) {
  Scene s;
  s.method = "located", s.gravity = zero3<double>(), s.until = 2;
  s.surface = *Surface<double>::make(1, 0, 0);
  State<double> a, b;
  a.p_WB = V(-0x1p41, 0, 0), a.v_WB = V(0x1p41, 0, 0), b.p_WB = V(0, 0.125, 0.0625);
  const auto cube = *Cuboid<double>::make(1, {1, 1, 1});
  s.bodies = {{cube, a}, {cube, b}};
  const auto run = simulate_located(s, [](double, const auto&) {});
  ASSERT_TRUE(run);
  EXPECT_EQ(run->ledger.pair_impacts, 1);
  EXPECT_TRUE(run->handed_over.empty()) << run->handed_over[0].why;
}

// Cubes of ten nanometres that close in at a nanometre a second, one of them turning a thousand times a second or none: that is no
// standing still.
TEST(LocatedPairs, ASlowApproachOfTinyOnesIsOne) {
  for (const int spins : {0, 1, 2}) {
    Scene s;
    s.method = "located", s.gravity = zero3<double>(), s.until = spins < 2 ? 0.8 : 3;
    s.surface = *Surface<double>::make(1, 0, 0);
    State<double> a, b;
    b.p_WB = V(1.25e-8, 0.1e-8, 0.2e-8), b.v_WB = V(-1e-9, 0, 0);
    if (spins < 2) (spins == 0 ? a : b).w_WB = V(0, 0, 6000);
    const auto cube = *Cuboid<double>::make(1, {1e-8, 1e-8, 1e-8});
    s.bodies = {{cube, a}, {cube, b}};
    const auto run = simulate_located(s, [](double, const auto&) {});
    ASSERT_TRUE(run);
    EXPECT_GE(run->ledger.pair_impacts, 1);
    EXPECT_TRUE(run->handed_over.empty()) << run->handed_over[0].why;
  }
}

Scene crowd(Draw& draw, double e) {
  Scene s;
  s.surface = *Surface<double>::make(e, 0, 0);
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      V n = zero3<double>();
      n[axis] = -side;
      s.planes.push_back(*Plane<double>::make(V(-3 * n), n));
    }
  for (int k = 0; k < 8; ++k) {
    State<double> b;
    b.p_WB = V(k & 1 ? 1.4 : -1.4, k & 2 ? 1.4 : -1.4, k & 4 ? 1.4 : -1.4);
    b.R_WB = draw.rotation();
    b.v_WB = draw.vector(3);
    b.w_WB = draw.vector(5);
    s.bodies.push_back({draw.cuboid(0.5, 5, 0.3, 1.2), b});
  }
  return s;
}

// Eight elastic cuboids in a closed room: hundreds of impacts, energy kept to rounding, nobody through a wall or through
// another at any time looked at. What is not in exact flight is not judged here: nothing is handed over.
TEST(LocatedPairs, EightElasticCuboidsInARoomKeepTheirEnergyAndTheirDistance) {
  Draw draw;
  for (int run = 0; run < 3; ++run) {
    Scene s = crowd(draw, 1);
    s.until = 4;
    s.every = 0.004;
    double overlap = 0, outside = 0;
    const auto done = simulate_located(s, [&](double, const std::vector<State<double>>& states) {
      for (std::size_t i = 0; i < states.size(); ++i) {
        for (const Plane<double>& plane : s.planes)
          for (int k = 0; k < 8; ++k) outside = std::fmin(outside, plane.gap(V(states[i].p_WB + states[i].R_WB * s.bodies[i].shape.corner(k))));
        for (std::size_t j = i + 1; j < states.size(); ++j)
          if (norm<double>(V(states[i].p_WB - states[j].p_WB)) < 2.2) overlap = std::fmin(overlap, separation(s.bodies[i].shape, states[i], s.bodies[j].shape, states[j]).gap);
      }
    });
    ASSERT_TRUE(done);
    EXPECT_TRUE(done->handed_over.empty()) << done->handed_over[0].why;
    EXPECT_GT(done->ledger.impacts, 100);
    EXPECT_GT(done->ledger.pair_impacts, 10);
    EXPECT_GT(overlap, -1e-13) << run;
    EXPECT_GT(outside, -1e-13) << run;
    // every impact leaves a few u of the energies it exchanged
    EXPECT_LT(done->ledger.energy.worst_drift, double(done->ledger.impacts) * 64 * 0x1p-53 * done->ledger.energy.start) << run;
    // momenta: of the size of mass, speed and room (20 kg, 10 m/s, 3 m), a few u an impact
    EXPECT_LT(done->ledger.linear.worst_drift, double(done->ledger.impacts) * 64 * 0x1p-53 * 200) << run;
    EXPECT_LT(done->ledger.angular.worst_drift, double(done->ledger.impacts) * 64 * 0x1p-53 * 600) << run;
  }
}

// The same bits whatever output is asked for, with many bodies too.
TEST(LocatedPairs, GiveTheSameBitsWhateverOutputIsAsked) {
  std::vector<State<double>> last[2];
  for (const int k : {0, 1}) {
    Draw draw;
    Scene s = crowd(draw, 0.9);
    s.until = 1.5;
    s.every = k == 0 ? 1.5 : 0.007;
    s.dt = k == 0 ? 0.01 : 0.002;
    const auto done = simulate_located(s, [&](double, const std::vector<State<double>>& states) { last[k] = states; });
    ASSERT_TRUE(done->handed_over.empty());
  }
  for (std::size_t i = 0; i < last[0].size(); ++i) {
    EXPECT_EQ(last[0][i].p_WB, last[1][i].p_WB);
    EXPECT_EQ(last[0][i].R_WB, last[1][i].R_WB);
    EXPECT_EQ(last[0][i].w_WB, last[1][i].w_WB);
  }
}

}  // namespace
}  // namespace rigor
