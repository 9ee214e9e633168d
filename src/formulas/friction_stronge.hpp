#pragma once
#include <array>
#include <cmath>
#include <limits>
#include <rigor/formulas/friction_coulomb.hpp>
#include <rigor/formulas/friction_stronge_planar.hpp>

namespace rigor {

namespace detail {

/// The impact seen in axes (t1, t2, n): tangential block and coupling of K.
struct ImpactAxes {
  double k_nn;
  std::array<double, 2> k_tn;
  std::array<std::array<double, 2>, 2> k_tt;
  double mu_d;
  double v_n0;  ///< normal velocity at the start: the scale of velocities, whatever its sign

  /// Tangential acceleration per unit of p while slipping along (c, s): k_tn − μ K_tt (c, s).
  std::array<double, 2> pull(double c, double s) const {
    return {k_tn[0] - mu_d * (k_tt[0][0] * c + k_tt[0][1] * s), k_tn[1] - mu_d * (k_tt[1][0] * c + k_tt[1][1] * s)};
  }
};

/// State of the slipping process on its own clock τ, dp = r dτ: slip speed r = exp(log_r) and direction psi, impulses,
/// normal speed and work. On this clock a stop takes forever and the equations stay smooth up to it.
struct SlipState {
  double log_r, psi, p, j1, j2, v_n, work;

  SlipState plus(double h, const SlipState& d) const {
    return {log_r + h * d.log_r, psi + h * d.psi, p + h * d.p, j1 + h * d.j1, j2 + h * d.j2, v_n + h * d.v_n, work + h * d.work};
  }
};

inline SlipState slip_rate(const ImpactAxes& a, const SlipState& x) {
  const double c = std::cos(x.psi), s = std::sin(x.psi), r = std::exp(x.log_r);
  const auto f = a.pull(c, s);
  return {f[0] * c + f[1] * s, -f[0] * s + f[1] * c, r, -a.mu_d * c * r, -a.mu_d * s * r,
          r * (a.k_nn - a.mu_d * (a.k_tn[0] * c + a.k_tn[1] * s)), r * x.v_n};
}

/// One step of Dormand and Prince's pair, order 5; `error` is the largest difference to order 4, angles as they are,
/// impulses relative to the impulse that stops the approach, work to its energy.
inline SlipState slip_step(const ImpactAxes& a, const SlipState& x, double h, double& error) {
  const SlipState k1 = slip_rate(a, x);
  const SlipState k2 = slip_rate(a, x.plus(h / 5, k1));
  const SlipState k3 = slip_rate(a, x.plus(h * 3 / 40, k1).plus(h * 9 / 40, k2));
  const SlipState k4 = slip_rate(a, x.plus(h * 44 / 45, k1).plus(-h * 56 / 15, k2).plus(h * 32 / 9, k3));
  const SlipState k5 = slip_rate(a, x.plus(h * 19372 / 6561, k1).plus(-h * 25360 / 2187, k2).plus(h * 64448 / 6561, k3).plus(-h * 212 / 729, k4));
  const SlipState k6 = slip_rate(a, x.plus(h * 9017 / 3168, k1).plus(-h * 355 / 33, k2).plus(h * 46732 / 5247, k3).plus(h * 49 / 176, k4).plus(-h * 5103 / 18656, k5));
  const SlipState y = x.plus(h * 35 / 384, k1).plus(h * 500 / 1113, k3).plus(h * 125 / 192, k4).plus(-h * 2187 / 6784, k5).plus(h * 11 / 84, k6);
  const SlipState k7 = slip_rate(a, y);
  const SlipState zero{};
  const SlipState d = zero.plus(h * 71 / 57600, k1).plus(-h * 71 / 16695, k3).plus(h * 71 / 1920, k4).plus(-h * 17253 / 339200, k5).plus(h * 22 / 525, k6).plus(-h / 40, k7);
  const double p_unit = a.v_n0 / a.k_nn;
  error = std::fmax(std::fmax(std::fabs(d.psi), std::fabs(d.log_r)),
                    std::fmax(std::fabs(d.p / p_unit), std::fabs(d.work / (p_unit * a.v_n0))));
  return y;
}

/// Whether the slip has turned as far as it will: its direction is attracted by one less than 1e-13 rad away. From
/// there on the slip is straight and everything linear in p. (On the clock of SlipState a straight slip near the
/// critical friction, where it neither grows nor shrinks, would take for ever.)
inline bool settled(const ImpactAxes& a, double psi) {
  const double c = std::cos(psi), s = std::sin(psi);
  const auto f = a.pull(c, s);
  const double turn = -f[0] * s + f[1] * c, along = f[0] * c + f[1] * s;
  const double across = s * (a.k_tt[0][0] * s - a.k_tt[0][1] * c) - c * (a.k_tt[1][0] * s - a.k_tt[1][1] * c);
  return std::fabs(turn) <= 1e-13 * (a.mu_d * across + along);  // d turn/d psi is minus the bracket
}

/// Where the impact stands, and its progress along legs on which v_n is linear in p.
struct Progress {
  double e;
  SlipState x;
  double work_c = 0;  ///< ∫ v_n dp over compression, < 0, once it has ended
  bool compressed = false, ended = false;

