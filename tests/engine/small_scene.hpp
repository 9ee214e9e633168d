#pragma once
// A few cuboids of 1 kg among a few planes, and what became of them.
#include <gtest/gtest.h>

#include <rigor/engine/located.hpp>

namespace rigor {

struct SmallScene {
  Scene scene;
  std::vector<State<double>> end;
  SmallScene(const Vec3<double>& gravity, double e, double mu_s, double mu_d, double until) {
    scene.method = "located", scene.gravity = gravity, scene.until = scene.every = until, scene.dt = 1.0 / 64;
    scene.surface = *Surface<double>::make(e, mu_s, mu_d), scene.friction_law = FrictionLaw::sheet;
  }
  SmallScene& plane(const Vec3<double>& at, const Vec3<double>& n) { return scene.planes.push_back(*Plane<double>::make(at, n)), *this; }
  SmallScene& floor() { return plane(zero3<double>(), Vec3<double>(0, 0, 1)); }
  SmallScene& add(const Vec3<double>& size, const Vec3<double>& p, const Vec3<double>& v = zero3<double>(), const Vec3<double>& w = zero3<double>()) {
    State<double> s;
    s.p_WB = p, s.v_WB = v, s.w_WB = w;
    scene.bodies.push_back({*Cuboid<double>::make(1, size), s});
    return *this;
  }
  /// Of the cuboid added last.
  State<double>& start() { return scene.bodies.back().start; }
  RunSummary run() {
    const auto done = simulate_located(scene, [&](double, const std::vector<State<double>>& states) { end = states; });
    EXPECT_TRUE(done);
    return *done;
  }
};

}  // namespace rigor
