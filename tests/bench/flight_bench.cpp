// Nanoseconds of an exact flight: set-up, one evaluation, and many flights together.
#include <benchmark/benchmark.h>

#include <random>
#include <rigor/engine/flight_batch.hpp>
#include <rigor/linalg/rotation.hpp>

namespace {
using namespace rigor;
using V = Vec3<double>;
using Precision = ExactFlight::Precision;

const V moments(13 / 12., 10 / 12., 5 / 12.);  // cuboid 1 x 2 x 3 m, 1 kg
const V spins[3] = {{0.3, 2, 0.2}, {5, 0.01, 0.01}, {1e-6, 2, 1e-6}};  // tumbling, about the stable axis, near the separatrix

void set_up(benchmark::State& state, V w, Precision precision) {
  V I = moments;
  for (auto _ : state) {
    benchmark::DoNotOptimize(I);
    benchmark::DoNotOptimize(w);
    benchmark::DoNotOptimize(ExactFlight::make(I, w, identity3<double>(), precision));
  }
}
void evaluation(benchmark::State& state, const V& w) {
  const ExactFlight flight = *ExactFlight::make(moments, w, identity3<double>());
  double t = 10;
  for (auto _ : state) {
    benchmark::DoNotOptimize(t);
    benchmark::DoNotOptimize(flight.at(t));
  }
}

// Cuboids of 0.5 to 3 m; `kind` of their series, or any where it is pure_rotation.
std::vector<ExactFlight> flights(long n, ExactFlight::Tuned::Kind kind) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> edge(0.5, 3);
  std::normal_distribution<double> spin;
  std::vector<ExactFlight> all;
  while (long(all.size()) < n) {
    const double a = edge(random), b = edge(random), c = edge(random);
    const ExactFlight flight = *ExactFlight::make(V(b * b + c * c, a * a + c * c, a * a + b * b), V(spin(random), spin(random), spin(random)), identity3<double>());
    if (kind == ExactFlight::Tuned::Kind::pure_rotation || flight.tuned().kind == kind) all.push_back(flight);
  }
  return all;
}
void batch(benchmark::State& state, long n, ExactFlight::Tuned::Kind kind, Instructions with) {
  FlightBatch flying(flights(n, kind));
  double t = 3.7;
  for (auto _ : state) flying.evaluate(t += 1e-3, 1, with);
  state.counters["ns_per_body"] = benchmark::Counter(double(n) * double(state.iterations()) * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

const int registered = [] {
  using Kind = ExactFlight::Tuned::Kind;
  const char* cases[] = {"A", "B", "C"};
  for (int k = 0; k < 3; ++k) {
    const V w = spins[k];
    const std::string name = cases[k];
    benchmark::RegisterBenchmark(("set_up/plain/" + name).c_str(), [w](benchmark::State& s) { set_up(s, w, Precision::plain); });
    benchmark::RegisterBenchmark(("set_up/extended/" + name).c_str(), [w](benchmark::State& s) { set_up(s, w, Precision::extended); });
    benchmark::RegisterBenchmark(("evaluation/" + name).c_str(), [w](benchmark::State& s) { evaluation(s, w); });
  }
  for (const Instructions with : supported_instructions())
    for (const auto& [kind, what] : {std::pair{Kind::theta, "m<1/2"}, {Kind::theta_prime, "m>1/2"}, {Kind::pure_rotation, "mixed"}})
      benchmark::RegisterBenchmark(("batch/" + std::string(name(with)) + "/" + what + "/bodies:1000").c_str(),
                                   [=, kind = kind](benchmark::State& s) { batch(s, 1000, kind, with); });
  return 0;
}();

}  // namespace
