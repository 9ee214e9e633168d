// Nanoseconds of every formula in double, at one generic body and contact.
#include <benchmark/benchmark.h>

#include <rigor/formulas/angular_acceleration.hpp>
#include <rigor/formulas/apply_pair_impulse.hpp>
#include <rigor/formulas/cuboid_inertia.hpp>
#include <rigor/formulas/cuboid_inverse_inertia.hpp>
#include <rigor/formulas/force_sum.hpp>
#include <rigor/formulas/friction_coulomb.hpp>
#include <rigor/formulas/friction_sheet.hpp>
#include <rigor/formulas/friction_stronge.hpp>
#include <rigor/formulas/friction_stronge_planar.hpp>
#include <rigor/formulas/friction_tangent.hpp>
#include <rigor/formulas/kinetic_energy.hpp>
#include <rigor/formulas/linear_acceleration.hpp>
#include <rigor/formulas/momentum.hpp>
#include <rigor/formulas/normal_effective_mass.hpp>
#include <rigor/formulas/normal_impulse.hpp>
#include <rigor/formulas/point_velocity.hpp>
#include <rigor/formulas/positional_correction.hpp>
#include <rigor/formulas/semi_implicit_step.hpp>
#include <rigor/formulas/world_inverse_inertia.hpp>
#include <rigor/linalg/rotation.hpp>

namespace {
using namespace rigor;
using V = Vec3<double>;

struct Fixture {
  double m = 2.5, e = 0.6;
  V size{0.7, 1.1, 1.9}, p{1, 2, 3}, v{0.3, -1.2, 0.4}, w{1.1, -0.7, 2.0}, arm{0.3, -0.5, 0.8}, n{2. / 7, 3. / 7, 6. / 7};
  Mat3<double> R = rotation_of<double>(Vec4<double>(1, 2, -1, 3));
  V I = cuboid_inertia<double>(m, size), inverse_I = cuboid_inverse_inertia<double>(I);
  Mat3<double> I_W = world_inertia<double>(R, I), inverse_I_W = world_inverse_inertia<double>(R, inverse_I);
  ImpactBody<double> A{1 / m, inverse_I_W, arm}, B{1 / (2 * m), inverse_I_W, V(-arm)};
  PairVelocity<double> u{{v, w}, {V(-v), V(-w)}};
  Wrench<double> sum;
  State<double> state{p, R, v, w};
  double mu_s = 0.5, mu_d = 0.4;
  Mat3<double> K = effective_inverse_mass<double>(A, B);
  V v_r = V(0.9 * V(3. / 7, -6. / 7, 2. / 7) - 2.0 * n), t = friction_tangent<double>(v_r, zero3<double>(), n);  // 0.9 m/s across, 2 m/s towards
  PlanarImpact<double> planar{dot<double>(n, apply<double>(K, n)), dot<double>(t, apply<double>(K, t)), dot<double>(t, apply<double>(K, n)), -2, 0.9, e, mu_s, mu_d};
};

// The inputs are hidden from the optimiser, the answer is kept.
template <class F>
void measure(const char* id, F formula) {
  benchmark::RegisterBenchmark(id, [formula](benchmark::State& state) {
    Fixture f;
    for (auto _ : state) {
      benchmark::DoNotOptimize(&f);
      benchmark::ClobberMemory();
      auto answer = formula(f);
      benchmark::DoNotOptimize(answer);
    }
  });
}

const int registered = [] {
  using F = const Fixture&;
  measure("inertia.cuboid", [](F f) { return cuboid_inertia<double>(f.m, f.size); });
  measure("inertia.cuboid_inverse", [](F f) { return cuboid_inverse_inertia<double>(f.I); });
  measure("inertia.world", [](F f) { return world_inertia<double>(f.R, f.I); });
  measure("inertia.world_inverse", [](F f) { return world_inverse_inertia<double>(f.R, f.inverse_I); });
  measure("force.torque", [](F f) { return torque_of_force<double>(f.arm, f.v); });
  measure("force.sum", [](F f) { return add_force<double>(f.sum, f.arm, f.v); });
  measure("motion.linear", [](F f) { return linear_acceleration<double>(f.m, f.v); });
  measure("motion.euler", [](F f) { return angular_acceleration<double>(f.I_W, f.inverse_I_W, f.w, f.v); });
  measure("motion.point_velocity", [](F f) { return point_velocity<double>(f.v, f.w, f.arm); });
  measure("rotation.rate", [](F f) { return rotation_rate<double>(f.w, f.R); });
  measure("rotation.naive_step", [](F f) { return naive_rotation_step<double>(f.e, f.w, f.R); });
  measure("rotation.gram_schmidt", [](F f) { return gram_schmidt<double>(f.R); });
  measure("step.semi_implicit", [](F f) { return semi_implicit_step<double>(f.e, f.state, f.v, f.w); });
  measure("impulse.effective_mass", [](F f) { return effective_inverse_mass<double>(f.A, f.B); });
  measure("impulse.normal_effective_mass", [](F f) { return normal_inverse_mass<double>(f.A, f.B, f.n); });
  measure("impulse.normal", [](F f) { return normal_impulse<double>(f.e, f.v[1], f.m); });
  measure("impulse.apply", [](F f) { return apply_impulse<double>(f.A, f.u.A, f.n); });
  measure("impulse.apply_pair", [](F f) { return apply_pair_impulse<double>(f.A, f.B, f.u, f.n); });
  measure("impulse.relative_velocity", [](F f) { return relative_velocity<double>(f.A, f.B, f.u); });
  measure("friction.tangent", [](F f) { return friction_tangent<double>(f.v, f.w, f.n); });
  measure("energy.kinetic", [](F f) { return kinetic_energy<double>(f.m, f.I_W, f.v, f.w); });
  measure("energy.impulse", [](F f) { return impulse_energy<double>(f.n, f.v, f.w); });
  measure("momentum.linear", [](F f) { return linear_momentum<double>(f.m, f.v); });
  measure("momentum.angular", [](F f) { return angular_momentum<double>(f.m, f.I_W, f.p, f.v, f.w, f.size); });
  measure("impulse.normal_printed", [](F f) { return normal_impulse_printed<double>(f.e, f.v[1], f.m); });
  measure("friction.sheet", [](F f) { return sheet_friction_impulse<double>(f.m, f.mu_s, f.mu_d, f.e, f.v[0]); });
  measure("friction.sheet_literal", [](F f) { return sheet_literal_friction_impulse<double>(f.mu_d, f.e, f.v[0]); });
  measure("friction.coulomb", [](F f) { return coulomb_impulse<double>(f.K, f.v_r, f.n, f.t, f.e, f.mu_s, f.mu_d); });
  measure("friction.stronge_planar", [](F f) { return planar_impulse<double>(f.planar, Restitution::stronge); });
  measure("friction.stronge", [](F f) { return stronge_impulse(f.K, f.v_r, f.n, f.e, f.mu_s, f.mu_d); });
  measure("contact.correction", [](F f) { return positional_correction<double>(f.e, f.n); });
  return 0;
}();

}  // namespace
