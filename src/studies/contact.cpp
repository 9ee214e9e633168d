#include <cmath>
#include <numbers>
#include <rigor/base/promise.hpp>
#include <rigor/engine/located.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/studies/contact.hpp>

namespace rigor::studies {
namespace {

using V = Vec3<double>;
constexpr double g = 9.81;

// A scene, and the number that is read off its motion while it is seen state by state.
struct Reading {
  Scene scene;
  std::function<bool(double t, const State<double>&)> see;   ///< false: seen enough
  std::function<void(const LocatedImpact&)> impact = [](const LocatedImpact&) {};
  std::function<double()> error;                             ///< when all has been seen
};

Scene on_a_floor(const V& size, const State<double>& start, double e, double mu, double until, const V& gravity = {0, -g, 0}) {
  Scene s;
  s.name = "contact";
  s.bodies = {{*Cuboid<double>::make(2, size), start}};
  s.planes = {*Plane<double>::make(V(0, 0, 0), V(0, 1, 0))};
  s.gravity = gravity;
  s.surface = *Surface<double>::make(e, mu, mu);
  s.friction_law = FrictionLaw::coulomb;
  s.until = until;
  return s;
}
State<double> at_height(double y, const V& v = zero3<double>(), const V& w = zero3<double>()) {
  State<double> s;
  s.p_WB = V(0, y, 0);
  s.v_WB = v;
  s.w_WB = w;
  return s;
}

// A drop from H = 1 m. Height of the closed form at t: free falls of speed u e^n between t1 (1 + 2e + 2e² + ...).
double bounced_height(double t, double e) {
  const double t1 = std::sqrt(2 / g);
  if (t <= t1) return 1 - g * t * t / 2;
  double rest = t - t1, speed = g * t1;
  for (;;) {
    speed *= e;
    const double flight = 2 * speed / g;
    if (flight < 1e-12) return 0;
    if (rest <= flight) return speed * rest - g * rest * rest / 2;
    rest -= flight;
  }
}
// A cube of 0.5 m with a corner straight below its centre: one contact, and an impulse that passes through the centre.
State<double> on_its_corner(double height) {
  const double diagonal = 0.25 * std::sqrt(3.0);
  State<double> s = at_height(diagonal + height);
  // the turn that takes (1, 1, 1)/sqrt 3 to (0, 1, 0): q = (1 + c, (1, 1, 1)/sqrt 3 x (0, 1, 0)) with c the cosine between them
  const double c = 1 / std::sqrt(3.0);
  s.R_WB = rotation_of<double>(Vec4<double>(1 + c, -c, 0, c));
  return s;
}
Reading bounce(double until, double e) {
  auto last = std::make_shared<double>();
  const State<double> start = on_its_corner(1);
  return {on_a_floor({0.5, 0.5, 0.5}, start, e, 0, until),
          [=](double, const State<double>& s) { return *last = s.p_WB[1] - (start.p_WB[1] - 1), true; },
          [](const LocatedImpact&) {},
          [=] { return std::fabs(*last - bounced_height(until, e)); }};
}
// The first apex after the impact, over the height of the drop.
Reading apex(double e, const V& size, const State<double>& start) {
  struct Seen {
    double height = 0;
    bool up = false;
  };
  auto seen = std::make_shared<Seen>();
  const auto energy_height = [rest = start.p_WB[1] - 1](const State<double>& s) { return s.p_WB[1] - rest + s.v_WB[1] * s.v_WB[1] / (2 * g); };
  const double t1 = std::sqrt(2 / g);
  return {on_a_floor(size, start, e, 0, t1 * (1 + std::fmax(e, 0.01) * 0.9)),
          [=](double, const State<double>& s) {
            if (!seen->up && s.v_WB[1] > 0) seen->height = energy_height(s), seen->up = true;
            return !seen->up;
          },
          [=](const LocatedImpact& i) {
            if (!seen->up) seen->height = energy_height(i.after), seen->up = true;
          },
          [=] { return std::fabs(seen->height - e * e); }};
}
// A slab spinning about a horizontal axis as it falls: when does its first corner touch?
Reading first_touch() {
  auto touched = std::make_shared<double>(std::nan(""));
  constexpr double root = 0.550155514682812044601547416719;  // of 2 - g t²/2 = 0.5 |sin 7t| + 0.25 |cos 7t|, case P-07
  return {on_a_floor({1, 0.5, 1}, at_height(2, zero3<double>(), V(0, 0, 7)), 0.5, 0, 0.6),
          [=, spin = 7.0](double t, const State<double>& s) {
            if (std::isnan(*touched) && std::fabs(s.w_WB[2] - spin) > 1e-3) *touched = t;
            return std::isnan(*touched);
          },
          [=](const LocatedImpact& i) {
            if (std::isnan(*touched)) *touched = i.t;
          },
          [=] { return std::fabs(*touched - root); }};
}
// A sliding stop: 3 m/s along an azimuth, v²/2μg.
Reading stop(double degrees) {
  const double mu = 0.3, v = 3, a = degrees * std::numbers::pi / 180, far = v * v / (2 * mu * g);
  auto last = std::make_shared<V>();
  const V way = far * V(std::cos(a), 0, std::sin(a));
  return {on_a_floor({1, 0.5, 0.75}, at_height(0.25, V(v * std::cos(a), 0, v * std::sin(a))), 0, mu, 1.5),
          [=](double, const State<double>& s) { return *last = s.p_WB, true; },
          [](const LocatedImpact&) {},
          [=] { return norm<double>(V((*last)[0] - way[0], 0, (*last)[2] - way[2])); }};
}
// A floor tilted by 30° (gravity turned instead), mu 0.4: s = g (sin - mu cos) t²/2.
Reading incline() {
  const double th = std::numbers::pi / 6, mu = 0.4, t = 1, a = g * (std::sin(th) - mu * std::cos(th));
  auto last = std::make_shared<double>();
  return {on_a_floor({1, 0.25, 0.75}, at_height(0.125), 0, mu, t, V(g * std::sin(th), -g * std::cos(th), 0)),
          [=](double, const State<double>& s) { return *last = s.p_WB[0], true; },
          [](const LocatedImpact&) {},
          [=] { return std::fabs(*last - a * t * t / 2); }};
}

struct ContactRecipe {
  ContactProblem problem;
  Reading (*make)(double x);
};
const std::vector<ContactRecipe>& contact_recipes() {
  static const std::vector<double> eighths{0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1};
  static const std::vector<ContactRecipe> all{
      {{"p-01-one", "case P-01 through one impact: a cube falls 1 m onto its corner, the centre straight above, g = 9.81, e = 0.8; height at t = 0.8 s", "free fall, the speed times e at t1 = sqrt(2H/g)", "m", "restitution", {0.8}},
       [](double e) { return bounce(0.8, e); }},
      {{"p-01-many", "case P-01 through nine impacts: the same at t = 3.5 s", "free falls with speeds u e^n between t1 (1 + 2e + 2e^2 + ...)", "m", "restitution", {0.8}},
       [](double e) { return bounce(3.5, e); }},
      {{"p-04", "case P-04: first apex over the height of the drop of the same cube, for e in eighths", "e^2; error is the difference", "of the drop", "restitution", eighths}, [](double e) { return apex(e, {0.5, 0.5, 0.5}, on_its_corner(1)); }},
      {{"p-11", "case P-11: the same of a slab that lands flat, on four corners at once", "e^2; error is the difference. The stepper takes the corners one after the other: the slab starts to turn, and no step makes that right", "of the drop",
        "restitution", eighths},
       [](double e) { return apex(e, {0.5, 0.25, 1}, at_height(1.125)); }},
      {{"p-07", "case P-07: a slab 1 x 0.5 m, spinning at 7 rad/s about a horizontal axis, centre at 2 m: when does it touch the floor?",
        "0.550155514682812044601547416719 s, root of 2 - g t^2/2 = |sin 7t|/2 + |cos 7t|/4", "s", "", {0}},
       [](double) { return first_touch(); }},
      {{"fr-02", "case FR-02: a block slides down 30 degrees with mu = 0.4, from rest, 1 s", "g (sin - mu cos) t^2/2", "m", "", {0}}, [](double) { return incline(); }},
      {{"fr-04", "case FR-04: a block at 3 m/s on a level floor, mu = 0.3: where does it stop?", "v^2/(2 mu g) along the way it went, 16 azimuths", "m", "azimuth, degrees",
        {0, 22.5, 45, 67.5, 90, 112.5, 135, 157.5, 180, 202.5, 225, 247.5, 270, 292.5, 315, 337.5}},
       stop},
  };
  return all;
}

}  // namespace

const std::vector<ContactProblem>& contact_problems() {
  static const std::vector<ContactProblem> all = [] {
    std::vector<ContactProblem> problems;
    for (const ContactRecipe& r : contact_recipes()) problems.push_back(r.problem);
    return problems;
  }();
  return all;
}

Row contact(const Cell& cell, Student* student) {
  Row row{cell, {}, "", ""};
  const ContactRecipe* recipe = nullptr;
  for (const ContactRecipe& r : contact_recipes())
    if (r.problem.name == cell.problem) recipe = &r;
  promise(recipe != nullptr, "a contact cell names a problem of contact_problems()");
  Reading reading = recipe->make(cell.x);
  Scene& scene = reading.scene;
  const auto put = [&](double error, const RunSummary* ran) {  // of who only tells where it went there is no ledger
    const double none = std::nan("");
    row.put("error", error);
    row.put("own_J", ran != nullptr ? ran->ledger.energy.worst_stepper : none);
    row.put("restitution_J", ran != nullptr ? ran->ledger.energy.restitution_loss : none);
    row.put("friction_J", ran != nullptr ? ran->ledger.energy.friction_loss : none);
    row.put("impacts", ran != nullptr ? double(ran->ledger.impacts) : none);
    return row;
  };
  if (student != nullptr) {
    const double h = 1.0 / double(cell.steps);
    // the last step of the student's is not shortened: it goes on to the step nearest the end
    const auto done = student->bounce(scene.bodies[0].shape, scene.bodies[0].start, scene.planes[0], scene.surface, scene.gravity, h, std::lround(scene.until / h), reading.see);
    if (!done) row.failed = done.fault().text();
    return put(done ? reading.error() : std::nan(""), nullptr);
  }
  bool enough = false;
  const Observer see = [&](double t, const std::vector<State<double>>& states) { enough = enough || !reading.see(t, states[0]); };
  RunSummary summary;
  if (cell.method == "located") {
    scene.method = "located";
    scene.every = scene.until;
    const auto done = simulate_located(scene, [&](double t, const std::vector<State<double>>& states) {
      if (t > 0) see(t, states);
    }, reading.impact);
    if (!done) {
      row.failed = done.fault().text();
      return put(std::nan(""), nullptr);
    }
    summary = *done;
  } else {
    scene.method = cell.method;
    scene.dt = 1.0 / double(cell.steps);
    summary = simulate(scene, see);
  }
  if (!summary.finite) row.failed = "left the numbers";
  return put(summary.finite ? reading.error() : std::nan(""), &summary);
}

}  // namespace rigor::studies
