#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <rigor/integrators/method.hpp>
#include <rigor/linalg/rotation.hpp>

// What a method is held to, in whatever room its file is.
namespace rigor {

inline const Cuboid<double> plate = *Cuboid<double>::make(2, {1, 2, 3});

/// The plate tumbling: a generic attitude, its centre off the origin, spin about all three axes.
inline State<double> tumbling() {
  State<double> s;
  s.p_WB = Vec3<double>(1, -2, 3);
  s.v_WB = Vec3<double>(0.5, 1, -0.25);
  s.R_WB = rotation_of<double>(Vec4<double>(1, 2, -1, 3));
  s.w_WB = Vec3<double>(0.3, -1, 0.7);
  return s;
}

/// A weight on an arm, a spring, a push that comes and goes: depends on time, place and attitude.
inline Load changing_load(double t, const State<double>& s) {
  const Vec3<double> arm = s.R_WB.col(0);
  return {Vec3<double>(-3 * s.p_WB + Vec3<double>(std::sin(t), 0, 1)),
          Vec3<double>(cross<double>(arm, Vec3<double>(0, -1, 0)) + Vec3<double>(0, 0.5 * std::cos(2 * t), 0))};
}

inline bool says(const Method& m, const char* quantity) { return m.conserves.find(quantity) != std::string_view::npos; }

/// What the method says it conserves, and only that: L to the bit, the energy to rounding, over a thousand steps.
inline void expect_to_conserve_what_it_says(const Method& m) {
  Motion now = motion_of(plate, tumbling());
  const Vec3<double> L = now.L_W;
  const double energy = L.dot(now.state.w_WB) / 2;
  double drift = 0, skew = 0;
  for (int k = 0; k < 1000; ++k) {
    now = m.step(plate, now, {}, 0.01);
    drift = std::fmax(drift, std::fabs(now.L_W.dot(now.state.w_WB) / 2 / energy - 1));
    skew = std::fmax(skew, orthonormality_defect<double>(now.state.R_WB));
  }
  EXPECT_EQ(now.L_W == L, says(m, "L")) << m.name;
  if (says(m, "energy")) {
    EXPECT_LT(drift, 1e-12) << m.name;  // a thousand steps, each solved to a few u
  }
  if (m.name != "euler-naive") {
    EXPECT_LT(skew, 1e-12) << m.name;
  }
}

/// Whether the method is its own inverse with the step turned round. Explicit ones are not.
inline bool symmetric(const Method& m) {
  for (const char* name : {"sheet", "explicit-euler", "euler-naive", "euler-exponential", "euler-quaternion", "euler-momentum", "euler-momentum-cross",
                           "euler-momentum-exponential", "rk4", "dormand-prince", "buss-augmented", "rkmk4", "commutator-free4", "taylor16"})
    if (m.name == name) return false;
  return true;
}

/// There and back, by negative steps: a symmetric method comes to where it began, one of low order does not.
inline void expect_to_come_back_if_symmetric(const Method& m, const LoadAt& load, int order) {
  const Motion start = motion_of(plate, tumbling());
  Motion now = start;
  for (int k = 0; k < 100; ++k) now = advance(m, plate, now, load, 0.02 * k, 0.02);
  for (int k = 100; k > 0; --k) now = advance(m, plate, now, load, 0.02 * k, -0.02);
  const double missed = angle_between<double>(now.state.R_WB, start.state.R_WB) + norm<double>(Vec3<double>(now.state.p_WB - start.state.p_WB)) +
                        norm<double>(Vec3<double>(now.L_W - start.L_W));
  if (symmetric(m)) {
    EXPECT_LT(missed, 1e-12) << m.name;  // 200 steps of a few u, grown by the flow
  } else if (order <= 2) {
    EXPECT_GT(missed, 1e-8) << m.name;  // h³ = 8e-6 a step at the least, of one sign
  }
}

/// The order seen in one step: its error goes as h^(order + 1). The reference makes the same step in sixteen parts. From the last
/// halving of h whose errors stand clear of rounding, 1e-12 and more.
inline double local_order(const Method& m, const Method& reference, const LoadAt& load) {
  const Motion start = motion_of(plate, tumbling());
  const double t = 0.3;
  double seen = NAN, before = NAN;
  for (double h = 3.2; h > 1e-4; h /= 2) {
    Motion want = start;
    for (int k = 0; k < 16; ++k) want = advance(reference, plate, want, load, t + k * h / 16, h / 16);
    const State<double> end = advance(m, plate, start, load, t, h).state;
    const double error = angle_between<double>(end.R_WB, want.state.R_WB) + norm<double>(Vec3<double>(end.p_WB - want.state.p_WB));
    if (std::isnan(error)) continue;  // no solution at so long a step
    if (error < 1e-12) break;
    seen = std::log2(before / error) - 1;
    before = error;
  }
  return seen;
}

}  // namespace rigor
