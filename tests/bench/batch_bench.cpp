// Nanoseconds per body-step of the batch beside the plain methods it equals and, where they are installed, beside Bullet and ODE.
#include <benchmark/benchmark.h>

#include <rigor/engine/batch.hpp>
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

const int rows = [] {
  for (const BatchMethod method : batch_methods) {
    const std::string label(plain(method).name);
    benchmark::RegisterBenchmark(("plain/" + label + "/bodies:1000").c_str(), [method](benchmark::State& state) {
      std::vector<Motion> motions = starts(1000);
      const auto step = plain(method).step;
      for (auto _ : state) {
        for (Motion& motion : motions) motion = step(body, motion, {}, 1e-3);
        benchmark::ClobberMemory();
      }
      count_steps(state, 1000);
    });
    for (const Instructions with : supported_instructions())
      for (const long n : {1000, 100000})
        for (const long steps : {1, 100})
          for (const unsigned threads : {1u, 2u}) {
            if (threads > 1 && !(steps == 100 && with == supported_instructions().back())) continue;
            auto* const registered = benchmark::RegisterBenchmark(
                ("batch/" + label + "/" + name(with) + "/bodies:" + std::to_string(n) + "/steps at once:" + std::to_string(steps) + "/threads:" + std::to_string(threads)).c_str(),
                [=](benchmark::State& state) {
                  Batch batch = *Batch::make(std::vector<Cuboid<double>>(std::size_t(n), body), starts(n), method);
                  for (auto _ : state) batch.step(1e-3, steps, threads, with);
                  count_steps(state, n * steps);
                });
            if (threads > 1) registered->UseRealTime();  // the rest, as the peers, by processor time
          }
  }
  return 0;
}();

}  // namespace
