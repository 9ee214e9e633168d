// Nanoseconds per body-step of the batch beside the plain methods it equals and, where they are installed, beside Bullet and ODE.
#include <benchmark/benchmark.h>

#include <rigor/engine/batch.hpp>
#include <rigor/integrators/euler.hpp>
#include <rigor/linalg/rotation.hpp>
#include <string>

namespace {
using namespace rigor;

const Cuboid<double> body = *Cuboid<double>::make(2.5, {0.7, 1.1, 1.9});
Motion start(int i) {
  State<double> s;
  s.R_WB = rotation_of<double>(Vec4<double>(9, 1, -1, i % 7));
  s.w_WB = Vec3<double>(0.3, 1, 0.1 * (i % 11));
  return motion_of(body, s);
}
std::vector<Motion> starts(long n) {
  std::vector<Motion> all;
  for (int i = 0; i < n; ++i) all.push_back(start(i));
  return all;
}
void count_steps(benchmark::State& state, long body_steps) {
  state.counters["ns_per_body_step"] =
      benchmark::Counter(double(body_steps) * double(state.iterations()) * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void plain(benchmark::State& state, Motion (*step)(const Cuboid<double>&, const Motion&, const Load&, double)) {
  std::vector<Motion> motions = starts(state.range(0));
  for (auto _ : state) {
    for (Motion& motion : motions) motion = step(body, motion, {}, 1e-3);
    benchmark::ClobberMemory();
  }
  count_steps(state, state.range(0));
}
BENCHMARK_CAPTURE(plain, momentum, step_euler_momentum)->Arg(1000);
BENCHMARK_CAPTURE(plain, cross, step_euler_momentum_cross)->Arg(1000);

const int registered = [] {
  for (const auto& [method, label] : {std::pair{BatchMethod::euler_momentum, "momentum"}, {BatchMethod::euler_momentum_cross, "cross"}})
    for (const Instructions with : supported_instructions())
      for (const long n : {1000, 100000})
        for (const long steps : {1, 100})
          for (const unsigned threads : {1u, 2u})
            if (threads == 1 || (steps == 100 && with == supported_instructions().back()))
              benchmark::RegisterBenchmark(("batch/" + std::string(label) + "/" + name(with) + "/bodies:" + std::to_string(n) + "/steps at once:" + std::to_string(steps) + "/threads:" + std::to_string(threads)).c_str(),
                                           [=, method = method](benchmark::State& state) {
                                             Batch batch = *Batch::make(std::vector<Cuboid<double>>(std::size_t(n), body), starts(n), method);
                                             for (auto _ : state) batch.step(1e-3, steps, threads, with);
                                             count_steps(state, n * steps);
                                           })
                  ->UseRealTime();
  return 0;
}();

}  // namespace
