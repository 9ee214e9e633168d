#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <rigor/contact/impact.hpp>
#include <rigor/formulas/friction_coulomb.hpp>
#include <rigor/formulas/friction_sheet.hpp>
#include <rigor/formulas/friction_stronge.hpp>
#include <rigor/formulas/friction_stronge_planar.hpp>
#include <tests/exact/draw.hpp>

namespace rigor {
namespace {

/// An approaching contact whose slip has a rational direction: K of two cuboids, v_r = v_n n + v_t t.
struct Slipping {
  Mat3<Q> K;
  Vec3<Q> n, t, v_r;
  Q v_n, v_t, e, mu_s, mu_d;
};

Slipping draw_slipping(Draw& draw) {
  const Meeting m = draw_meeting(draw);
  const Mat3<Q> R = draw.rotation();
  Slipping s{effective_inverse_mass<Q>(m.A(), m.B()),
             R.col(0),
             R.col(1),
             {},
             -draw.positive(),
             draw.positive(),
             m.e,
             {},
             {}};
  s.v_r = s.v_n * s.n + s.v_t * s.t;
  s.mu_s = draw.positive() / Q(4);  // in [0, 2]
  s.mu_d = s.mu_s * draw.fraction();
  return s;
}

Vec3<Q> after(const Slipping& s, const Vec3<Q>& j) { return s.v_r + s.K * j; }

/// Routh's process followed moment by moment: the witness of planar_impulse. It knows Coulomb's law at one
/// moment and that velocities are linear between events; nothing about how many legs there are.
struct Process {
  Q k_nn, k_tt, k_tn, mu_s, mu_d;
  Q v_n, v_t, p = 0, j_t = 0, work_n = 0, work_t = 0;

