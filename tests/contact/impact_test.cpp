#include <gtest/gtest.h>

#include <rigor/contact/plane_response.hpp>
#include <rigor/scalar/rational.hpp>

namespace rigor {
namespace {

using Q = Rational;
using VQ = Vec3<Q>;

// A corner straight below the centre of a 2 kg box: no coupling, k_nn = 1/2 whatever the law; k_tt = 1/2 + h^2/I.
Contact<Q> below(const Cuboid<Q>& box) {
  const VQ arm(Q(0), Q(-1, 2), Q(0));
  return {{}, {box.inverse_mass(), world_inverse_inertia<Q>(identity3<Q>(), box.inverse_inertia()), arm}, VQ(Q(0), Q(1), Q(0)), zero3<Q>()};
}
ImpactReport<Q> report(FrictionLaw law, const Q& slip, const Q& mu_s, const Q& mu_d) {
  const auto box = *Cuboid<Q>::make(Q(2), VQ(Q(1), Q(1), Q(1)));
  PairVelocity<Q> u;
  u.B.v_WB = VQ(slip, Q(-1), Q(0));
  return resolve_impact<Q>(below(box), u, *Surface<Q>::make(Q(0), mu_s, mu_d), law).report;
}

// Each law does what it is for: j_n = 2 for all; the sheet compares m·slip with mu_s j_n and gives mu_d j_n beyond, its literal
// reading gives mu_d j_n always, coulomb compares slip/k_tt.
TEST(ResolveImpact, UsesTheLawAskedFor) {
  const Q k_tt = Q(1, 2) + Q(1, 4) * Q(3), mu_s(1, 2), mu_d(1, 4);  // I = 2 (1 + 1)/12 = 1/3
  const auto sheet_sticks = report(FrictionLaw::sheet, Q(1, 4), mu_s, mu_d), sheet_slides = report(FrictionLaw::sheet, Q(3, 4), mu_s, mu_d);
  EXPECT_EQ(sheet_sticks.j_W, VQ(Q(-1, 2), Q(2), Q(0)));  // m·slip = 1/2 <= 1
  EXPECT_EQ(sheet_sticks.outcome, FrictionOutcome::stuck);
  EXPECT_EQ(sheet_slides.j_W, VQ(Q(-1, 2), Q(2), Q(0)));  // mu_d j_n
  EXPECT_EQ(sheet_slides.outcome, FrictionOutcome::slid);
  const auto literal = report(FrictionLaw::sheet_literal, Q(1, 8), mu_s, mu_d);
  EXPECT_EQ(literal.j_W, VQ(Q(-1, 2), Q(2), Q(0)));
  EXPECT_EQ(literal.outcome, FrictionOutcome::slid);
  const auto coulomb = report(FrictionLaw::coulomb, Q(1, 4), mu_s, mu_d);
  EXPECT_EQ(coulomb.j_W, VQ(-Q(1, 4) / k_tt, Q(2), Q(0)));
  EXPECT_EQ(coulomb.outcome, FrictionOutcome::stuck);
  // the literal rule is "slid" even where its impulse happens to be the one that stops a point mass
  EXPECT_EQ(report(FrictionLaw::sheet_literal, Q(1, 4), mu_s, mu_d).outcome, FrictionOutcome::slid);
}

TEST(ResolveImpact, BreaksAPromiseForStrongeOverTheRationals) {
  EXPECT_DEATH(report(FrictionLaw::stronge, Q(1, 4), Q(1, 2), Q(1, 4)), "double only");
}

// A contact that neither approaches nor leaves is left alone: exactly nothing, and said so.
TEST(ResolveImpact, LeavesAContactWithoutApproachAlone) {
  const auto box = *Cuboid<Q>::make(Q(2), VQ(Q(1), Q(1), Q(1)));
  for (const Q& v_n : {Q(0), Q(1, 1000), Q(5)}) {
    PairVelocity<Q> u;
    u.B.v_WB = VQ(Q(1), v_n, Q(0));
    const auto result = resolve_impact<Q>(below(box), u, *Surface<Q>::make(Q(1, 2), Q(1, 2), Q(1, 2)), FrictionLaw::sheet);
    EXPECT_TRUE(result.report.separating);
    EXPECT_EQ(result.after.B.v_WB, u.B.v_WB);
  }
  PairVelocity<Q> slow;
  slow.B.v_WB = VQ(Q(0), Q(-1, 1000), Q(0));
  EXPECT_FALSE(resolve_impact<Q>(below(box), slow, *Surface<Q>::make(Q(1, 2), Q(0), Q(0)), FrictionLaw::sheet).report.separating);
}

// The accounts of one impact, exactly: restitution keeps e^2 of v_n^2/(2 k_nn); friction takes -j_t·(v_t + v_t')/2; together
// they are what the kinetic energy lost.
TEST(ImpactReport, SplitsTheLossBetweenRestitutionAndFriction) {
  const auto box = *Cuboid<Q>::make(Q(2), VQ(Q(1), Q(1), Q(1)));
  for (const Q& e : {Q(0), Q(1, 3), Q(1)}) {
    PairVelocity<Q> u;
    u.B.v_WB = VQ(Q(3), Q(-2), Q(0));
    const auto result = resolve_impact<Q>(below(box), u, *Surface<Q>::make(e, Q(1, 4), Q(1, 4)), FrictionLaw::coulomb);
    const ImpactReport<Q>& r = result.report;
    EXPECT_EQ(r.restitution_loss, (Q(1) - e * e) * Q(4));  // 1/(2 k_nn) = 1, v_n^2 = 4
    const Q j_n = Q(4) * (Q(1) + e), j_t = -j_n / Q(4), k_tt(5, 4), after = Q(3) + k_tt * j_t;
    ASSERT_GT(after, Q(0)) << "it slides on";
    EXPECT_EQ(r.friction_loss, -j_t * (Q(3) + after) / Q(2));
    const auto energy = [&](const Velocity<Q>& v) { return kinetic_energy<Q>(Q(2), world_inertia<Q>(identity3<Q>(), box.inertia()), v.v_WB, v.w_WB); };
    EXPECT_EQ(r.energy_change, energy(result.after.B) - energy(u.B));
    EXPECT_EQ(r.energy_change, -r.restitution_loss - r.friction_loss);
  }
}

// One skew plane, one corner behind it (number 5), another exactly on it: pushed out along the normal by the depth, hit at
// that corner alone, with its own arm.
TEST(PlaneResponse, PushesOutAlongTheNormalAndHitsTheCornersBehind) {
  const VQ n(Q(2, 7), Q(3, 7), Q(6, 7));
  const auto box = *Cuboid<Q>::make(Q(2), VQ(Q(2), Q(4), Q(6)));
  // corner 2 (-1, 2, -3): n·r = (-2 + 6 - 18)/7 = -2; corner 0 (-1, -2, -3): -26/7; so lift the centre to 26/7 - 1/70
  State<Q> s;
  s.p_WB = (Q(26, 7) - Q(1, 70)) * n;
  s.v_WB = VQ(Q(1), Q(-2), Q(-3));
  s.w_WB = VQ(Q(1, 2), Q(-1), Q(1, 4));
  const auto plane = *Plane<Q>::make(VQ(Q(0), Q(0), Q(0)), n);
  const auto surface = *Surface<Q>::make(Q(1, 2), Q(0), Q(0));
  const auto response = respond_to_plane<Q>(box, s, plane, surface, FrictionLaw::sheet);
  EXPECT_EQ(response.corners, 1);
  EXPECT_EQ(response.shift, VQ(Q(1, 70) * n));
  EXPECT_EQ(response.after.p_WB, VQ(Q(26, 7) * n));
  const ImpactBody<Q> B{box.inverse_mass(), world_inverse_inertia<Q>(identity3<Q>(), box.inverse_inertia()), box.corner(0)};
  const auto want = resolve_impact<Q>({{}, B, n, zero3<Q>()}, {{}, {s.v_WB, s.w_WB}}, surface, FrictionLaw::sheet);
  EXPECT_EQ(response.after.v_WB, want.after.B.v_WB);
  EXPECT_EQ(response.after.w_WB, want.after.B.w_WB);
  EXPECT_FALSE(response.reports[0].separating);
  for (int k = 1; k < 8; ++k) EXPECT_TRUE(response.reports[std::size_t(k)].separating);

  // another corner, from below: turned upside down by the signs of n
  const VQ down(Q(-2, 7), Q(3, 7), Q(-6, 7));
  State<Q> t = s;
  t.p_WB = (Q(26, 7) - Q(1, 70)) * down;
  t.v_WB = VQ(Q(1), Q(-2), Q(3));
  const auto other = respond_to_plane<Q>(box, t, *Plane<Q>::make(VQ(Q(0), Q(0), Q(0)), down), surface, FrictionLaw::sheet);
  EXPECT_FALSE(other.reports[5].separating) << "corner (+, -, +)";
  ImpactBody<Q> C = B;
  C.p_BC_W = box.corner(5);
  EXPECT_EQ(other.after.w_WB, resolve_impact<Q>({{}, C, down, zero3<Q>()}, {{}, {t.v_WB, t.w_WB}}, surface, FrictionLaw::sheet).after.B.w_WB);

  // exactly on the plane is not behind it: alone, and beside two that are
  s.p_WB = Q(26, 7) * n;
  EXPECT_EQ(respond_to_plane<Q>(box, s, plane, surface, FrictionLaw::sheet).corners, 0);
  State<Q> leaning;
  leaning.R_WB << Q(3, 5), Q(-4, 5), Q(0), Q(4, 5), Q(3, 5), Q(0), Q(0), Q(0), Q(1);
  leaning.p_WB = VQ(Q(0), Q(2, 5), Q(0));  // corners 1 and 5 at height 2/5 + 4/5 - 6/5 = 0, corners 0 and 4 below
  leaning.v_WB = VQ(Q(0), Q(-1), Q(0));
  leaning.w_WB = VQ(Q(0), Q(0), Q(-10));   // and 1 and 5 approach
  const auto beside = respond_to_plane<Q>(box, leaning, *Plane<Q>::make(VQ(Q(0), Q(0), Q(0)), VQ(Q(0), Q(1), Q(0))), surface, FrictionLaw::sheet);
  EXPECT_EQ(beside.corners, 2);
  EXPECT_TRUE(beside.reports[1].separating && beside.reports[5].separating);
}

// An elastic impact without friction changes the energy by rounding only: not a rise, whatever the scale.
TEST(ImpactReport, CallsRoundingNoRise) {
  const auto box = *Cuboid<double>::make(2, {0.5, 0.25, 1});
  std::uint64_t random = 88172645463325252u;
  const auto draw = [&] {
    random ^= random << 13, random ^= random >> 7, random ^= random << 17;
    return double(random >> 11) * 0x1p-52 - 1;
  };
  int above = 0;
  for (int k = 0; k < 3000; ++k) {
    const double scale = std::exp2(k % 41 - 20);
    const Vec3<double> n(2.0 / 7, 3.0 / 7, 6.0 / 7);
    const ImpactBody<double> B{box.inverse_mass(), world_inverse_inertia<double>(identity3<double>(), box.inverse_inertia()), box.corner(k % 8)};
    PairVelocity<double> u;
    u.B.v_WB = scale * Vec3<double>(draw(), draw(), draw());
    u.B.w_WB = scale * Vec3<double>(draw(), draw(), draw());
    const auto result = resolve_impact<double>({{}, B, n, zero3<double>()}, u, *Surface<double>::make(1, 0, 0), FrictionLaw::sheet);
    above += result.report.energy_change > 0;
    EXPECT_FALSE(result.report.energy_rose) << k;
  }
  EXPECT_GT(above, 100) << "rounding goes both ways";
}

TEST(Surface, HasNamesForItsLawsAndIsFrictionlessOnlyWithoutBoth) {
  for (const FrictionLaw law : {FrictionLaw::sheet, FrictionLaw::sheet_literal, FrictionLaw::coulomb, FrictionLaw::stronge}) EXPECT_EQ(friction_law_named(name(law)), law);
  EXPECT_EQ(friction_law_named("sheet "), std::nullopt);
  EXPECT_TRUE(Surface<Q>().frictionless());
  EXPECT_EQ(Surface<Q>().restitution(), Q(0));
  EXPECT_FALSE(Surface<Q>::make(Q(0), Q(1, 2), Q(0))->frictionless());
  EXPECT_FALSE(Surface<Q>::make(Q(0), Q(0), Q(1, 2))->frictionless());
}

}  // namespace
}  // namespace rigor
