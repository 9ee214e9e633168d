#pragma once
#include <functional>
#include <reference/free_body.hpp>
#include <rigor/base/outcome.hpp>
#include <span>
#include <vector>

namespace rigor::reference {

/// y' = f(t, y): writes dy.
using Rhs = std::function<void(double t, std::span<const double> y, std::span<double> dy)>;

/// What an integration cost and gave.
struct Solution {
  std::vector<double> y;
  double t = 0;
  long steps = 0, evaluations = 0;
};

enum class Cvode { adams, bdf };

/// CVODE with its fixed-point solver (Adams) or Newton with a difference-quotient dense matrix (BDF), rtol = atol = tolerance. An Adams
/// run is good to about 1e-12 at best: below tolerance 1e-14 it does not reliably improve.
/// Faults: unsupported, with SUNDIALS' own words, when the integration fails; out_of_range for a tolerance below 1e-15.
Outcome<Solution> cvode(const Rhs& f, std::vector<double> y0, double t0, double t1, double tolerance, Cvode kind = Cvode::adams);

/// How f changes along s: ds = (∂f/∂y) s.
using Tangent = std::function<void(double t, std::span<const double> y, std::span<const double> s, std::span<double> ds)>;
/// The end, and how it changes with each thing that the start depends on.
struct Sensitivity {
  std::vector<double> y;
  std::vector<std::vector<double>> dy;
};
/// CVODES, forward sensitivities by Adams: y, and s' = (∂f/∂y) s from every s0, with the errors of all controlled together. Relative
/// error of the changes on the free body: 1e-11 at tolerance 1e-14 (tests/reference). Faults as cvode.
Outcome<Sensitivity> cvodes(const Rhs& f, const Tangent& df, std::vector<double> y0, std::vector<std::vector<double>> s0, double t0, double t1, double tolerance);

/// ARKODE through ARKStep, explicit. Never through ERKStep: in 6.4.1 it reuses the last stage as the first of the next
/// step whenever c_s = 1, which costs the order (tests/reference shows it).
enum class ErkTable {
  heun_euler_2_1_2, bogacki_shampine_4_2_3, ark324_4_2_3, zonneveld_5_3_4, ark436_6_3_4, ark437_7_3_4, sayfy_aburub_6_3_4, cash_karp_6_4_5,
  fehlberg_6_4_5, dormand_prince_7_4_5, ark548_8_4_5, ark548b_8_4_5, verner_8_5_6, fehlberg_13_7_8,
};
Outcome<Solution> arkstep(const Rhs& f, std::vector<double> y0, double t0, double t1, double tolerance, ErkTable table = ErkTable::fehlberg_13_7_8);
/// The same with `steps` equal steps, for order tests.
Outcome<Solution> arkstep_fixed(const Rhs& f, std::vector<double> y0, double t0, double t1, long steps, ErkTable table);

/// The first time in (t0, t1] at which g(t, y) falls through 0, by CVODE's root finding, then polished: the root is
/// approached once more with the step ending on it, by the secant rule. Fault out_of_range when there is none.
struct Event {
  double t;
  std::vector<double> y;
};
Outcome<Event> first_fall(const Rhs& f, const std::function<double(double, std::span<const double>)>& g, std::vector<double> y0, double t0, double t1,
                          double tolerance);

/// Euler's equations in body axes with a quaternion, y = (ω_B, q): the free body for the solvers above.
Rhs free_body_rhs(const Vec3<double>& I_B);
Outcome<Attitude<double>> cvode_free_body(const FreeBody& body, double t, double tolerance, Cvode kind = Cvode::adams);
Outcome<Attitude<double>> arkstep_free_body(const FreeBody& body, double t, double tolerance, ErkTable table = ErkTable::fehlberg_13_7_8);

/// How the attitude at t turns with the spin at the start: δR_WB = [turn δw_B]ₓ R_WB, the turn in world axes, by CVODES. Units: s.
Outcome<Mat3<double>> cvodes_turn_by_spin(const FreeBody& body, double t, double tolerance);

}  // namespace rigor::reference
