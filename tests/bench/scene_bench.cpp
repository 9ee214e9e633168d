// N cuboids spread out over a floor, no pairs meet: a step of the assignment's program as the sheet's stepper does it, and a
// second in located mode, of which each has a few impacts. The sheet's with its accounts of energy and momentum, and without (skip `monitors`).
#include <benchmark/benchmark.h>

#include <cmath>
#include <rigor/engine/located.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/scene/simulate.hpp>

namespace {
using namespace rigor;

Scene spread(int n) {
  Scene s;
  const int side = int(std::ceil(std::sqrt(double(n))));
  for (int i = 0; i < n; ++i) {
    State<double> start;
    start.p_WB = Vec3<double>(4 * (i % side), 1.5, 4 * (i / side));
    start.R_WB = rotation_of<double>(Vec4<double>(9, 1, -1, 2));
    start.w_WB = Vec3<double>(0.3, 1, -0.2);
    s.bodies.push_back({*Cuboid<double>::make(2.5, {0.7, 1.1, 1.9}), start});
  }
  s.planes.push_back(*Plane<double>::make({0, 0, 0}, {0, 1, 0}));
  s.surface = *Surface<double>::make(0.5, 0.5, 0.3);
  return s;
}

void sheet_step(benchmark::State& state, bool accounts) {
  const int n = int(state.range(0)), steps = 240;  // one second: they fall, and land
  Scene s = spread(n);
  s.until = steps * s.dt;
  s.every = s.until;
  Skips skips;
  skips.monitors = !accounts;
  for (auto _ : state) benchmark::DoNotOptimize(simulate(s, [](double, const std::vector<State<double>>&) {}, {}, skips).ledger.impacts);
  state.counters["ns_per_step"] = benchmark::Counter(double(steps) * double(state.iterations()) * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["ns_per_body_step"] = benchmark::Counter(double(steps) * n * double(state.iterations()) * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
void located_second(benchmark::State& state) {
  Scene s = spread(int(state.range(0)));
  s.until = s.every = 1;
  for (auto _ : state) benchmark::DoNotOptimize(simulate_located(s, [](double, const std::vector<State<double>>&) {})->ledger.impacts);
  state.counters["us_per_body"] = benchmark::Counter(double(state.range(0)) * double(state.iterations()) * 1e-6, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(located_second)->Arg(1)->Arg(10)->Arg(100)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sheet_step, with_accounts, true)->Arg(1)->Arg(10)->Arg(100)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sheet_step, without, false)->Arg(1)->Arg(10)->Arg(100)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);

}  // namespace
