#include <cstdio>
#include <rigor/bodies/cuboid.hpp>
#include <rigor/formulas/semi_implicit_step.hpp>

int main() {
  const auto box = rigor::Cuboid<double>::make(10, {0.1, 0.4, 0.9});
  rigor::State<double> state;
  state.w_WB = {0, 1, 0};
  state = rigor::semi_implicit_step<double>(0.5, state, {0, -9.8, 0}, {0, 0, 0});
  std::printf("%.17g %.17g\n", box->inertia()[0], state.p_WB[1]);
}
