#include <gtest/gtest.h>

#include <rigor/formulas/apply_pair_impulse.hpp>
#include <rigor/formulas/kinetic_energy.hpp>
#include <rigor/formulas/momentum.hpp>
#include <rigor/formulas/normal_effective_mass.hpp>
#include <rigor/formulas/normal_impulse.hpp>
#include <rigor/formulas/point_velocity.hpp>
#include <tests/exact/draw.hpp>
#include <tests/exact/point_masses.hpp>

namespace rigor {
namespace {

Q energy(const Meeting& m, const PairVelocity<Q>& u) {
  return kinetic_energy<Q>(m.a.mass(), m.a.inertia(), u.A.v_WB, u.A.w_WB) +
         kinetic_energy<Q>(m.b.mass(), m.b.inertia(), u.B.v_WB, u.B.w_WB);
}

Vec3<Q> total_linear_momentum(const Meeting& m, const PairVelocity<Q>& u) {
  return linear_momentum<Q>(m.a.mass(), u.A.v_WB) + linear_momentum<Q>(m.b.mass(), u.B.v_WB);
}

Vec3<Q> total_angular_momentum(const Meeting& m, const PairVelocity<Q>& u, const Vec3<Q>& p_WO) {
  return angular_momentum<Q>(m.a.mass(), m.a.inertia(), m.a.state.p_WB, u.A.v_WB, u.A.w_WB, p_WO) +
         angular_momentum<Q>(m.b.mass(), m.b.inertia(), m.b.state.p_WB, u.B.v_WB, u.B.w_WB, p_WO);
}

struct NormalImpact {
  Q v_n, k_nn, j;
  PairVelocity<Q> after;
  Vec3<Q> v_r_before, v_r_after;
};

/// The frictionless impact of the sheet, with a law for the impulse's size.
NormalImpact collide(const Meeting& m, Q (*law)(const Q&, const Q&, const Q&)) {
  NormalImpact x;
  x.v_r_before = relative_velocity<Q>(m.A(), m.B(), m.before());
  x.v_n = x.v_r_before.dot(m.n_AB_W);
  x.k_nn = normal_inverse_mass<Q>(m.A(), m.B(), m.n_AB_W);
  x.j = law(m.e, x.v_n, x.k_nn);
  x.after = apply_pair_impulse<Q>(m.A(), m.B(), m.before(), Vec3<Q>(x.j * m.n_AB_W));
  x.v_r_after = relative_velocity<Q>(m.A(), m.B(), x.after);
  return x;
}

}  // namespace

// Newton for every mass point: an impulse j at C changes Σ m v by j and Σ m p × v by p_BC × j.
// id: impulse.apply
TEST(Impulse, ChangesTheMomentaOfTheMassPointsByItselfAndByItsMoment) {
  Draw draw(31);
  for (int i = 0; i < draws; ++i) {
    const Body body = draw_body(draw);
    const ImpactBody<Q> B = body.at(draw.vector());
    const Vec3<Q> j = draw.vector();
    const Velocity<Q> after = apply_impulse<Q>(B, body.velocity(), j);
    const auto change = [&](const Vec3<Q>& p) {
      return Vec3<Q>(after.v_WB - body.state.v_WB + cross<Q>(Vec3<Q>(after.w_WB - body.state.w_WB), p));
    };
    const auto points = point_masses(body.mass(), body.shape.size(), body.state.R_WB);
    EXPECT_EQ(sum_of(points, change), j);
    EXPECT_EQ(moment_of(points, change), Vec3<Q>(cross<Q>(B.p_BC_W, j)));
  }
}

// id: impulse.relative_velocity
TEST(RelativeVelocity, IsThatOfBsPointSeenFromAs) {
  Draw draw(32);
  for (int i = 0; i < draws; ++i) {
    const Meeting m = draw_meeting(draw);
    const auto& [a, b] = m.before();
    const Vec3<Q> expected = point_velocity<Q>(b.v_WB, b.w_WB, Vec3<Q>(m.p_WC - m.b.state.p_WB)) -
                             point_velocity<Q>(a.v_WB, a.w_WB, Vec3<Q>(m.p_WC - m.a.state.p_WB));
    EXPECT_EQ(relative_velocity<Q>(m.A(), m.B(), m.before()), expected);
  }
}

// id: impulse.effective_mass
TEST(EffectiveMass, IsTheChangeOfRelativeVelocityByAnImpulseAndPositiveDefinite) {
  Draw draw(33);
  for (int i = 0; i < draws; ++i) {
    const Meeting m = draw_meeting(draw);
    const Vec3<Q> j = draw.vector();
    const Mat3<Q> K = effective_inverse_mass<Q>(m.A(), m.B());
    const Vec3<Q> v_r = relative_velocity<Q>(m.A(), m.B(), m.before());
    const Vec3<Q> after =
        relative_velocity<Q>(m.A(), m.B(), apply_pair_impulse<Q>(m.A(), m.B(), m.before(), j));
    EXPECT_EQ(after, Vec3<Q>(v_r + K * j));
    EXPECT_EQ(K, Mat3<Q>(K.transpose()));
    EXPECT_GT(K(0, 0), Q(0));  // Sylvester
    EXPECT_GT(K(0, 0) * K(1, 1) - K(0, 1) * K(1, 0), Q(0));
    EXPECT_GT(determinant(K), Q(0));
    // An immovable partner is zeros exactly, and K stays positive definite: K ≥ 1/m_B.
    const Mat3<Q> one_sided = effective_inverse_mass<Q>(ImpactBody<Q>{}, m.B()),
                  rest = one_sided - identity3<Q>() * m.B().inverse_mass;
    EXPECT_GT(determinant(one_sided), Q(0));
    EXPECT_EQ(Vec3<Q>(rest * m.B().p_BC_W), zero3<Q>());  // an impulse through the centre does not turn
    EXPECT_GE(j.dot(Vec3<Q>(rest * j)), Q(0));
  }
}

// id: impulse.normal_effective_mass
TEST(NormalEffectiveMass, IsTheNormalPartOfTheEffectiveMass) {
  Draw draw(34);
  for (int i = 0; i < draws; ++i) {
    const Meeting m = draw_meeting(draw);
    const Q k_nn = normal_inverse_mass<Q>(m.A(), m.B(), m.n_AB_W);
    EXPECT_EQ(k_nn, m.n_AB_W.dot(Vec3<Q>(effective_inverse_mass<Q>(m.A(), m.B()) * m.n_AB_W)));
    EXPECT_EQ(k_nn, normal_inverse_mass<Q>(m.A(), m.B(), Vec3<Q>(-m.n_AB_W)));
    EXPECT_GE(k_nn, m.A().inverse_mass + m.B().inverse_mass);
  }
}

// case P-05 (restitution), BB-02
// id: impulse.normal
TEST(NormalImpulse, MakesTheContactSeparateAtETimesItsApproachSpeed) {
  Draw draw(35);
  for (int i = 0; i < draws; ++i) {
    const Meeting m = draw_approach(draw);
    const NormalImpact x = collide(m, normal_impulse<Q>);
    EXPECT_EQ(x.v_r_after.dot(m.n_AB_W), -m.e * x.v_n);
    EXPECT_GT(x.j, Q(0));  // a push
  }
}

// The erratum: with the printed 1 − e the contact keeps approaching, at e times the speed. e = 0 is right by
// accident, and e = 1 does nothing at all.
// id: impulse.normal_printed
TEST(NormalImpulsePrinted, LeavesTheContactApproachingAtETimesItsSpeed) {
  Draw draw(36);
  for (int i = 0; i < draws; ++i) {
    Meeting m = draw_approach(draw);
    EXPECT_EQ(collide(m, normal_impulse_printed<Q>).v_r_after.dot(m.n_AB_W),
              m.e * collide(m, normal_impulse_printed<Q>).v_n);
    m.e = 0;
    EXPECT_EQ(collide(m, normal_impulse_printed<Q>).j, collide(m, normal_impulse<Q>).j);
    m.e = 1;
    EXPECT_EQ(collide(m, normal_impulse_printed<Q>).j, Q(0));
  }
}

// Any impulse at all, momenta about any point.
// id: impulse.apply_pair
TEST(PairImpulse, KeepsLinearAndAngularMomentum) {
  Draw draw(37);
  for (int i = 0; i < draws; ++i) {
    const Meeting m = draw_meeting(draw);
    const Vec3<Q> j = draw.vector(), p_WO = draw.vector();
    const PairVelocity<Q> after = apply_pair_impulse<Q>(m.A(), m.B(), m.before(), j);
    EXPECT_EQ(total_linear_momentum(m, after), total_linear_momentum(m, m.before()));
    EXPECT_EQ(total_angular_momentum(m, after, p_WO), total_angular_momentum(m, m.before(), p_WO));
    const Vec3<Q> v_change = after.B.v_WB - m.b.state.v_WB;
    EXPECT_EQ(Vec3<Q>(v_change * m.b.mass()), j);  // and +j is what B got
  }
}

// case BB-03: called with the bodies swapped and n turned round, the impact is the same.
TEST(PairImpulse, DoesNotCareWhichBodyIsCalledA) {
  Draw draw(38);
  for (int i = 0; i < draws; ++i) {
    const Meeting m = draw_approach(draw), swapped{m.b, m.a, m.p_WC, Vec3<Q>(-m.n_AB_W), m.e};
    const NormalImpact x = collide(m, normal_impulse<Q>), y = collide(swapped, normal_impulse<Q>);
    EXPECT_EQ(x.j, y.j);
    EXPECT_EQ(x.after.A.v_WB, y.after.B.v_WB);
    EXPECT_EQ(x.after.A.w_WB, y.after.B.w_WB);
    EXPECT_EQ(x.after.B.v_WB, y.after.A.v_WB);
    EXPECT_EQ(x.after.B.w_WB, y.after.A.w_WB);
  }
}

// case P-06: for every impulse, friction or not; needs the inertias symmetric, nothing else.
// id: energy.impulse
TEST(ImpulseEnergy, IsTheImpulseTimesTheMeanRelativeVelocity) {
  Draw draw(39);
  for (int i = 0; i < draws; ++i) {
    const Meeting m = draw_meeting(draw);
    const Vec3<Q> j = draw.vector();
    const PairVelocity<Q> after = apply_pair_impulse<Q>(m.A(), m.B(), m.before(), j);
    EXPECT_EQ(energy(m, after) - energy(m, m.before()),
              impulse_energy<Q>(j, relative_velocity<Q>(m.A(), m.B(), m.before()),
                                relative_velocity<Q>(m.A(), m.B(), after)));
  }
}

// case P-05: dE = −(1 − e²) v_n²/(2 k_nn), no tangential impulse, and against the ground the angular momentum
// about the contact point stays.
TEST(NormalImpulse, LosesTheEnergyOfTheLawAndNothingElse) {
  Draw draw(40);
  for (int i = 0; i < draws; ++i) {
    const Meeting m = draw_approach(draw);
    const NormalImpact x = collide(m, normal_impulse<Q>);
    EXPECT_EQ(energy(m, x.after) - energy(m, m.before()),
              -(Q(1) - m.e * m.e) * x.v_n * x.v_n / (Q(2) * x.k_nn));
    const Vec3<Q> j = linear_momentum<Q>(m.b.mass(), Vec3<Q>(x.after.B.v_WB - m.b.state.v_WB));
    EXPECT_EQ(cross<Q>(j, m.n_AB_W), zero3<Q>());

    const ImpactBody<Q> ground;  // immovable: zeros
    const auto about_C = [&](const Velocity<Q>& u) {
      return angular_momentum<Q>(m.b.mass(), m.b.inertia(), m.b.state.p_WB, u.v_WB, u.w_WB, m.p_WC);
    };
    const PairVelocity<Q> before{{}, m.b.velocity()};
    const Q v_n = relative_velocity<Q>(ground, m.B(), before).dot(m.n_AB_W);
    const Q k = normal_inverse_mass<Q>(ground, m.B(), m.n_AB_W);
    const Vec3<Q> push = normal_impulse<Q>(m.e, v_n, k) * m.n_AB_W;
    const PairVelocity<Q> after = apply_pair_impulse<Q>(ground, m.B(), before, push);
    EXPECT_EQ(relative_velocity<Q>(ground, m.B(), after).dot(m.n_AB_W), -m.e * v_n);
    EXPECT_EQ(about_C(after.B), about_C(m.b.velocity()));
    EXPECT_EQ(after.A.v_WB, zero3<Q>());
    EXPECT_EQ(after.A.w_WB, zero3<Q>());
  }
}

// case BB-05: the catalogue's general example, fractions throughout; its digits are the nearest doubles.
TEST(NormalImpulse, OfTheCataloguesGeneralExampleHasItsPublishedDigits) {
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
  const NormalImpact x = collide(m, normal_impulse<Q>);
  const Q dE = energy(m, x.after) - energy(m, m.before());
  EXPECT_EQ(double(x.v_n), -1.9261904761904762);
  EXPECT_EQ(x.v_r_after.dot(m.n_AB_W), Q(-3, 5) * x.v_n);
  EXPECT_EQ(dE, -(Q(1) - m.e * m.e) * x.v_n * x.v_n / (Q(2) * x.k_nn));
  EXPECT_EQ(double(dE), -1.2000380735844824);
  EXPECT_EQ(total_linear_momentum(m, x.after), total_linear_momentum(m, m.before()));
  EXPECT_EQ(total_angular_momentum(m, x.after, zero3<Q>()),
            total_angular_momentum(m, m.before(), zero3<Q>()));
}

}  // namespace rigor
