#include <rigor/formulas/world_inertia.hpp>
#include <rigor/integrators/euler.hpp>
#include <rigor/integrators/method.hpp>
#include <rigor/integrators/runge_kutta.hpp>

namespace rigor {

Motion motion_of(const Cuboid<double>& body, const State<double>& state) {
  return {state, apply<double>(world_inertia<double>(state.R_WB, body.inertia()), state.w_WB)};
}

const std::vector<Method>& methods() {
  static const std::vector<Method> rows{
      {"sheet", 1, "", 1, "assignment, Part 1", step_sheet},
      {"explicit-euler", 1, "", 1, "textbook; gains energy, case D-07", step_explicit_euler},
      {"euler-naive", 1, "", 1, "assignment, Part 1, before the repair; case K-07", step_euler_naive},
      {"euler-exponential", 1, "", 1, "Rodrigues' formula in place of the repair", step_euler_exponential},
      {"euler-momentum", 1, "L", 1, "angular momentum as state, case D-08", step_euler_momentum},
      {"rk4", 4, "", 4, "Kutta 1901, on quaternions", step_rk4},
  };
  return rows;
}

const Method* find_method(std::string_view name) {
  for (const Method& method : methods())
    if (method.name == name) return &method;
  return nullptr;
}

}  // namespace rigor