  /// dj_t/dp now.
  Q friction() const {
    if (Q(0) < v_t) return -mu_d;
    if (v_t < Q(0)) return mu_d;
    if (abs(k_tn) <= mu_s * k_tt) return -k_tn / k_tt;
    return k_tn < Q(0) ? mu_d : -mu_d;
  }
  /// Moves on by dp, within which the slip keeps its sign.
  void move(const Q& dp) {
    const Q a = friction(), n_before = v_n, t_before = v_t;
    v_n += (k_nn + a * k_tn) * dp;
    v_t += (k_tn + a * k_tt) * dp;
    p += dp;
    j_t += a * dp;
    work_n += (n_before + v_n) / Q(2) * dp;
    work_t += (t_before + v_t) / Q(2) * a * dp;
  }
  /// Impulse until the slip stops, or `limit` if it does not before.
  Q until_stop(const Q& limit) const {
    const Q rate = k_tn + friction() * k_tt;
    if (v_t == Q(0) || !(v_t * rate < Q(0))) return limit;
    const Q stop = -v_t / rate;
    return stop < limit ? stop : limit;
  }
  void move_to(const Q& end) {
    while (p < end) move(until_stop(end - p));
  }
  /// To the moment where v_n = target, v_n below it now. On a leg where v_n falls, to its end.
  void move_until_v_n(const Q& target) {
    while (v_n < target) {
      const Q slope = k_nn + friction() * k_tn, stop = until_stop(Q(1000000));
      const Q wanted = slope > Q(0) ? (target - v_n) / slope : stop;
      move(stop < wanted ? stop : wanted);
    }
  }
};

Process process_of(const PlanarImpact<Q>& i) {
  return {i.k_nn, i.k_tt, i.k_tn, i.mu_s, i.mu_d, i.v_n, i.v_t};
}

PlanarImpact<Q> draw_planar(Draw& draw) {
  PlanarImpact<Q> i;
  i.k_nn = draw.positive();
  i.k_tt = draw.positive();
  // a coupling with k_tn² < k_nn k_tt: |k_tn| below the smaller of the two
  const Q smaller = i.k_nn < i.k_tt ? i.k_nn : i.k_tt;
  i.k_tn = (draw.fraction() * Q(2) - Q(1)) * smaller;
  i.v_n = -draw.positive();
  i.v_t = draw.integer(0, 7) == 0 ? Q(0) : draw.positive();
  i.mu_s = draw.positive() / Q(4);
  i.mu_d = i.mu_s * draw.fraction();
  i.e = draw.fraction();
  return i;
}

Q energy_change(const PlanarImpact<Q>& i, const PlanarImpulse<Q>& j) {
  const Q v_n = i.v_n + i.k_nn * j.j_n + i.k_tn * j.j_t, v_t = i.v_t + i.k_tn * j.j_n + i.k_tt * j.j_t;
  return (j.j_n * (i.v_n + v_n) + j.j_t * (i.v_t + v_t)) / Q(2);
}

// The cube's corner of the catalogue: m = 1, edge 1, contact at (−1/2, −1/2): I = 1/6, k_nn = k_tt = 1 + 6/4.
PlanarImpact<Q> corner(const Q& mu) { return {Q(5, 2), Q(5, 2), Q(-3, 2), Q(-1), Q(1, 2), Q(1), mu, mu}; }

}  // namespace

// The sheet's rule for a point mass.
// id: friction.sheet
TEST(SheetFriction, StopsAPointMassIfTheStaticBoundAllowsItAndNeverReversesIt) {
  Draw draw(61);
  int stopped = 0, slid = 0;
  for (int i = 0; i < 40; ++i) {
    const Q m = draw.positive(), j_r = draw.positive(), s = draw.positive(), mu_s = draw.positive();
    const Q mu_d = mu_s * draw.fraction();
    const Q j = sheet_friction_impulse<Q>(m, mu_s, mu_d, j_r, s), s_after = s - j / m;
    EXPECT_GE(j, Q(0));
    EXPECT_LE(j, mu_s * j_r);
    EXPECT_GE(s_after, Q(0));
    if (m * s <= mu_s * j_r) {
      EXPECT_EQ(s_after, Q(0));
      ++stopped;
    } else {
      EXPECT_EQ(j, mu_d * j_r);
      ++slid;
    }
  }
  EXPECT_EQ(sheet_friction_impulse<Q>(Q(2), Q(1, 2), Q(1, 4), Q(4), Q(1)), Q(2));  // m s = μ_s j_r: it sticks
  EXPECT_EQ(sheet_friction_impulse<Q>(Q(2), Q(1, 2), Q(1, 4), Q(4), Q(11, 10)),
            Q(1));  // just beyond: μ_d j_r
  EXPECT_GT(stopped, 0);
  EXPECT_GT(slid, 0);
}

// The printed conditions: the static coefficient has no say, and a small slip of a point mass is reversed.
// id: friction.sheet_literal
TEST(SheetLiteralFriction, GivesEverySlipTheFullDynamicImpulseAndReversesSmallOnes) {
  Draw draw(62);
  for (int i = 0; i < draws; ++i) {
    const Q m = draw.positive(), j_r = draw.positive(), mu_d = draw.positive(), part = draw.fraction();
    const Q s = part * mu_d * j_r / m;
    EXPECT_EQ(sheet_literal_friction_impulse<Q>(mu_d, j_r, s), mu_d * j_r);
    EXPECT_LE(s - sheet_literal_friction_impulse<Q>(mu_d, j_r, s) / m, Q(0));
    EXPECT_EQ(sheet_literal_friction_impulse<Q>(mu_d, j_r, Q(0)), Q(0));
  }
}

TEST(ImpulseCancelling, SolvesTheSystem) {
  Draw draw(63);
  for (int i = 0; i < draws; ++i) {
    const Slipping s = draw_slipping(draw);
    EXPECT_EQ(Vec3<Q>(s.K * impulse_cancelling<Q>(s.K, s.v_r)), Vec3<Q>(-s.v_r));
  }
}

// Every outcome obeys the law it names. case FR-09 is the uncoupled special case below.
// id: friction.coulomb
TEST(CoulombFriction, ObeysNewtonsRestitutionAndTheConeInEveryOutcome) {
  Draw draw(64);
  std::map<FrictionOutcome, int> seen;
  for (int i = 0; i < 200; ++i) {
    const Slipping s = draw_slipping(draw);
    const auto [j, outcome] = coulomb_impulse<Q>(s.K, s.v_r, s.n, s.t, s.e, s.mu_s, s.mu_d);
    ++seen[outcome];
    const Vec3<Q> v = after(s, j), v_t = v - v.dot(s.n) * s.n, j_t = j - j.dot(s.n) * s.n;
    const Q j_n = j.dot(s.n);
    EXPECT_EQ(v.dot(s.n), -s.e * s.v_n);
    EXPECT_GT(j_n, Q(0));
    EXPECT_LE(j_t.dot(j_t), s.mu_s * s.mu_s * j_n * j_n);
    const Vec3<Q> stick = impulse_cancelling<Q>(s.K, Vec3<Q>(s.v_r + s.e * s.v_n * s.n)),
                  stick_t = stick - stick.dot(s.n) * s.n;
    const bool holds =
        stick.dot(s.n) >= Q(0) && stick_t.dot(stick_t) <= s.mu_s * s.mu_s * stick.dot(s.n) * stick.dot(s.n);
    EXPECT_EQ(outcome == FrictionOutcome::stuck, holds);
    const bool sliding = outcome == FrictionOutcome::slid || outcome == FrictionOutcome::slip_stopped_inside;
    if (outcome == FrictionOutcome::stuck) {
      EXPECT_EQ(v_t, zero3<Q>());
    }
    if (sliding) {
      EXPECT_EQ(j_t, Vec3<Q>(-s.mu_d * j_n * s.t));
      EXPECT_EQ(v.dot(s.t) < Q(0), outcome == FrictionOutcome::slip_stopped_inside);
    }
    if (outcome == FrictionOutcome::jammed) {
      EXPECT_EQ(j_t, zero3<Q>());
      EXPECT_LE(s.n.dot(Vec3<Q>(s.K * (s.n - s.mu_d * s.t))), Q(0));
    }
  }
  for (const FrictionOutcome outcome :
       {FrictionOutcome::stuck, FrictionOutcome::slid, FrictionOutcome::slip_stopped_inside})
    EXPECT_GT(seen[outcome], 5);
}

// case FR-15: where sliding has no solution the answer says so, and only there. The slip runs into the
// contact with k_tn = 1/2, k_nn = 2, so the bound is μ = 4; the coupling across makes the stick trial ask for
// |j_t|/j_n = 4.64.
TEST(CoulombFriction, SaysJammedFromTheVanishingDenominatorOn) {
  Mat3<Q> K;  // axes t, n, across
  K << Q(3), Q(1, 2), Q(-1, 2), Q(1, 2), Q(2), Q(-1, 2), Q(-1, 2), Q(-1, 2), Q(3);
  const Vec3<Q> t(Q(1), Q(0), Q(0)), n(Q(0), Q(1), Q(0)), v_r = Q(1000) * t - n;
  const auto outcome = [&](const Q& mu) { return coulomb_impulse<Q>(K, v_r, n, t, Q(1), mu, mu).outcome; };
  EXPECT_EQ(outcome(Q(4) - Q(1, 1000)), FrictionOutcome::slip_stopped_inside);
  EXPECT_EQ(outcome(Q(4)), FrictionOutcome::jammed);
  EXPECT_EQ(outcome(Q(9, 2)), FrictionOutcome::jammed);
  EXPECT_EQ(outcome(Q(5)), FrictionOutcome::stuck);
}

// Jammed, and without friction at all, the answer is the frictionless impulse, along n whatever way n points.
TEST(CoulombFriction, WithoutASlidingSolutionOrWithoutFrictionIsTheFrictionlessImpulse) {
  Draw draw(67);
  Mat3<Q> jam;  // axes t, n, across, as above
  jam << Q(3), Q(1, 2), Q(-1, 2), Q(1, 2), Q(2), Q(-1, 2), Q(-1, 2), Q(-1, 2), Q(3);
  for (int i = 0; i < 20; ++i) {
    const Mat3<Q> R = draw.rotation(), K = R * jam * R.transpose();
    const Vec3<Q> t = R.col(0), n = R.col(1), v_r = draw.positive() * (Q(1000) * t - n);
    const Q e = draw.fraction(), j_n = -(Q(1) + e) * v_r.dot(n) / Q(2);
    const auto jammed = coulomb_impulse<Q>(K, v_r, n, t, e, Q(9, 2), Q(9, 2));
    EXPECT_EQ(jammed.outcome, FrictionOutcome::jammed);
    EXPECT_EQ(jammed.j_W, Vec3<Q>(j_n * n));
    const auto smooth = coulomb_impulse<Q>(K, v_r, n, t, e, Q(0), Q(0));
    EXPECT_EQ(smooth.outcome, FrictionOutcome::slid);
    EXPECT_EQ(smooth.j_W, Vec3<Q>(j_n * n));
  }
}

// A slide whose slip is just used up at the end slid; it did not stop inside. (The coupling across keeps it from sticking.)
TEST(CoulombFriction, ASlideThatEndsWithNoSlipAlongIsASlide) {
  Mat3<Q> K;  // axes t, n, across
  K << Q(3), Q(1, 2), Q(-1, 2), Q(1, 2), Q(2), Q(-1, 2), Q(-1, 2), Q(-1, 2), Q(3);
  const Vec3<Q> t(Q(1), Q(0), Q(0)), n(Q(0), Q(1), Q(0));
  const Q j_n = Q(1) / (Q(2) - Q(1, 8)), slip = -(Q(3) * (-j_n / Q(4)) + j_n / Q(2));
  EXPECT_EQ(coulomb_impulse<Q>(K, Vec3<Q>(slip * t - n), n, t, Q(0), Q(1, 4), Q(1, 4)).outcome, FrictionOutcome::slid);
  EXPECT_EQ(coulomb_impulse<Q>(K, Vec3<Q>((slip - Q(1, 10000)) * t - n), n, t, Q(0), Q(1, 4), Q(1, 4)).outcome, FrictionOutcome::slip_stopped_inside);
}

// On the border of the cone it sticks: 0 coupling, |j_t| = mu_s j_n exactly.
TEST(CoulombFriction, SticksOnTheBorderOfTheCone) {
  const Vec3<Q> t(Q(1), Q(0), Q(0)), n(Q(0), Q(1), Q(0));
  const Mat3<Q> K = Vec3<Q>(Q(5, 2), Q(1), Q(4)).asDiagonal();
  const auto at = [&](const Q& v_t) { return coulomb_impulse<Q>(K, Vec3<Q>(v_t * t - n), n, t, Q(1, 2), Q(1, 3), Q(1, 4)).outcome; };
  const Q border = Q(5, 2) * Q(1, 3) * Q(3, 2);  // k_tt mu_s (1 + e)/k_nn
  EXPECT_EQ(at(border), FrictionOutcome::stuck);
  EXPECT_EQ(at(border + Q(1, 1000000)), FrictionOutcome::slid);
}

// case FR-14: a cube's planar corner has its Painlevé bound at μ = 5/3. In the plane the bound is never met:
// with μ ≥ k_nn/k_tn the stick trial's |j_t|/j_n = (k_nn v_t + k_tn a)/(k_tn v_t + k_tt a) is a mediant of
// k_nn/k_tn and k_tn/k_tt < k_nn/k_tn.
TEST(CoulombFriction, InThePlaneSticksBeforeItCouldJam) {
  Mat3<Q> K;
  K << Q(5, 2), Q(3, 2), Q(0), Q(3, 2), Q(5, 2), Q(0), Q(0), Q(0), Q(4);
  const Vec3<Q> t(Q(1), Q(0), Q(0)), n(Q(0), Q(1), Q(0));
  EXPECT_EQ(n.dot(Vec3<Q>(K * (n - Q(5, 3) * t))), Q(0));
  for (long v_t : {1L, 9L, 1000L, 1000000L})
    EXPECT_EQ(coulomb_impulse<Q>(K, Vec3<Q>(Q(v_t) * t - n), n, t, Q(1), Q(5, 3), Q(5, 3)).outcome,
              FrictionOutcome::stuck);
}

// case FR-09: without coupling j_t = −min(μ j_n, v_t/k_tt), j_n = −(1 + e)v_n/k_nn; a cube's face centre that
// sticks keeps 3/5 of its speed: k_tt = 1 + 6/4, v_x' = v_x − v_x/k_tt = 3/5 v_x.
TEST(CoulombFriction, WithoutCouplingIsTheClampedStop) {
  Draw draw(65);
  for (int i = 0; i < 40; ++i) {
    const Mat3<Q> R = draw.rotation();
    const Vec3<Q> t = R.col(0), n = R.col(1);
    const Q k_tt = draw.positive(), k_nn = draw.positive(), mu = draw.positive() / Q(4), e = draw.fraction();
    const Q v_n = -draw.positive(), v_t = draw.positive();
    const Mat3<Q> K = R * Vec3<Q>(k_tt, k_nn, draw.positive()).asDiagonal() * R.transpose();
    const Vec3<Q> j = coulomb_impulse<Q>(K, Vec3<Q>(v_n * n + v_t * t), n, t, e, mu, mu).j_W;
    const Q j_n = -(Q(1) + e) * v_n / k_nn, bound = mu * j_n, stop = v_t / k_tt;
    EXPECT_EQ(j, Vec3<Q>(j_n * n - (stop < bound ? stop : bound) * t));
  }
  Mat3<Q> K = identity3<Q>() * Q(5, 2);
  K(1, 1) = 1;
  const Vec3<Q> t(Q(1), Q(0), Q(0)), n(Q(0), Q(1), Q(0)), v_r(Q(1, 2), Q(-1), Q(0));
  EXPECT_EQ(coulomb_impulse<Q>(K, v_r, n, t, Q(0), Q(1), Q(1)).j_W[0], Q(-1, 5));  // Δv_x = −2/5 · 1/2
}

// The last moment is named by where the pull goes: with k_tn > 0, too strong to hold, it slides on along +t although k_tn < 1.
TEST(PlanarImpact, NamesTheModeByTheSignOfTheCoupling) {
  const auto mode = [](const Q& k_tn, const Q& mu) { return planar_impulse<Q>({Q(3), Q(1), k_tn, Q(-1), Q(0), Q(0), mu, mu}, Restitution::poisson).mode; };
  EXPECT_EQ(mode(Q(1, 2), Q(1, 4)), PlanarMode::sliding);
  EXPECT_EQ(mode(Q(-1, 2), Q(1, 4)), PlanarMode::reversed);
  EXPECT_EQ(mode(Q(1, 2), Q(1, 2)), PlanarMode::sticking) << "on the border static friction holds";
  for (const Restitution rule : {Restitution::poisson, Restitution::newton})  // fast: slips on to the end, where it would have stuck
    EXPECT_EQ(planar_impulse<Q>({Q(3), Q(1), Q(1, 2), Q(-1), Q(100), Q(1, 2), Q(1), Q(3, 4)}, rule).mode, PlanarMode::sliding);
}

// case FR-13: against the process, leg by leg, for random planar impacts in all modes.
// id: friction.stronge_planar
TEST(PlanarImpact, IsTheProcessFollowedMomentByMoment) {
  Draw draw(66);
  std::map<PlanarMode, int> seen;
  for (int i = 0; i < 200; ++i) {
    const PlanarImpact<Q> impact = draw_planar(draw);
    Process process = process_of(impact);
    process.move_until_v_n(Q(0));
    const Q p_c = process.p;

    const PlanarImpulse<Q> poisson = planar_impulse<Q>(impact, Restitution::poisson);
    Process to_poisson = process;
    to_poisson.move_to((Q(1) + impact.e) * p_c);
    EXPECT_EQ(poisson.j_n, to_poisson.p);
    EXPECT_EQ(poisson.j_t, to_poisson.j_t);
    EXPECT_EQ(energy_change(impact, poisson), to_poisson.work_n + to_poisson.work_t);
    ++seen[poisson.mode];

    const PlanarImpulse<Q> newton = planar_impulse<Q>(impact, Restitution::newton);
    Process to_newton = process;
    to_newton.move_until_v_n(-impact.e * impact.v_n);
    EXPECT_EQ(newton.j_n, to_newton.p);
    EXPECT_EQ(newton.j_t, to_newton.j_t);
  }
  EXPECT_GT(seen[PlanarMode::sliding], 5);
  EXPECT_GT(seen[PlanarMode::sticking], 5);
  EXPECT_GT(seen[PlanarMode::reversed], 5);
}

// Stronge's end is a root; it is rational where v² + 2σw is a square. The end p_f is drawn, and e² follows
// from the works of the process, e² = −W_r/W_c; where that e is rational and at most 1 the law must find p_f
// again.
TEST(PlanarImpact, EndsByStrongesRuleWhereTheWorksSaySo) {
  Draw draw(67);
  int found = 0, two_legs = 0, stops_in_restitution = 0;
  for (int i = 0; i < 100000 && (found < 60 || stops_in_restitution < 5); ++i) {
    // small numbers, so that squares are not too rare
    PlanarImpact<Q> impact{Q(draw.integer(1, 4)),
                           Q(draw.integer(1, 4)),
                           Q(0),
                           Q(-draw.integer(1, 4)),
                           Q(draw.integer(0, 4)),
                           Q(0),
                           Q(0),
                           Q(0)};
    const long smaller = impact.k_nn < impact.k_tt ? long(double(impact.k_nn)) : long(double(impact.k_tt));
    impact.k_tn = Q(draw.integer(-2 * smaller + 1, 2 * smaller - 1), 2);
    impact.mu_s = Q(draw.integer(0, 8), 4), impact.mu_d = impact.mu_s;
    Process process = process_of(impact);
    process.move_until_v_n(Q(0));
    const Q p_c = process.p, W_c = process.work_n;
    const bool slips_on = Q(0) < process.v_t;
    process.move_to(p_c * (Q(1) + Q(draw.integer(0, 6), 6)));
    const Q e_squared = -(process.work_n - W_c) / W_c;
    if (Q(1) < e_squared) continue;
    try {
      impact.e = sqrt(e_squared);
    } catch (const std::domain_error&) {
      continue;
    }
    const PlanarImpulse<Q> j = planar_impulse<Q>(impact, Restitution::stronge);
    EXPECT_EQ(j.j_n, process.p);
    EXPECT_EQ(j.j_t, process.j_t);
    EXPECT_EQ(energy_change(impact, j), (Q(1) - e_squared) * W_c + process.work_t);
    EXPECT_LE(energy_change(impact, j), Q(0));
    ++found;
    two_legs += Q(0) < impact.v_t && j.mode != PlanarMode::sliding;
    stops_in_restitution += slips_on && j.mode != PlanarMode::sliding;
  }
  EXPECT_GE(found, 60);
  EXPECT_GT(two_legs, 5);
  EXPECT_GE(stops_in_restitution, 5);
}

// case FR-10, FR-12: the published fractions of the cube's corner.
TEST(PlanarImpact, HasTheFractionsOfTheCubesCorner) {
  const PlanarImpact<Q> sticks = corner(Q(1)), reverses = corner(Q(1, 2));
  const auto newton = planar_impulse<Q>(sticks, Restitution::newton);
  EXPECT_EQ(newton.j_t, Q(7, 16));
  EXPECT_EQ(newton.j_n, Q(17, 16));
  EXPECT_EQ(energy_change(sticks, newton), Q(7, 64));  // Newton creates energy
  const auto poisson = planar_impulse<Q>(sticks, Restitution::poisson);
  EXPECT_EQ(poisson.j_t, Q(13, 40));
  EXPECT_EQ(poisson.j_n, Q(7, 8));
  EXPECT_EQ(energy_change(sticks, poisson), Q(-1, 20));

  const auto reversed = planar_impulse<Q>(reverses, Restitution::poisson);
  EXPECT_EQ(reversed.mode, PlanarMode::reversed);
  EXPECT_EQ(reversed.j_n, Q(64, 77));
  EXPECT_EQ(double(energy_change(reverses, reversed)), -0.0738741777702816664);
  EXPECT_EQ(double(energy_change(reverses, planar_impulse<Q>(reverses, Restitution::newton))),
            0.0465508517456569405);
}

// case FR-10, FR-12: Stronge's ends are roots; published to 20 digits. Bound: the header's 32 u times 25/16.
TEST(PlanarImpact, HasStrongesDigitsOfTheCubesCorner) {
  const auto in_double = [](const PlanarImpact<Q>& i) {
    return PlanarImpact<double>{double(i.k_nn), double(i.k_tt), double(i.k_tn), double(i.v_n),
                                double(i.v_t),  double(i.e),    double(i.mu_s), double(i.mu_d)};
  };
  const double bound = 50 * 0x1p-53;
  const auto sticks = planar_impulse<double>(in_double(corner(Q(1))), Restitution::stronge);
  EXPECT_NEAR(sticks.j_n, 0.90101240544347893429, bound);
  EXPECT_NEAR(sticks.j_t, 0.34060744326608736058, bound);
  const auto reverses = planar_impulse<double>(in_double(corner(Q(1, 2))), Restitution::stronge);
  EXPECT_NEAR(reverses.j_n, 0.863965623419014773, bound);
  EXPECT_NEAR(reverses.j_t, 0.250164629891325568, bound);
  // dE = −1/32 and −0.05181…: for e = 1 friction's work alone
  const auto energy = [](double k, double k_tn, const PlanarImpulse<double>& j) {
    return j.j_t * (0.5 + (k * j.j_t + k_tn * j.j_n) / 2) + j.j_n * (-1 + (k * j.j_n + k_tn * j.j_t) / 2);
  };
  EXPECT_NEAR(energy(2.5, -1.5, sticks), -1.0 / 32, 4 * bound);
  EXPECT_NEAR(energy(2.5, -1.5, reverses), -0.0518100934824328402, 4 * bound);
}

// A slip that stops as the impact ends has slid, under every rule: K = 1, mu = 1, so p_f = p_stop = v_t.
// id: friction.stronge_planar
TEST(PlanarImpact, ASlipThatStopsAtTheEndHasSlid) {
  for (const Restitution rule : {Restitution::stronge, Restitution::poisson, Restitution::newton})
    for (const Q& e : {Q(0), Q(1, 2), Q(1)}) {
      const auto impulse = [&](const Q& v_t) {
        return planar_impulse<Q>({Q(1), Q(1), Q(0), Q(-1), v_t, e, Q(1), Q(1)}, rule);
      };
      EXPECT_EQ(impulse(Q(1) + e).mode, PlanarMode::sliding);
      EXPECT_EQ(impulse(Q(1) + e).j_n, Q(1) + e);
      EXPECT_EQ(impulse(Q(1) + e - Q(1, 1000)).mode, PlanarMode::sticking);
    }
}

// case FR-11: the cube's corner again, with friction added to the frictionless impulse j_r = 4/5. Taken
// against the slip before, dE = 14/25 μ + 4/5 μ²; clamped with 1/k_tt still +19/100 from μ = 1/4 on. The
// sheet's rule (slip after, own mass) gives +49/400 at μ = 1 and leaves the corner approaching: the report
// says so.
TEST(SheetFriction, AddedToTheFrictionlessImpulseCreatesEnergyAndSaysSo) {
  const PlanarImpact<Q> c = corner(Q(1));
  const Q j_r(4, 5);
  for (const Q& mu : {Q(1, 10), Q(1, 2), Q(1)})
    EXPECT_EQ(energy_change(c, {j_r, -mu * j_r, PlanarMode::sliding}), Q(14, 25) * mu + Q(4, 5) * mu * mu);
  EXPECT_EQ(energy_change(c, {j_r, -c.v_t / c.k_tt, PlanarMode::sliding}), Q(19, 100));

  const Cuboid<Q> cube = *Cuboid<Q>::make(Q(1), {Q(1), Q(1), Q(1)});
  const Vec3<Q> up(Q(0), Q(1), Q(0)), arm(Q(-1, 2), Q(-1, 2), Q(0));
  const Contact<Q> contact{
      {}, {Q(1), world_inverse_inertia<Q>(identity3<Q>(), cube.inverse_inertia()), arm}, up, zero3<Q>()};
  const PairVelocity<Q> before{{}, {{Q(1, 2), Q(-1), Q(0)}, zero3<Q>()}};
  const auto [after, report] =
      resolve_impact<Q>(contact, before, *Surface<Q>::make(Q(1), Q(1), Q(1)), FrictionLaw::sheet);
  EXPECT_EQ(report.j_W, Vec3<Q>(Q(7, 10), j_r, Q(0)));
  EXPECT_EQ(report.energy_change, Q(49, 400));
  EXPECT_TRUE(report.energy_rose);
  EXPECT_EQ(relative_velocity<Q>(contact.A, contact.B, after).dot(up), Q(-1, 20));
}

// case FR-18: a block that rocks on one corner and lands on the other, e = 0, no slip: ω'/ω = 1 − 3/2 sin²α,
// sin²α = b²/(b² + h²), b and h half base and half height. Angular momentum about the new corner is kept: I +
// m(h² − b²) = (I + m(h² + b²)) ω'/ω.
TEST(CoulombFriction, TurnsARockingBlockOnItsOtherCornerByHousnersRatio) {
  const auto ratio = [](const Q& b, const Q& h) {
    const Cuboid<Q> block = *Cuboid<Q>::make(Q(3), {Q(2) * b, Q(2) * h, Q(7, 5)});
    const Vec3<Q> up(Q(0), Q(1), Q(0)), along(Q(1), Q(0), Q(0)), old_corner(-b, -h, Q(0)),
        new_corner(b, -h, Q(0));
    const Vec3<Q> w(Q(0), Q(0), Q(-1)), v = -cross<Q>(w, old_corner);  // the old corner is at rest
    const ImpactBody<Q> B{block.inverse_mass(),
                          world_inverse_inertia<Q>(identity3<Q>(), block.inverse_inertia()), new_corner};
    const Vec3<Q> v_r = v + cross<Q>(w, new_corner);
    const auto impact = coulomb_impulse<Q>(effective_inverse_mass<Q>(ImpactBody<Q>{}, B), v_r, up, along,
                                           Q(0), Q(1000), Q(1000));
    EXPECT_EQ(impact.outcome, FrictionOutcome::stuck);
    const Velocity<Q> after = apply_impulse<Q>(B, {v, w}, impact.j_W);
    EXPECT_EQ(Vec3<Q>(after.v_WB + cross<Q>(after.w_WB, new_corner)), zero3<Q>());
    return after.w_WB[2] / w[2];
  };
  EXPECT_EQ(ratio(Q(1), Q(3)), Q(17, 20));  // sin²α = 1/10
  EXPECT_EQ(ratio(Q(1), Q(1)), Q(1, 4));    // a cube
  EXPECT_EQ(ratio(Q(2), Q(7, 3)), Q(1) - Q(3, 2) * Q(4) / (Q(4) + Q(49, 9)));
  Draw draw(69);
  for (int i = 0; i < draws; ++i) {
    const Q b = draw.positive(), h = draw.positive();
    EXPECT_EQ(ratio(b, h), Q(1) - Q(3, 2) * b * b / (b * b + h * h));
  }
}

// friction.stronge is a method in double; with e = 0 its end is the end of compression, and in the plane of a
// K that keeps the plane that is rational. Its header promises about 1e-11.
// id: friction.stronge
TEST(StrongeImpact, WithoutRestitutionIsTheEndOfCompressionOfTheProcess) {
  Draw draw(68);
  int turned = 0;
  for (int i = 0; i < 100; ++i) {
    PlanarImpact<Q> impact = draw_planar(draw);
    Process process = process_of(impact);
    process.move_until_v_n(Q(0));
    const Mat3<Q> R = draw.rotation();
    Mat3<Q> K_axes = zero33<Q>();
    K_axes << impact.k_tt, impact.k_tn, Q(0), impact.k_tn, impact.k_nn, Q(0), Q(0), Q(0), draw.positive();
    const Mat3<Q> K = R * K_axes * R.transpose();
    const Vec3<Q> n = R.col(1), t = R.col(0), v_r = impact.v_n * n + impact.v_t * t,
                  j = process.p * n + process.j_t * t;
    const auto rounded = [](const auto& x) {
      return x.unaryExpr([](const Q& q) { return double(q); }).eval();
    };
    const Vec3<double> got =
        stronge_impulse(rounded(K), rounded(v_r), rounded(n), 0, double(impact.mu_s), double(impact.mu_d))
            .j_W;
    const Vec3<double> want = rounded(j);
    EXPECT_LE((got - want).norm(), 1e-11 * want.norm()) << i;
    turned += process.v_t <= Q(0);
  }
  EXPECT_GT(turned, 10);
}

// K in axes t1, t2, n that stand anywhere.
Mat3<Q> in_world(const Mat3<Q>& axes, const Mat3<Q>& K) { return axes * K * axes.transpose(); }

FrictionImpact<double> stronge_of(const Mat3<Q>& K, const Vec3<Q>& v_r, const Vec3<Q>& n, const Q& e, const Q& mu) {
  const auto rounded = [](const auto& x) { return x.unaryExpr([](const Q& q) { return double(q); }).eval(); };
  return stronge_impulse(rounded(K), rounded(v_r), rounded(n), double(e), double(mu), double(mu));
}

// Without slip at first, and k_tn = κ s + μ K_tt s with κ > 0: friction cannot hold, |K_tt⁻¹ k_tn| > μ, and the slip starts along s, where
// it stays, as its pull κ s does. All is linear in p then: p = (1 + e)|v_n|/(k_nn − μ k_tn·s), j = p (n − μ s). The directions go around
// the circle, up to 60 degrees off k_tn to either side; the bound is the header's.
// id: friction.stronge
TEST(StrongeImpact, SlipsFromRestAlongTheDirectionThatDrawsItOn) {
  Draw draw(70);
  for (const auto& [x, y] : {std::pair{3L, 4L}, {4L, 3L}, {5L, 12L}, {12L, 5L}, {1L, 0L}})
    for (const long side : {1L, -1L})
      for (const long up : {1L, -1L})
        for (const bool turned : {false, true}) {
          const Q length = y == 0 ? Q(1) : x * y == 12 ? Q(5) : Q(13);
          const Q c = Q(side * (turned ? y : x)) / length, s = Q(up * (turned ? x : y)) / length;
          const Q e = draw.fraction(), mu = draw.fraction(), kappa = draw.positive() / Q(16), v_n = -draw.positive();
          const Q k11 = Q(1) + draw.fraction(), k22 = Q(20) + draw.fraction(), k12 = draw.fraction() / Q(2);
          const Q k1 = kappa * c + mu * (k11 * c + k12 * s), k2 = kappa * s + mu * (k12 * c + k22 * s);
          const Q k_nn = Q(4) + Q(2) * (k1 * k1 + k2 * k2);
          Mat3<Q> K;
          K << k11, k12, k1, k12, k22, k2, k1, k2, k_nn;
          const Mat3<Q> axes = draw.rotation();
          const Vec3<Q> n = axes.col(2), along = c * axes.col(0) + s * axes.col(1);
          const Q p = -(Q(1) + e) * v_n / (k_nn - mu * (k1 * c + k2 * s));
          const Vec3<Q> j = p * (n - mu * along);
          const Vec3<double> want{double(j[0]), double(j[1]), double(j[2])};
          const Vec3<double> got = stronge_of(in_world(axes, K), v_n * n, n, e, mu).j_W;
          EXPECT_LE((got - want).norm(), 1e-11 * want.norm()) << c << ' ' << s << " e " << e << " mu " << mu;
        }
}

// K = diag(k, 2k, k_nn): dv1/dv2 = v1/(2 v2) along the slip, whichever speed it has, so v2/v1² stays, while the direction turns; and
// nothing couples to n: p = (1 + e)|v_n|/k_nn.
// id: friction.stronge
TEST(StrongeImpact, SlipKeepsToItsParabola) {
  Draw draw(71);
  for (int i = 0; i < 40; ++i) {
    const Q k = Q(1) + draw.fraction(), k_nn = (Q(1) + draw.fraction()) / Q(4), e = draw.fraction(), mu = Q(4) + draw.fraction();
    const Q v_n = -Q(1) - draw.fraction(), loss = -mu * k * (Q(1) + e) * v_n / k_nn;  // more than v1 can lose
    const Q v1 = loss * (Q(5, 4) + draw.fraction()), v2 = (i % 2 == 0 ? loss : -loss) * (Q(1) + draw.fraction());
    Mat3<Q> K = zero33<Q>();
    K(0, 0) = k, K(1, 1) = Q(2) * k, K(2, 2) = k_nn;
    const Mat3<Q> axes = draw.rotation();
    const Vec3<Q> n = axes.col(2), v_r = v1 * axes.col(0) + v2 * axes.col(1) + v_n * n;
    const Vec3<double> j = stronge_of(in_world(axes, K), v_r, n, e, mu).j_W;
    const auto component = [&](int a) { return double(axes(0, a)) * j[0] + double(axes(1, a)) * j[1] + double(axes(2, a)) * j[2]; };
    const double p = -(1 + double(e)) * double(v_n) / double(k_nn), w1 = double(v1) + double(k) * component(0), w2 = double(v2) + 2 * double(k) * component(1);
    ASSERT_GT(w1, 0.05 * double(v1)) << "still on its way";
    EXPECT_LT(std::fabs(w2 / double(v2)), 0.95) << "and turned";
    EXPECT_NEAR(component(2) / p, 1, 1e-11);
    EXPECT_NEAR(w2 / (w1 * w1) * double(v1 * v1) / double(v2), 1, 1e-10) << "w1 is at least a twentieth: its error counts twenty times twice";
  }
}

// "A slip below 16u |v_r| counts as none": across to the coupling, static friction then holds with an impulse that the coupling asks for,
// j = K⁻¹ n (1 + e ..): here (-1, 2, 0) for a K of 1, 1 and 1/2; one that slips is held by nothing, mu_d = 0, and j = 3/2 n.
// id: friction.stronge
TEST(StrongeImpact, ASlipBelowSixteenRoundingsIsNone) {
  Mat3<double> K = zero33<double>();
  K << 1, 0.5, 0, 0.5, 1, 0, 0, 0, 1;
  const Vec3<double> n(0, 1, 0);
  for (const double part : {15.5, 16.5, 24.}) {
    const auto impact = stronge_impulse(K, Vec3<double>(0, -1, part * 0x1p-53), n, 0.5, 1, 0);
    const Vec3<double> want = part < 16 ? Vec3<double>(-1, 2, 0) : Vec3<double>(0, 1.5, 0);
    EXPECT_LE((impact.j_W - want).norm(), 1e-11) << part << ": " << impact.j_W.transpose();
  }
}

}  // namespace rigor
