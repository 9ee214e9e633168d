// The closed form as a method keeps the laws of every method.
#include <rigor/engine/flow_methods.hpp>
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

}  // namespace
}  // namespace rigor
