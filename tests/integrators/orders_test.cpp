// The laws of laws.hpp for the methods of this room. Over whole flights and against 60 digits their orders are held in tests/studies.
#include <rigor/formulas/world_inverse_inertia.hpp>
#include <rigor/integrators/composition.hpp>
#include <rigor/integrators/splitting.hpp>
#include <rigor/integrators/turning.hpp>
#include <tests/integrators/laws.hpp>

namespace rigor {
namespace {

const LoadAt unloaded = [](double, const State<double>&) { return Load{}; };

// case D-09
TEST(EveryMethod, ConservesWhatItSays) {
  for (const Method& m : methods()) expect_to_conserve_what_it_says(m);
}

// case FB-10
TEST(EveryMethod, ComesBackIfItIsSymmetric) {
  int counted = 0;
  for (const Method& m : methods()) {
    if (m.name == "euler-naive") continue;  // its R leaves the rotations
    counted += symmetric(m);
    expect_to_come_back_if_symmetric(m, unloaded, m.order);
    expect_to_come_back_if_symmetric(m, changing_load, m.forced_order);
  }
  EXPECT_GE(counted, 10);
}

// case D-11, in one step, where a coefficient of the highest order is not drowned by lower terms or by rounding. The two references are
// of two families, and each is judged by the other under the load and by its own parts without.
TEST(EveryMethod, HasTheOrderItStatesInOneStep) {
  const auto slack = [](int order) { return order <= 4 ? 0.05 : order <= 6 ? 0.2 : order <= 8 ? 0.5 : 2; };  // measured: 0.02, 0.13, 0.45, 1.33
  for (const Method& m : methods()) {
    EXPECT_NEAR(local_order(m, *find_method("taylor16"), unloaded), m.order, slack(m.order)) << m.name;
    EXPECT_NEAR(local_order(m, *find_method(m.name == "taylor16" ? "split2-kahan-li8" : "taylor16"), changing_load), m.forced_order, slack(m.forced_order)) << m.name;
  }
}

// A number at the end of a name is the order, but for the bare splittings'.
TEST(EveryMethod, IsCalledByItsOrder) {
  for (const Method& m : methods()) {
    const std::size_t digits = m.name.find_last_not_of("0123456789") + 1;
    if (digits == m.name.size() || m.name == "split2" || m.name == "split3") continue;  // two axes, three axes
    EXPECT_EQ(std::stoi(std::string(m.name.substr(digits))), m.order) << m.name;
  }
}

// What a step costs: loads asked for by the explicit methods, turns of a splitting's stage times its stages, terms of the series. The
// implicit ones are counted as eight, rounds of their fixed points in ordinary steps.
TEST(EveryMethod, CostsWhatItsStagesCost) {
  const auto cost = [](const char* name) { return find_method(name)->evaluations; };
  for (const Method& m : methods()) {
    const bool implicit = says(m, "energy");
    if (m.order == 1 || implicit) {
      EXPECT_EQ(m.evaluations, implicit ? 8 : 1) << m.name;
    }
  }
  for (const char* name : {"rk4", "dormand-prince", "rkmk4", "commutator-free4", "buss-augmented"}) {
    int asked = 0;
    advance(*find_method(name), plate, motion_of(plate, tumbling()), [&](double, const State<double>&) { return ++asked, Load{}; }, 0, 0.1);
    EXPECT_EQ(asked, cost(name)) << name;
  }
  EXPECT_EQ(cost("split2"), 2);  // the ends of neighbouring steps are one turn
  EXPECT_EQ(cost("split3"), 4);
  EXPECT_EQ(cost("split3-yoshida4"), int(yoshida4.size()) * cost("split3"));
  EXPECT_EQ(cost("split2-yoshida4"), int(yoshida4.size()) * cost("split2"));
  EXPECT_EQ(cost("split2-kahan-li6"), int(kahan_li6.size()) * cost("split2"));
  EXPECT_EQ(cost("split2-kahan-li8"), int(kahan_li8.size()) * cost("split2"));
  EXPECT_EQ(cost("taylor16"), find_method("taylor16")->order);
}

TEST(EveryMethod, FliesNoStepToWhereItIs) {
  const Motion start = motion_of(plate, tumbling());
  for (const Method& m : methods()) {
    if (m.fly == nullptr) continue;
    const Motion end = m.fly(plate, start, 0.1, 0);
    EXPECT_LT(norm<double>(Vec3<double>(end.state.w_WB - start.state.w_WB)), 1e-15) << m.name;
    EXPECT_EQ(end.state.p_WB, start.state.p_WB) << m.name;
    EXPECT_LT(angle_between<double>(end.state.R_WB, start.state.R_WB), 1e-15) << m.name;
  }
}

// case FB-13: without its gyroscopic term a body keeps w in space and turns about it. The energy does not see that, the angular momentum
// does: L turns with the body.
TEST(FreeBody, WithoutItsGyroscopicTermKeepsTheEnergyAndNotTheMomentum) {
  const State<double> s = tumbling();
  const auto L = [&](double t) {
    const Mat3<double> R = exp_so3<double>(Vec3<double>(t * s.w_WB)) * s.R_WB;
    return Vec3<double>(R * plate.inertia().cwiseProduct(Vec3<double>(R.transpose() * s.w_WB)));
  };
  const Vec3<double> before = L(0);
  for (const double t : {0.5, 1.0, 2.0}) {
    EXPECT_NEAR(L(t).dot(s.w_WB) / before.dot(s.w_WB), 1, 1e-14) << t;
    EXPECT_GT(norm<double>(Vec3<double>(L(t) - before)), 0.1 * norm<double>(before)) << t;
  }
}

TEST(Split2, TakesOutTheMiddleMoment) {
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      if (a == b) continue;
      Vec3<double> I;
      I[a] = 1, I[b] = 2, I[3 - a - b] = 3;
      EXPECT_EQ(middle_axis(I), b);
    }
  for (int other = 0; other < 3; ++other)
    for (const double apart : {1.0, 3.0}) {
      Vec3<double> I = Vec3<double>::Constant(2);
      I[other] = apart;
      EXPECT_NE(middle_axis(I), other) << "of two equal moments either is the middle one";
    }
  EXPECT_EQ(middle_axis(Vec3<double>(2, 2, 2)), 0);
}

// Buss 2000, in world axes: the mean spin of a step is w + h/2 w' + h²/12 w' x w; the way it is computed is in body axes.
TEST(BussAugmented, TurnsByTheMeanSpinOfItsSource) {
  const State<double> s = tumbling();
  const double h = 0.1;
  const Vec3<double> L = motion_of(plate, s).L_W, w = s.w_WB;
  const Mat3<double> inverse_I = world_inverse_inertia<double>(s.R_WB, plate.inverse_inertia());
  const Vec3<double> a = apply<double>(inverse_I, Vec3<double>(-cross<double>(w, L)));
  const Vec3<double> mean = w + h / 2 * a + h * h / 12 * cross<double>(a, w);
  EXPECT_LT(angle_between<double>(find_method("buss-augmented")->step(plate, motion_of(plate, s), {}, h).state.R_WB, exp_so3<double>(Vec3<double>(h * mean)) * s.R_WB), 1e-15);
}

// A load that the method holds is held as it is at the middle of the step.
TEST(EveryMethod, HoldsALoadOfTimeAtTheMiddle) {
  const LoadAt push = [](double t, const State<double>&) { return Load{Vec3<double>(0, t, 0), zero3<double>()}; };
  for (const Method& m : methods()) {
    const double t = 0.75, h = 0.5;
    EXPECT_NEAR(advance(m, plate, motion_of(plate, {}), push, t, h).state.v_WB[1], (t + h / 2) * h / plate.mass(), 1e-15) << m.name;
  }
}

// Symmetric steps, written as a splitting of unlike parts: the same step but for rounding.
TEST(SplitStep, OfSymmetricStepsIsTheComposedStep) {
  const FreeTurn turn = [](const Cuboid<double>& body, const Vec3<double>& L_B, double h, long) {
    return quaternion_of<double>(exp_so3<double>(Vec3<double>(h * L_B.cwiseProduct(body.inverse_inertia()))));
  };
  const auto [outer, inner, last] = yoshida4;
  const Motion start = motion_of(plate, tumbling()), composed = composed_step(turn, yoshida4, plate, start, changing_load, 0.3, 0.2);
  EXPECT_GT(norm<double>(Vec3<double>(composed.L_W - start.L_W)), 0.1);
  for (const Splitting& parts : {Splitting{{outer / 2, (outer + inner) / 2, (inner + last) / 2, last / 2, 0, 0, 0}, {outer, inner, last, 0, 0, 0}},
                                 Splitting{{0, 0, 0, outer / 2, (outer + inner) / 2, (inner + last) / 2, last / 2}, {0, 0, 0, outer, inner, last}}}) {
    const Motion split = split_step(turn, parts, plate, start, changing_load, 0.3, 0.2);
    EXPECT_LT(angle_between<double>(split.state.R_WB, composed.state.R_WB), 1e-14);
    EXPECT_LT(norm<double>(Vec3<double>(split.state.p_WB - composed.state.p_WB)), 1e-14);
    EXPECT_LT(norm<double>(Vec3<double>(split.state.v_WB - composed.state.v_WB)), 1e-14);
    EXPECT_LT(norm<double>(Vec3<double>(split.L_W - composed.L_W)), 1e-14);
  }
}

}  // namespace
}  // namespace rigor
