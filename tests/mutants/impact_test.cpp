#include <gtest/gtest.h>

#include <rigor/formulas/apply_pair_impulse.hpp>
#include <rigor/formulas/kinetic_energy.hpp>
#include <rigor/formulas/momentum.hpp>
#include <rigor/formulas/normal_effective_mass.hpp>
#include <rigor/formulas/normal_impulse.hpp>
#include <tests/exact/draw.hpp>
#include <tests/mutants/matrix.hpp>

// Which oracle sees which mistake in the impact of two cuboids: verification cases, section 5, first block,
// over the rationals. Conservation laws alone are weak: no single column kills all mutants.
namespace rigor {
namespace {

/// A meeting whose slip before the impact has the rational direction t: the friction mutant needs it.
struct Case {
  Meeting m;
  Vec3<Q> t;
};

Case draw_case(Draw& draw) {
  Meeting m = draw_meeting(draw);
  const Mat3<Q> R = draw.rotation();
  m.n_AB_W = R.col(0);
  m.e = Q(draw.integer(0, 8), 8);
  const Q approach = draw.positive(), slip = draw.positive();
  const Vec3<Q> wanted = slip * R.col(1) - approach * R.col(0);
  m.b.state.v_WB += wanted - relative_velocity<Q>(m.A(), m.B(), m.before());
  return {m, R.col(1)};
}

PairVelocity<Q> collide(const Meeting& m, const ImpactBody<Q>& A, const ImpactBody<Q>& B,
                        const PairVelocity<Q>& seen,
                        Q (*law)(const Q&, const Q&, const Q&) = normal_impulse<Q>) {
  const Q v_n = relative_velocity<Q>(m.A(), m.B(), seen).dot(m.n_AB_W);
  const Q j = law(m.e, v_n, normal_inverse_mass<Q>(A, B, m.n_AB_W));
  return apply_pair_impulse<Q>(A, B, m.before(), Vec3<Q>(j * m.n_AB_W));
}

PairVelocity<Q> right(const Case& c) { return collide(c.m, c.m.A(), c.m.B(), c.m.before()); }

PairVelocity<Q> printed_restitution(const Case& c) {
  return collide(c.m, c.m.A(), c.m.B(), c.m.before(), normal_impulse_printed<Q>);
}

ImpactBody<Q> with_body_tensor(const Body& body, const Vec3<Q>& p_WC) {
  ImpactBody<Q> B = body.at(p_WC);
  B.inverse_I_B_W = world_inverse_inertia<Q>(identity3<Q>(), body.shape.inverse_inertia());
  return B;
}
PairVelocity<Q> body_frame_tensor(const Case& c) {
  return collide(c.m, with_body_tensor(c.m.a, c.m.p_WC), with_body_tensor(c.m.b, c.m.p_WC), c.m.before());
}

PairVelocity<Q> spin_sign(const Case& c) {  // v − ω × r
  PairVelocity<Q> seen = c.m.before();
  seen.A.w_WB = -seen.A.w_WB, seen.B.w_WB = -seen.B.w_WB;
  return collide(c.m, c.m.A(), c.m.B(), seen);
}

PairVelocity<Q> arm_from_the_origin(const Case& c) {  // in the impulse only: v_r has the right arms
  ImpactBody<Q> A = c.m.A(), B = c.m.B();
  A.p_BC_W = c.m.p_WC, B.p_BC_W = c.m.p_WC;
  return collide(c.m, A, B, c.m.before());
}

PairVelocity<Q> friction_added(const Case& c) {  // −μ j_r t on top of the frictionless j_r, μ = 1/2
  const Q v_n = relative_velocity<Q>(c.m.A(), c.m.B(), c.m.before()).dot(c.m.n_AB_W);
  const Q j_r = normal_impulse<Q>(c.m.e, v_n, normal_inverse_mass<Q>(c.m.A(), c.m.B(), c.m.n_AB_W));
  return apply_pair_impulse<Q>(c.m.A(), c.m.B(), c.m.before(),
                               Vec3<Q>(j_r * c.m.n_AB_W - Q(1, 2) * j_r * c.t));
}

const std::vector<std::string> impact_oracles = {"P", "L", "energy gain", "P-05 energy", "v' = -e v"};

/// The five oracles on one impact; they know the bodies, the contact and e, not how the impact was computed.
void judge(const Meeting& m, const PairVelocity<Q>& u, Verdict& verdict) {
  const PairVelocity<Q> before = m.before();
  const auto P = [&](const PairVelocity<Q>& x) {
    return Vec3<Q>(m.a.mass() * x.A.v_WB + m.b.mass() * x.B.v_WB);
  };
  const auto L = [&](const PairVelocity<Q>& x) {
    return Vec3<Q>(
        angular_momentum<Q>(m.a.mass(), m.a.inertia(), m.a.state.p_WB, x.A.v_WB, x.A.w_WB, zero3<Q>()) +
        angular_momentum<Q>(m.b.mass(), m.b.inertia(), m.b.state.p_WB, x.B.v_WB, x.B.w_WB, zero3<Q>()));
  };
  const auto E = [&](const PairVelocity<Q>& x) {
    return kinetic_energy<Q>(m.a.mass(), m.a.inertia(), x.A.v_WB, x.A.w_WB) +
           kinetic_energy<Q>(m.b.mass(), m.b.inertia(), x.B.v_WB, x.B.w_WB);
  };
  const Q v_n = relative_velocity<Q>(m.A(), m.B(), before).dot(m.n_AB_W);
  const Q k = m.n_AB_W.dot(Vec3<Q>(effective_inverse_mass<Q>(m.A(), m.B()) * m.n_AB_W));
  verdict["P"] += P(u) != P(before);
  verdict["L"] += L(u) != L(before);
  verdict["energy gain"] += E(u) > E(before);
  verdict["P-05 energy"] += E(u) - E(before) != -(Q(1) - m.e * m.e) * v_n * v_n / (Q(2) * k);
  verdict["v' = -e v"] += relative_velocity<Q>(m.A(), m.B(), u).dot(m.n_AB_W) != -m.e * v_n;
}

}  // namespace

TEST(ImpactMutants, AreEachKilledAndNoSingleOracleKillsThemAll) {
  struct Mutant {
    const char* name;
    PairVelocity<Q> (*impact)(const Case&);
    std::map<std::string, bool> flags;  ///< the catalogue's pattern: is the entry > 0?
  };
  const std::vector<Mutant> mutants = {
      {"none", right, {{"P", 0}, {"L", 0}, {"energy gain", 0}, {"P-05 energy", 0}, {"v' = -e v", 0}}},
      {"-(1-e) for -(1+e)",
       printed_restitution,
       {{"P", 0}, {"L", 0}, {"energy gain", 0}, {"P-05 energy", 0}, {"v' = -e v", 1}}},
      {"inverse inertia in body axes with world r x n",
       body_frame_tensor,
       {{"P", 0}, {"L", 1}, {"energy gain", 1}, {"P-05 energy", 1}, {"v' = -e v", 0}}},
      {"v_p = v - w x r",
       spin_sign,
       {{"P", 0}, {"L", 0}, {"energy gain", 1}, {"P-05 energy", 1}, {"v' = -e v", 1}}},
      {"arm from the origin, in the impulse",
       arm_from_the_origin,
       {{"P", 0}, {"L", 1}, {"energy gain", 1}, {"P-05 energy", 1}, {"v' = -e v", 1}}},
      {"-mu j_r t added to the frictionless impulse, mu = 1/2",
       friction_added,
       {{"P", 0}, {"L", 0}, {"energy gain", 1}, {"v' = -e v", 1}}},
  };
  Draw draw(71, 512);
  std::vector<Case> cases;
  for (int i = 0; i < 300; ++i) cases.push_back(draw_case(draw));

  std::vector<std::pair<std::string, Verdict>> rows;
  for (const Mutant& mutant : mutants) {
    Verdict verdict;
    for (const Case& c : cases) judge(c.m, mutant.impact(c), verdict);
    if (!mutant.flags.count("P-05 energy")) verdict.erase("P-05 energy");  // a law of frictionless impacts
    for (const auto& [oracle, flagged] : verdict)
      EXPECT_EQ(flagged > 0, mutant.flags.at(oracle))
          << mutant.name << " by " << oracle << ": " << flagged << " of 300";
    EXPECT_EQ(killed(verdict), mutant.impact != right) << mutant.name;
    rows.push_back({mutant.name, verdict});
  }
  expect_in_docs(matrix("300 impacts of two cuboids over the rationals: how many each oracle flags", impact_oracles, rows));
  for (const std::string& oracle : impact_oracles) {
    bool kills_all = true;
    for (const auto& [name, verdict] : rows)
      kills_all = kills_all && (name == "none" || (verdict.count(oracle) && verdict.at(oracle) > 0));
    EXPECT_FALSE(kills_all) << oracle;
  }
}

// "A cube hides the bug completely": with two cubes the body-frame tensor passes all five oracles.
TEST(ImpactMutants, InBodyAxesAreHiddenByCubes) {
  Draw draw(72, 512);
  Verdict cubes;
  for (int i = 0; i < 20; ++i) {
    Case c = draw_case(draw);
    for (Body* body : {&c.m.a, &c.m.b}) {
      const Q edge = draw.positive();
      body->shape = *Cuboid<Q>::make(body->mass(), Vec3<Q>(edge, edge, edge));
    }
    if (!(relative_velocity<Q>(c.m.A(), c.m.B(), c.m.before()).dot(c.m.n_AB_W) < Q(0))) continue;
    judge(c.m, body_frame_tensor(c), cubes);
  }
  EXPECT_FALSE(killed(cubes));
}

// case BB-05: the published numbers of the wrong-frame mutant on the catalogue's general example.
TEST(ImpactMutants, InBodyAxesGiveThePublishedErrorsOnTheGeneralExample) {
  const auto body = [](const Q& m, const Vec3<Q>& half, const Vec4<Q>& q, const Vec3<Q>& p, const Vec3<Q>& v,
                       const Vec3<Q>& w) {
    State<Q> s;
    s.p_WB = p, s.R_WB = rotation_of<Q>(q), s.v_WB = v, s.w_WB = w;
    return Body{*Cuboid<Q>::make(m, Vec3<Q>(half * Q(2))), s};
  };
  const Meeting m{
      body(2, {1, Q(1, 2), Q(1, 4)}, Vec4<Q>(1, 2, -1, 3), {0, 0, 0}, {1, 0, Q(1, 3)}, {Q(1, 2), -1, 2}),
      body(3, {Q(1, 2), 1, 2}, Vec4<Q>(2, -1, 1, 1), {1, 1, 2}, {-1, Q(1, 5), -1}, {1, 1, Q(-1, 2)}),
      {Q(1, 2), Q(1, 3), 1},
      {Q(2, 7), Q(3, 7), Q(6, 7)},
      Q(3, 5)};
  const PairVelocity<Q> u = body_frame_tensor({m, {}}), before = m.before();
  Vec3<Q> dL = zero3<Q>();
  Q dE = 0;
  for (const auto& [b, x, y] : {std::tuple(&m.a, before.A, u.A), std::tuple(&m.b, before.B, u.B)}) {
    dL += angular_momentum<Q>(b->mass(), b->inertia(), b->state.p_WB, y.v_WB, y.w_WB, zero3<Q>()) -
          angular_momentum<Q>(b->mass(), b->inertia(), b->state.p_WB, x.v_WB, x.w_WB, zero3<Q>());
    dE += kinetic_energy<Q>(b->mass(), b->inertia(), y.v_WB, y.w_WB) -
          kinetic_energy<Q>(b->mass(), b->inertia(), x.v_WB, x.w_WB);
  }
  // printed with four and three decimals
  EXPECT_NEAR(double(dL[0]), 1.0156, 5e-5);
  EXPECT_NEAR(double(dL[1]), -0.0930, 5e-5);
  EXPECT_NEAR(double(dL[2]), 0.3239, 5e-5);
  EXPECT_NEAR(double(dE), 1.435, 5e-4);
}

}  // namespace rigor
