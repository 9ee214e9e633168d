#include <cmath>
#include <numbers>
#include <rigor/base/promise.hpp>
#include <rigor/engine/exact_flight.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/scene/simulate.hpp>
#include <rigor/studies/drift.hpp>

namespace rigor::studies {
namespace {

using V = Vec3<double>;

Problem flight_of(const Cell& cell) {
  const bool spin = cell.problem == "spin";
  Problem p{cell.problem, "", "", *Cuboid<double>::make(1, spin ? V(1, 2, 3) : V(1, 1.5, cell.y)), {}, nullptr, 0, {}};
  const double tilt = (spin ? cell.y : 10) * std::numbers::pi / 180;
  // the middle moment belongs to the middle edge: the second, or the first where the third is shorter than 1
  V w = V(std::sin(tilt), std::cos(tilt), std::sin(tilt) / 2);
  if (!spin && cell.y < 1) w = V(w[1], w[0], w[2]);
  p.start.w_WB = w / norm<double>(w);
  return p;
}
Verdict of_flight(const Cell& cell) {
  const Problem p = flight_of(cell);
  const Method& method = *find_method(cell.method);
  const Drift d = drift_of(p, method, cell.x, cell.steps);  // |ω| = 1
  if (!d.finite || d.energy > 0.1) return Verdict::unstable;
  const long turn = std::max(1L, std::lround(2 * std::numbers::pi / cell.x));
  Motion m = motion_of(p.body, p.start);
  for (long k = 0; k < turn; ++k) m = method.step(p.body, m, {}, cell.x);
  const Attitude a = ExactFlight::make(p.body.inertia(), p.start.w_WB, identity3<double>())->at(double(turn) * cell.x);
  return angle_between<double>(m.state.R_WB, a.R_WB) > 0.1 ? Verdict::inaccurate : Verdict::stable;
}
Verdict of_stack(const Cell& cell) {
  Scene s;
  State<double> start;
  for (int k = 0; k < 2; ++k) {
    start.p_WB = V(0.01 * k, 0.5 + k, 0.02 * k);
    s.bodies.push_back({*Cuboid<double>::make(k == 0 ? 1 : cell.y, V(1, 1, 1)), start});
  }
  s.planes = {*Plane<double>::make(V(0, 0, 0), V(0, 1, 0))};
  s.surface = *Surface<double>::make(0.2, 0.5, 0.4);
  s.method = cell.method;
  s.dt = cell.x;
  s.until = 4;
  double lowest = 0, highest = 0;
  const RunSummary run = simulate(s, [&](double, const std::vector<State<double>>& states) {
    for (const State<double>& b : states) {
      lowest = std::fmin(lowest, b.p_WB[1]);
      highest = std::fmax(highest, norm<double>(b.p_WB));
    }
  });
  if (!run.finite || lowest < 0 || highest > 3) return Verdict::unstable;
  return run.ledger.deepest_penetration > 0.01 ? Verdict::inaccurate : Verdict::stable;
}

}  // namespace

const std::vector<Map>& maps() {
  const std::vector<double> angles{0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 0.7, 1.5, 3, 6};
  static const std::vector<Map> all{
      {"spin", "step against the tilt of the spin from the middle axis of a cuboid 1 x 2 x 3 m", "|w| h, rad", "tilt, degrees", angles, {0.1, 1, 10, 30, 60, 85}},
      {"aspect", "step against the aspect ratio of a cuboid 1 x 1.5 x a m that tumbles 10 degrees off its middle axis", "|w| h, rad", "a", angles, {0.01, 0.1, 0.5, 2, 10, 100}},
      {"mass", "step against the mass ratio of two cubes of 1 m, the upper one over the lower, stacked on a floor for 4 s", "step, s", "mass ratio", {1. / 960, 1. / 480, 1. / 240, 1. / 120, 1. / 60, 1. / 30},
       {0.01, 0.1, 1, 10, 100, 1000}}};
  return all;
}

const Map* find_map(const std::string& name) {
  for (const Map& map : maps())
    if (map.name == name) return &map;
  return nullptr;
}

Row stability(const Cell& cell) {
  Row row{cell, {}, "", ""};
  if (find_map(cell.problem) != nullptr) row.put("verdict", double(cell.problem == "mass" ? of_stack(cell) : of_flight(cell)));
  else row.put("angle", stable_angle(**open_problem(cell.problem), *find_method(cell.method)));
  return row;
}

}  // namespace rigor::studies
