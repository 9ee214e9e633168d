#pragma once
#include <array>
#include <rigor/base/outcome.hpp>
#include <rigor/engine/flight_lane.hpp>
#include <rigor/linalg/types.hpp>

namespace rigor {

/// Attitude and angular momentum of a body in flight.
struct Attitude {
  Mat3<double> R_WB;
  Vec3<double> L_B;  ///< angular momentum about the centre, body axes; ω_B = L_B / I_B
};

/// Torque-free motion of a rigid body in closed form: set up once, then the attitude at any t at the same cost and
/// with the same accuracy, forwards and backwards. No step, no drift.
///
/// errors    attitude at T = 10 on generic tumbling: 1e-13 rad with plain constants, 5e-15 with extended ones
///           (docs/exact-flight.md has the measured figures); grows like eps·phase over long times
/// source    van Zon and Schofield 2007; Celledoni and others 2008; formulas in docs/exact-flight.md
class ExactFlight {
 public:
  enum class Precision {
    plain,     ///< constants in double: set-up about 1 µs
    extended,  ///< constants in long double, kept as two doubles: set-up about 10 µs
  };

  /// I_B kg·m² principal moments, w_B rad/s body axes, R_WB a rotation.
  /// Faults: not_finite or not_positive, naming "inertia[i]" or "spin[i]".
  static Outcome<ExactFlight> make(const Vec3<double>& I_B, const Vec3<double>& w_B, const Mat3<double>& R_WB,
                                   Precision precision = Precision::extended);

  /// t in s, any sign, finite.
  Attitude at(double t) const noexcept;

  /// Constants of the evaluator. Public for FlightBatch, which keeps many flights as arrays of these.
  struct Tuned {
    enum class Kind { pure_rotation, theta, theta_prime } kind = Kind::pure_rotation;
    std::array<int, 3> axis{};
    detail::FlightNumbers<double> numbers{};
    Vec3<double> w_B = zero3<double>(), L_B = zero3<double>();  // pure rotation
    Mat3<double> R0 = identity3<double>();
  };
  const Tuned& tuned() const { return tuned_; }

 private:
  explicit ExactFlight(const Tuned& tuned) : tuned_(tuned) {}
  Tuned tuned_;
};

}  // namespace rigor
