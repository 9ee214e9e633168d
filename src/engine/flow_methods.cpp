#include <array>
#include <limits>
#include <rigor/engine/exact_flight.hpp>
#include <rigor/engine/flow_methods.hpp>
#include <rigor/integrators/composition.hpp>
#include <rigor/integrators/turning.hpp>

namespace rigor {
namespace {

// One flight from here: constants in double are enough for one step.
Turning exact(const Cuboid<double>& body, const Turning& now, double h) {
  const auto flight = ExactFlight::make(body.inertia(), Vec3<double>(now.L_B.cwiseProduct(body.inverse_inertia())), now.R_WB, ExactFlight::Precision::plain);
  if (!flight) return {Mat3<double>::Constant(std::numeric_limits<double>::quiet_NaN()), now.L_B};  // a spin that is no number
  const Attitude end = flight->at(h);
  return {end.R_WB, end.L_B};
}

Motion step_exact(const Cuboid<double>& body, const Motion& now, const Load& load, double h) { return kicked_step(exact, body, now, load, h); }
Motion step_exact_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h) { return composed_step(exact, strang, body, now, load, t, h); }
Motion step_exact_kicks4_under(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h) { return split_step(exact, blanes_moan4, body, now, load, t, h); }

}  // namespace

const std::vector<Method>& flow_methods() {
  static const std::vector<Method> rows{
      {"exact", 0, 2, "L, energy", 1, "van Zon and Schofield 2007; docs/exact-flight.md", step_exact, step_exact_under},
      {"exact-kicks4", 0, 4, "L, energy", 6, "Blanes and Moan 2002", step_exact, step_exact_kicks4_under},
  };
  return rows;
}

}  // namespace rigor
