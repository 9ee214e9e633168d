#include <array>
#include <limits>
#include <rigor/engine/exact_flight.hpp>
#include <rigor/engine/flow_methods.hpp>
#include <rigor/integrators/composition.hpp>
#include <rigor/integrators/turning.hpp>

namespace rigor {
namespace {

// Set up anew for each step, with constants in double: enough for one step.
Vec4<double> exact(const Cuboid<double>& body, const Vec3<double>& L_B, double h, long steps) {
  Attitude x{identity3<double>(), L_B};
  for (long step = 0; step < steps; ++step) {
    const auto flight = ExactFlight::make(body.inertia(), Vec3<double>(x.L_B.cwiseProduct(body.inverse_inertia())), x.R_WB, ExactFlight::Precision::plain);
    if (!flight) return Vec4<double>::Constant(std::numeric_limits<double>::quiet_NaN());  // a spin that is no number
    x = flight->at(h);
  }
  return quaternion_of<double>(x.R_WB);
}

Motion step_exact(const Cuboid<double>& body, const Motion& now, const Load& load, double h) { return kicked_step(exact, body, now, load, h); }
Motion step_exact_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h) { return composed_step(exact, strang, body, now, load, t, h); }
Motion fly_exact(const Cuboid<double>& body, const Motion& now, double h, long steps) { return free_flight(exact, body, now, h, steps); }
Motion step_exact_kicks4_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h) { return split_step(exact, blanes_moan4, body, now, load, t, h); }

}  // namespace

const std::vector<Method>& flow_methods() {
  static const std::vector<Method> rows{
      {"exact", 0, 2, "L, energy", 1, "van Zon and Schofield 2007; docs/exact-flight.md", step_exact, step_exact_under, fly_exact},
      {"exact-kicks4", 0, 4, "L, energy", 6, "Blanes and Moan 2002", step_exact, step_exact_kicks4_under, fly_exact},
  };
  return rows;
}

}  // namespace rigor
