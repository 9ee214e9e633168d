#include <cmath>
#include <reference/sundials.hpp>
#include <rigor/engine/exact_flight.hpp>
#include <rigor/engine/flow_methods.hpp>
#include <rigor/integrators/dormand_prince.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/studies/convergence.hpp>
#include <rigor/studies/flight.hpp>
#include <rigor/studies/peer.hpp>

namespace rigor::studies {
namespace {

using V = Vec3<double>;

struct Ended {
  State<double> state;
  double evaluations = 1;
};

// The centre of a flight without torque: the parabola.
State<double> fallen(const Problem& p, const Mat3<double>& R_WB, const V& w_B) {
  State<double> s;
  s.R_WB = R_WB;
  s.w_WB = apply<double>(R_WB, w_B);
  s.v_WB = p.start.v_WB + p.until * *p.falls;
  s.p_WB = p.start.p_WB + p.until * p.start.v_WB + p.until * p.until / 2 * *p.falls;
  return s;
}
Ended exact(const Problem& p, ExactFlight::Precision precision) {
  const V w_B = apply_transposed<double>(p.start.R_WB, p.start.w_WB);
  const Attitude a = ExactFlight::make(p.body.inertia(), w_B, p.start.R_WB, precision)->at(p.until);
  return {fallen(p, a.R_WB, V(a.L_B.cwiseProduct(p.body.inverse_inertia())))};
}
Outcome<Ended> sundials(const Problem& p, const std::string& name, double tolerance) {
  const V w_B = apply_transposed<double>(p.start.R_WB, p.start.w_WB);
  const reference::Rhs rhs = reference::free_body_rhs(p.body.inertia());
  const std::vector<double> y0{w_B[0], w_B[1], w_B[2], 1, 0, 0, 0};  // the attitude relative to the start
  const auto solved = name == "arkode-fehlberg8" ? reference::arkstep(rhs, y0, 0, p.until, tolerance)
                                                 : reference::cvode(rhs, y0, 0, p.until, tolerance, name == "cvode-bdf" ? reference::Cvode::bdf : reference::Cvode::adams);
  if (!solved) return solved.fault();
  const std::vector<double>& y = solved->y;
  return Ended{fallen(p, p.start.R_WB * rotation_of<double>(Vec4<double>(y[3], y[4], y[5], y[6])), V(y[0], y[1], y[2])), double(solved->evaluations)};
}
Outcome<Ended> dormand_prince(const Problem& p, double tolerance) {
  const auto flown = fly_dormand_prince(p.body, p.start, [&](double t, const State<double>& s) { return p.load_at(t, s); }, 0, p.until, tolerance);
  if (!flown) return flown.fault();
  return Ended{flown->end, double(flown->evaluations)};
}

void put_errors(Row& row, const Problem& problem, const Ended& end) {
  const Errors e = errors_of(problem, end.state);
  const bool finite = std::isfinite(e.attitude) && std::isfinite(e.position) && std::isfinite(e.momentum) && !left_the_numbers(e.energy);
  if (!finite) row.failed = "left the numbers";
  row.put("attitude", finite ? e.attitude : std::nan(""));
  row.put("momentum", finite ? e.momentum : std::nan(""));
  row.put("energy", finite ? e.energy : std::nan(""));
  row.put("position", finite ? e.position : std::nan(""));
  row.put("probe", finite ? end.state.R_WB(0, 1) : std::nan(""));
  row.put("evaluations", end.evaluations);
}
void put_times(Row& row, const Timing& t) {
  row.put("cpu_min", t.cpu_min);
  row.put("cpu_median", t.cpu_median);
  row.put("wall_min", t.wall_min);
  row.put("wall_median", t.wall_median);
}
Row& fail(Row& row, const std::string& why) {
  row.failed = why;
  for (const char* name : {"attitude", "momentum", "energy", "position", "probe", "evaluations"}) row.put(name, std::nan(""));
  if (row.cell.timed()) put_times(row, {std::nan(""), std::nan(""), std::nan(""), std::nan("")});
  return row;
}

}  // namespace

const std::vector<OtherWay>& other_ways() {
  static const std::vector<OtherWay> all{{"exact", "ExactFlight, extended constants: set-up and one evaluation", false},
                                         {"exact-plain", "ExactFlight, constants in double: set-up and one evaluation", false},
                                         {"dormand-prince-adaptive", "Dormand and Prince 5(4) with error control", true},
                                         {"cvode-adams", "SUNDIALS CVODE, Adams, rtol = atol", true},
                                         {"cvode-bdf", "SUNDIALS CVODE, BDF, rtol = atol", true},
                                         {"arkode-fehlberg8", "SUNDIALS ARKStep, Fehlberg 7(8), rtol = atol", true}};
  return all;
}
const OtherWay* find_other_way(const std::string& name) {
  for (const OtherWay& way : other_ways())
    if (way.name == name) return &way;
  return nullptr;
}

const Method* find_stepper(const std::string& name) {
  for (const Method& method : flow_methods())
    if (method.name == name) return &method;
  return find_method(name);
}

Row fly(const Cell& cell, Student* student) {
  Row row{cell, {}, "", ""};
  const Problem& problem = **open_problem(cell.problem, cell.until);
  if (student != nullptr) {
    const auto flown = student->fly(problem, cell.steps, cell.timed() ? 7 : 1);
    if (!flown) return fail(row, flown.fault().text());
    put_errors(row, problem, {flown->end, double(cell.steps)});
    if (cell.timed()) put_times(row, flown->timing);
    return row;
  }
  if (cell.method.find('/') != std::string::npos) {
    const auto run = run_peer(cell.method, problem, cell.steps, cell.tolerance);
    if (!run) return fail(row, run.fault().text());
    put_errors(row, problem, {run->end, run->evaluations});
    if (cell.timed()) put_times(row, run->timing);
    row.note = run->settings;
    return row;
  }
  const OtherWay* way = cell.steps > 0 ? nullptr : find_other_way(cell.method);
  const bool controlled = way != nullptr && way->name == "dormand-prince-adaptive";
  if (way != nullptr && !controlled && !problem.falls) return fail(row, "knows no torque");
  const Method* method = find_stepper(cell.method);
  const auto once = [&]() -> Outcome<Ended> {
    if (way == nullptr) return Ended{integrate(problem, *method, cell.steps), double(cell.steps) * method->evaluations};
    if (controlled) return dormand_prince(problem, cell.tolerance);
    if (way->adaptive) return sundials(problem, way->name, cell.tolerance);
    return exact(problem, way->name == "exact" ? ExactFlight::Precision::extended : ExactFlight::Precision::plain);
  };
  const auto end = once();
  if (!end) return fail(row, end.fault().text());
  put_errors(row, problem, *end);
  if (cell.timed()) {
    volatile double sink = 0;  // the runs must not be left out
    put_times(row, time_of([&] { sink = sink + once()->state.R_WB(0, 0); }));
  }
  return row;
}

}  // namespace rigor::studies
