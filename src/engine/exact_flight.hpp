#pragma once
#include <array>
#include <rigor/base/outcome.hpp>
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
  Attitude at(double t) const;

  /// Constants of the evaluator, one double each, in evaluation order. Public for the batch, which keeps many
  /// flights as arrays of these.
  struct Tuned {
    enum class Kind { pure_rotation, theta, theta_prime } kind = Kind::pure_rotation;
    std::array<int, 3> axis{0, 1, 2};
    std::array<double, 3> sign{1, 1, 1};
    double time_scale = 1;                   // power of two: evaluator time = time_scale · t
    double n0 = 0, nu_hi = 0, nu_lo = 0;     // half periods
    double w_hi = 0, w_lo = 0, period_hi = 0, period_lo = 0, u0 = 0, omega = 0;  // theta_prime reduction
    double rate_hi = 0, rate_lo = 0, jump_hi = 0, jump_lo = 0;                   // precession, in half turns
    double y_scale = 1;
    std::array<double, 4> sn{}, cn{}, dn{}, denominator{}, arg_x{}, arg_y{};     // cubics in y
    double rho = 0, cos_tilt = 0, sin_tilt = 0;
    std::array<double, 3> L{};               // amplitudes in body order of `axis`, with sign
    std::array<double, 9> C{};               // by rows
    Vec3<double> w_B = zero3<double>(), L_B = zero3<double>();  // pure rotation
    Mat3<double> R0 = identity3<double>();
  };
  const Tuned& tuned() const { return tuned_; }

 private:
  explicit ExactFlight(const Tuned& tuned) : tuned_(tuned) {}
  Tuned tuned_;
};

}  // namespace rigor
