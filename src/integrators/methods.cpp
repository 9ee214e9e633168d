#include <rigor/formulas/world_inertia.hpp>
#include <rigor/integrators/dormand_prince.hpp>
#include <rigor/integrators/euler.hpp>
#include <rigor/integrators/lie_group.hpp>
#include <rigor/integrators/method.hpp>
#include <rigor/integrators/moser_veselov.hpp>
#include <rigor/integrators/runge_kutta.hpp>
#include <rigor/integrators/splitting.hpp>
#include <rigor/integrators/taylor.hpp>

namespace rigor {

Motion motion_of(const Cuboid<double>& body, const State<double>& state) {
  return {state, apply<double>(world_inertia<double>(state.R_WB, body.inertia()), state.w_WB)};
}

const std::vector<Method>& methods() {
  static const std::vector<Method> rows{
      {"sheet", 1, 1, "", 1, "assignment, Part 1", step_sheet, nullptr, fly_sheet},
      {"explicit-euler", 1, 1, "", 1, "textbook; gains energy, case D-07", step_explicit_euler, nullptr, fly_explicit_euler},
      {"euler-naive", 1, 1, "", 1, "assignment, Part 1, before the repair; case K-07", step_euler_naive, nullptr, fly_euler_naive},
      {"euler-exponential", 1, 1, "", 1, "Rodrigues' formula in place of the repair", step_euler_exponential, nullptr, fly_euler_exponential},
      {"euler-quaternion", 1, 1, "", 1, "a quaternion in place of R, made a unit one; case K-08", step_euler_quaternion, nullptr, fly_euler_quaternion},
      {"euler-momentum", 1, 1, "L", 1, "angular momentum as state, case D-08", step_euler_momentum, nullptr, fly_euler_momentum_cross},
      {"euler-momentum-cross", 1, 1, "L", 1, "angular momentum as state, third column by cross product", step_euler_momentum_cross, nullptr, fly_euler_momentum_cross},
      {"euler-momentum-exponential", 1, 1, "L", 1, "angular momentum as state, exponential map; Lie and Euler", step_euler_momentum_exponential, nullptr, fly_euler_momentum_exponential},
      {"rk4", 4, 4, "", 4, "Kutta 1901, on quaternions", step_rk4, step_rk4_under, fly_rk4},
      {"dormand-prince", 5, 5, "", 6, "Dormand and Prince 1980; equal steps", step_dormand_prince, step_dormand_prince_under},
      {"implicit-midpoint", 2, 2, "L, energy", 8, "Lewis and Simo 1994; Cayley's map", step_implicit_midpoint, step_implicit_midpoint_under, fly_implicit_midpoint},
      {"buss-augmented", 2, 2, "L", 2, "Buss 2000", step_buss_augmented, step_buss_augmented_under, fly_buss_augmented},
      {"rkmk4", 4, 4, "L", 4, "Munthe-Kaas 1998", step_rkmk4, step_rkmk4_under, fly_rkmk4},
      {"commutator-free4", 4, 4, "L", 4, "Celledoni, Marthinsen and Owren 2003", step_commutator_free4, step_commutator_free4_under, fly_commutator_free4},
      {"split3", 2, 2, "L", 4, "McLachlan 1993; Reich 1994", step_split3, step_split3_under, fly_split3},
      {"split3-yoshida4", 4, 4, "L", 12, "Yoshida 1990", step_split3_yoshida4, step_split3_yoshida4_under, fly_split3_yoshida4},
      {"split2", 2, 2, "L", 2, "Casimir taken out; docs/studies.md", step_split2, step_split2_under, fly_split2},
      {"split2-yoshida4", 4, 4, "L", 6, "Yoshida 1990", step_split2_yoshida4, step_split2_yoshida4_under, fly_split2_yoshida4},
      {"split2-kahan-li6", 6, 6, "L", 18, "Kahan and Li 1997", step_split2_kahan_li6, step_split2_kahan_li6_under, fly_split2_kahan_li6},
      {"split2-kahan-li8", 8, 8, "L", 34, "Kahan and Li 1997", step_split2_kahan_li8, step_split2_kahan_li8_under, fly_split2_kahan_li8},
      {"moser-veselov", 2, 2, "L, energy", 8, "Moser and Veselov 1991", step_moser_veselov, step_moser_veselov_under, fly_moser_veselov},
      {"moser-veselov4", 4, 4, "L, energy", 8, "Hairer and Vilmart 2006", step_moser_veselov4, step_moser_veselov4_under, fly_moser_veselov4},
      {"moser-veselov8", 8, 8, "L, energy", 8, "Hairer and Vilmart 2006", step_moser_veselov8, step_moser_veselov8_under, fly_moser_veselov8},
      {"taylor16", 16, 8, "L", 16, "Taylor series of the quadratic equations", step_taylor16, step_taylor16_under, fly_taylor16},
  };
  return rows;
}

Motion advance(const Method& method, const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h) {
  if (method.step_under != nullptr) return method.step_under(body, now, load, t, h);
  return method.step(body, now, load(t + h / 2, now.state), h);
}

const Method* find_method(std::string_view name) {
  for (const Method& method : methods())
    if (method.name == name) return &method;
  return nullptr;
}

}  // namespace rigor