  /// ≥ 0 when the present phase is over.
  double goal(const SlipState& y) const { return compressed ? y.work - (1 - e * e) * work_c : y.v_n; }
  void end_phase() {
    ended = compressed || e == 0;
    if (!compressed) work_c = x.work;
    compressed = true;
  }
  void advance(double a1, double a2, double slope, double dp) {
    x.p += dp, x.j1 += a1 * dp, x.j2 += a2 * dp;
    x.work += (x.v_n + slope * dp / 2) * dp;
    x.v_n += slope * dp;
  }

  /// With tangential impulse (a1, a2) per unit of p, until the impact ends or p has grown by `limit`.
  void follow(const ImpactAxes& a, double a1, double a2, double limit) {
    const double slope = a.k_nn + a1 * a.k_tn[0] + a2 * a.k_tn[1];
    if (!compressed) {
      const double dp = slope > 0 ? -x.v_n / slope : limit;  // a leg that jams ends at its limit, where the slip stops
      advance(a1, a2, slope, std::fmin(dp, limit));
      if (!(slope > 0) || dp > limit) return;
      x.v_n = 0;
      limit -= dp;
      end_phase();
      if (ended) return;
    }
    const double left = std::fmax(0.0, -goal(x));  // work still to come back
    const double square = x.v_n * x.v_n + 2 * slope * left, root = std::sqrt(std::fmax(0.0, square));
    const bool reached = left == 0 || (square >= 0 && (x.v_n > 0 || slope > 0));
    const double dp = left == 0 ? 0 : x.v_n > 0 ? 2 * left / (x.v_n + root) : (root - x.v_n) / slope;
    ended = reached && dp <= limit;
    advance(a1, a2, slope, ended ? dp : limit);
  }
};

/// Direction in which a slip starts again after a stop that friction cannot hold: k_tn − μ K_tt s = κ s, κ > 0.
/// A fixed point of direction → direction of pull; bisection on the angle between the pull and s.
inline double restart_direction(const ImpactAxes& a) {
  const double start = std::atan2(a.k_tn[1], a.k_tn[0]);
  const auto turn = [&](double psi) {  // > 0: the pull lies to the left of s
    const auto f = a.pull(std::cos(psi), std::sin(psi));
    return f[1] * std::cos(psi) - f[0] * std::sin(psi);
  };
  double low = start - 2 * std::atan(1.0), high = start + 2 * std::atan(1.0);  // ± a quarter turn
  for (int i = 0; i < 200 && low < high; ++i) {
    const double middle = low + (high - low) / 2;
    if (middle == low || middle == high) break;
    (turn(middle) > 0 ? low : high) = middle;
  }
  return low;
}

}  // namespace detail

/// Three-dimensional impact with friction and energetic restitution: while the contact slips, the direction of the
/// slip turns, so the process is an ODE in the normal impulse p.
///
///     dv/dp = K (n − μ_d s),  s = v_t/|v_t|;   stop: stick if |K_tt⁻¹ k_tn| ≤ μ_s, else slip starts again straight on;
///     ends where ∫ v_n dp over restitution = −e² ∫ v_n dp over compression
///
/// A slip below 16u |v_r| counts as none. Never adds energy, always ends (K positive definite makes every lasting leg push the bodies apart).
///
/// shapes    (3×3), (3), (3), scalars → impulse on B and what happened
/// units     1/kg, m/s, 1 → N·s
/// frames    world axes; n from A to B
/// scalars   double: an adaptive fifth-order method, local tolerance 1e-13 in slip direction
/// domain    v_r·n < 0, K positive definite, 0 ≤ e ≤ 1, 0 ≤ μ_d ≤ μ_s
/// rounding  about 1e-11 relative, measured against the planar closed form and a fine fixed-step solution
/// id        friction.stronge
/// source    Keller 1986; Stronge 1990; Batlle 1996; derivation in proofs/friction.md
inline FrictionImpact<double> stronge_impulse(const Mat3<double>& K, const Vec3<double>& v_r, const Vec3<double>& n,
                                              double e, double mu_s, double mu_d) {
  using detail::SlipState;
  const double v_n = dot<double>(v_r, n);
  Vec3<double> t1(v_r - v_n * n);
  const double slip = norm<double>(t1), none = 16 * 0x1p-53 * norm<double>(v_r);  // a slip below `none` is rounding
  const bool slips = slip > none;
  if (!slips) {  // any tangent will do
    int least;
    n.cwiseAbs().minCoeff(&least);
    t1 = Vec3<double>::Unit(least);
  }
  t1 -= dot<double>(t1, n) * n;  // once more: a slip of 1e-10 |v_r| leaves t1 off the plane by 1e-6
  t1 /= norm<double>(t1);
  const Vec3<double> t2 = cross<double>(n, t1), Kn = apply<double>(K, n), K1 = apply<double>(K, t1), K2 = apply<double>(K, t2);
  const detail::ImpactAxes axes{dot<double>(n, Kn), {dot<double>(t1, Kn), dot<double>(t2, Kn)},
                                {{{dot<double>(t1, K1), dot<double>(t1, K2)}, {dot<double>(t2, K1), dot<double>(t2, K2)}}}, mu_d, v_n};

  detail::Progress now{e, {slips ? std::log(slip) : 0, 0, 0, 0, 0, v_n, 0}};
  SlipState& x = now.x;
  if (slips) {
    const double stopped = std::log(none);
    double h = 0.1 / (axes.k_nn + axes.k_tt[0][0] + axes.k_tt[1][1]);
    while (!now.ended && x.log_r > stopped) {
      if (detail::settled(axes, x.psi)) {  // straight on, for good or until the slip stops
        const double c = std::cos(x.psi), s = std::sin(x.psi);
        const auto f = axes.pull(c, s);
        const double along = f[0] * c + f[1] * s;
        now.follow(axes, -mu_d * c, -mu_d * s, along < 0 ? -std::exp(x.log_r) / along : std::numeric_limits<double>::infinity());
        break;
      }
      double error;
      SlipState y = detail::slip_step(axes, x, h, error);
      if (!(error <= 1e-13) && h > 1e-12) {
        h *= std::fmax(0.2, 0.9 * std::pow(1e-13 / error, 0.2));
        continue;
      }
      const bool over = now.goal(y) >= 0;
      if (over) {  // the end of this phase lies inside the step: shorten the step until it is its end
        double low = 0, high = h;
        for (int i = 0; i < 100; ++i) {
          const double middle = 0.5 * (low + high);
          if (middle <= low || middle >= high) break;
          double ignored;
          (now.goal(detail::slip_step(axes, x, middle, ignored)) >= 0 ? high : low) = middle;
        }
        y = detail::slip_step(axes, x, high, error);
      } else {
        h *= std::fmin(4.0, 0.9 * std::pow(1e-13 / std::fmax(error, 1e-18), 0.2));
      }
      x = y;
      if (over) now.end_phase();
    }
  }

  FrictionOutcome outcome = FrictionOutcome::slid;
  if (!now.ended) {  // slip has stopped, or never was
    double a1 = 0, a2 = 0;  // tangential impulse per unit of p
    const double det = axes.k_tt[0][0] * axes.k_tt[1][1] - axes.k_tt[0][1] * axes.k_tt[1][0];
    const double h1 = -(axes.k_tt[1][1] * axes.k_tn[0] - axes.k_tt[0][1] * axes.k_tn[1]) / det;
    const double h2 = -(axes.k_tt[0][0] * axes.k_tn[1] - axes.k_tt[1][0] * axes.k_tn[0]) / det;
    if (mu_s > 0 && h1 * h1 + h2 * h2 <= mu_s * mu_s) {  // without friction there is nothing to stick to
      a1 = h1, a2 = h2;
      outcome = FrictionOutcome::stuck;
    } else {
      const double psi = detail::restart_direction(axes);
      a1 = -mu_d * std::cos(psi), a2 = -mu_d * std::sin(psi);
    }
    now.follow(axes, a1, a2, std::numeric_limits<double>::infinity());
  }
  return {Vec3<double>(x.p * n + x.j1 * t1 + x.j2 * t2), outcome};
}

}  // namespace rigor
