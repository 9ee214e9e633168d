// The closed form as a method keeps the laws of every method.
#include <rigor/engine/flow_methods.hpp>
#include <rigor/integrators/composition.hpp>
#include <tests/integrators/laws.hpp>

namespace rigor {
namespace {

TEST(FlowMethods, ConserveWhatTheySay) {
  for (const Method& m : flow_methods()) expect_to_conserve_what_it_says(m);
}

TEST(FlowMethods, ComeBack) {
  for (const Method& m : flow_methods()) {
    EXPECT_TRUE(symmetric(m)) << m.name;
    expect_to_come_back_if_symmetric(m, [](double, const State<double>&) { return Load{}; }, m.order);
    expect_to_come_back_if_symmetric(m, changing_load, m.forced_order);
  }
}

// Order 0: without a load nothing is left at any step. Under one, the order of the kicks.
TEST(FlowMethods, HaveTheOrderTheyStateInOneStep) {
  const LoadAt no_load = [](double, const State<double>&) { return Load{}; };
  const Method& series = *find_method("taylor16");
  for (const Method& m : flow_methods()) {
    EXPECT_EQ(m.order, 0) << m.name;
    EXPECT_TRUE(std::isnan(local_order(m, series, no_load))) << m.name << ": below 1e-12 at a step of 3.2 s";
    EXPECT_NEAR(local_order(m, series, changing_load), m.forced_order, 0.05) << m.name;  // measured: 0.01
  }
}

// Flows of the rotation in one step.
TEST(FlowMethods, CostWhatTheirStagesCost) {
  ASSERT_EQ(flow_methods().size(), 2u);
  EXPECT_EQ(flow_methods()[0].evaluations, int(strang.size()));
  EXPECT_EQ(flow_methods()[1].evaluations, int(blanes_moan4.flow.size()));
}

// Forty steps are one step forty times as long, and none is where it is.
TEST(FlowMethods, FlyAsFarAsOneStep) {
  const Motion start = motion_of(plate, tumbling());
  for (const Method& m : flow_methods())
    for (const long steps : {0L, 1L, 40L}) {
      const State<double> end = m.fly(plate, start, 0.1, steps).state, want = m.step(plate, start, {}, 0.1 * double(steps)).state;
      EXPECT_LT(angle_between<double>(end.R_WB, want.R_WB), 1e-13) << m.name << ", " << steps;  // some 1e-15 a step
      EXPECT_LT(norm<double>(Vec3<double>(end.w_WB - want.w_WB)), 1e-13) << m.name << ", " << steps;
      EXPECT_LT(norm<double>(Vec3<double>(end.p_WB - want.p_WB)), 1e-14) << m.name << ", " << steps;
    }
}

}  // namespace
}  // namespace rigor
