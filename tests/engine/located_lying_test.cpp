// What lies on a plane: when it is at rest, glides or slides. Skew planes, three different edges, a centre off the origin.
#include <gtest/gtest.h>

#include <cmath>
#include <rigor/engine/located.hpp>
#include <rigor/linalg/rotation.hpp>
#include <tests/engine/pair_courses.hpp>

namespace rigor {
namespace {

// A cuboid that lies with its second edge along the normal n of a plane through the origin, turned about n; gravity is given.
struct Lying {
  Scene scene;
  V n;
  Mat3<double> face;  // its second column is n
  Lying(const Mat3<double>& rotation, const V& edges, const V& gravity, double e, double mu) : n(rotation.col(1)), face(rotation) {
    State<double> start;
    start.R_WB = rotation, start.p_WB = V(edges[1] / 2 * n + 3 * edges[0] * V(rotation.col(0)));
    scene.method = "located", scene.gravity = gravity, scene.until = 1, scene.every = 1;
    scene.surface = *Surface<double>::make(e, mu, mu), scene.friction_law = FrictionLaw::coulomb;
    scene.planes = {*Plane<double>::make(zero3<double>(), n)};
    scene.bodies = {{*Cuboid<double>::make(2, edges), start}};
  }
  State<double>& start() { return scene.bodies[0].start; }
  std::pair<RunSummary, State<double>> run() {
    State<double> end;
    const auto done = simulate_located(scene, [&](double, const std::vector<State<double>>& states) { end = states[0]; });
    EXPECT_TRUE(done);
    return {*done, end};
  }
};
const Mat3<double> skew_face = rotation_of<double>(Vec4<double>(1, 2, -1, 3));

// Whatever the roundings of a slide leave of its speed, what has come to rest has none.
TEST(Located, WhatHasSlidToItsEndIsAtRest) {
  Draw draw;
  for (int k = 0; k < 100; ++k) {
    Lying x(draw.rotation(), V(0.5, 0.25, 1), zero3<double>(), 0.5, draw.in(0.2, 0.9));
    x.scene.gravity = -draw.in(2, 20) * x.n;
    const double angle = draw.in(0, 6.28), speed = draw.in(0.01, 1);
    x.start().v_WB = speed * (std::cos(angle) * V(x.face.col(0)) + std::sin(angle) * V(x.face.col(2)));
    x.scene.until = 4;
    const auto [summary, end] = x.run();
    EXPECT_TRUE(summary.handed_over.empty());
    EXPECT_EQ(norm<double>(end.v_WB), 0) << k;
  }
}

// It spins in place about its middle axis, from which a free cuboid would turn over after some twenty turns, on a plane across gravity.
TEST(Located, WhatSpinsInPlaceStaysFlat) {
  Lying x(skew_face, V(1, 0.5, 0.3), zero3<double>(), 0, 0);
  x.scene.gravity = -9.8 * x.n;
  x.start().w_WB = 300 * x.n;
  x.scene.until = 10;
  const auto [summary, end] = x.run();
  EXPECT_TRUE(summary.handed_over.empty());
  EXPECT_LT(norm<double>(V(end.R_WB.col(1) - x.n)), 1e-14);
  EXPECT_LT(norm<double>(V(end.w_WB - 300 * x.n)), 300 * 1e-14);
}

// Across a slope friction turns with the slip, and no exact phase knows that; in the weight of a grain of dust too.
TEST(Located, ASlipAcrossASlopeIsHandedOverInAnyGravity) {
  for (const double g : {9.8, 1e-7}) {
    Lying x(skew_face, V(0.5, 0.25, 1), zero3<double>(), 0.5, 0.3);
    x.scene.gravity = g * V(-std::cos(0.2) * x.n + std::sin(0.2) * V(x.face.col(0)));
    x.start().v_WB = 0.1 * V(x.face.col(2));
    x.scene.until = 0.125;
    const auto [summary, end] = x.run();
    ASSERT_EQ(summary.handed_over.size(), 1u) << g;
    EXPECT_EQ(summary.handed_over[0].why, "a persistent contact that no exact phase knows") << g;
  }
}

// The spin that counts is its corners' speed beside the fall through its size, for the smallest too: a tenth of a micrometre.
TEST(Located, ATiltingSpinOfATinyOneIsNoRest) {
  Lying x(skew_face, 1e-7 * V(0.5, 0.25, 1), zero3<double>(), 0, 0.3);
  x.scene.gravity = -9.8 * x.n;
  x.start().w_WB = 1000 * V(x.face.col(0));  // 2e-5 m/s of a corner; the fall: 1e-3 m/s
  x.scene.until = 1e-5, x.scene.dt = 1e-6;
  EXPECT_FALSE(x.run().first.handed_over.empty());
}

}  // namespace
}  // namespace rigor
