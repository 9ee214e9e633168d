#pragma once
#include <optional>
#include <rigor/bodies/cuboid.hpp>
#include <rigor/engine/exact_flight.hpp>
#include <rigor/formulas/state.hpp>

namespace rigor {

/// A cuboid between two events: constant acceleration of its centre, no torque. Exact at any time, τ in s from its start,
/// so a flight far from t = 0 is as accurate as the first.
class Flight {
 public:
  /// Precondition: a finite state whose R_WB is a rotation. `about`: the body axis it turns about, where a plane keeps it to that one.
  Flight(const Cuboid<double>& shape, const State<double>& start, const Vec3<double>& a_W, std::optional<int> about = {});

  State<double> at(double tau) const;

  const State<double>& start() const { return start_; }
  const Vec3<double>& acceleration() const { return a_W_; }
  /// Bound on |α×r + ω×(ω×r)| over the whole flight for every |r| ≤ `radius`, m/s².
  ///
  /// |ω|² ≤ 2E/I_min for all time, and |α| ≤ |ω|²/√3, because |ω̇_i| = |I_j − I_k|/I_i |ω_j ω_k| and a
  /// cuboid's moments keep |I_j − I_k| ≤ I_i.
  double acceleration_bound(double radius) const { return bound_ * radius; }
  /// What rounding may do to the place of a corner at τ, m: 16 u of the terms of its parabola and of radius × (1 + angle turned).
  double rounding(double tau) const;
  /// Bound on |ω|, rad/s.
  double spin_bound() const { return spin_; }
  /// The same without a flight, for a body that turns with spin ω_B (body axes) now.
  static double spin_bound(const Cuboid<double>& shape, const Vec3<double>& w_B);

 private:
  const Cuboid<double>* shape_;
  State<double> start_;
  Vec3<double> a_W_;
  Vec3<double> w_B_;  // at the start
  ExactFlight attitude_;
  double bound_, spin_;
};

}  // namespace rigor
