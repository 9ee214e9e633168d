// ODE (double): the free bodies of the batch benchmark. No damping, no auto-disable, gyroscopic mode on, nothing collides.
#include <benchmark/benchmark.h>
#include <ode/ode.h>

namespace {

static_assert(sizeof(dReal) == 8, "ODE built for double");

constexpr int bodies = 1000;
void count(benchmark::State& state) {
  state.counters["ns_per_body_step"] = benchmark::Counter(bodies * double(state.iterations()) * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void ode(benchmark::State& state, int (*step)(dWorldID, dReal)) {
  static const bool started = dInitODE2(0) != 0;
  if (!started) return state.SkipWithError("ODE does not start");
  const dWorldID world = dWorldCreate();
  dWorldSetAutoDisableFlag(world, 0);
  dWorldSetDamping(world, 0, 0);
  for (int i = 0; i < bodies; ++i) {
    const dBodyID body = dBodyCreate(world);
    dMass mass;
    dMassSetBoxTotal(&mass, 2.5, 0.7, 1.1, 1.9);
    dBodySetMass(body, &mass);
    dBodySetAngularVel(body, 0.3, 1, 0.1 * (i % 11));
    dBodySetGyroscopicMode(body, 1);
  }
  for (auto _ : state) step(world, 1e-3);
  count(state);
  dWorldDestroy(world);
}
BENCHMARK_CAPTURE(ode, step, dWorldStep);
BENCHMARK_CAPTURE(ode, quickstep, dWorldQuickStep);

}  // namespace
