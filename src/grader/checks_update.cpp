#include <cmath>
#include <rigor/formulas/angular_acceleration.hpp>
#include <rigor/formulas/rotation_rate.hpp>
#include <rigor/grader/check.hpp>
#include <rigor/grader/misconceptions.hpp>

namespace rigor::grader {
namespace {

// Any consistent one-step scheme is right ("e.g. symplectic Euler"): the checks look at the limit of small steps.
// Steps h, h/2, h/4 are combined with weights 1/3, −2, 8/3, which removes the errors of order h and h²; what is left
// is below 1e-5 in double and 7e-5 where a student computes in float.
constexpr double limit_bound = 1e-3;
constexpr double steps[3] = {1.0 / 256, 1.0 / 512, 1.0 / 1024};
constexpr double weights[3] = {1.0 / 3, -2, 8.0 / 3};

std::vector<Call> ask_limit(const Scenario& s) {
  std::vector<Call> calls;
  for (const double h : steps) {
    Scenario at = s;
    at.h = at.constants.delta_t = h;  // DELTA_T equals the argument
    Request q = request(Function::update, at);
    q.flags = want_helpers;
    calls.push_back({at.constants, q});
  }
  return calls;
}
template <class Value>
Value rate(const std::vector<Reply>& r, Value (*pick)(const BodyRecord&), const Value& before) {
  Value sum = before * 0;
  for (std::size_t k = 0; k < 3; ++k) sum += weights[k] / steps[k] * (pick(r[k].A) - before);
  return sum;
}
Vec3<double> velocity(const BodyRecord& b) { return vec(b.velocity); }
Vec3<double> position(const BodyRecord& b) { return vec(b.position); }
Vec3<double> spin(const BodyRecord& b) { return vec(b.spin); }
Mat3<double> rotation(const BodyRecord& b) { return mat(b.rotation); }

Box at_rest(Random& random, bool turned) {
  Box b = draw_box(random, turned);
  b.velocity = b.spin = zero3<double>();
  return b;
}
Box cube(Random& random) {
  Box b = draw_box(random, true);
  b.size = Vec3<double>::Constant(grid(random, 1.5, 2));
  b.mass = grid(random, 2.5, 4);  // inertia at least 0.9, away from 1
  return b;
}

Scenario draw_linear(Random& random, int) {
  Scenario s;
  s.A = draw_box(random, true);
  s.A.spin = zero3<double>();
  s.A.force = arrow(random, 4, 9);
  return s;
}
Judgement judge_linear(const Scenario& s, const std::vector<Reply>& r, bool) {
  const Vec3<double> a = s.A.force / s.A.mass;
  Judgement j;
  j.add("dv/dt", "m/s^2", rate(r, velocity, s.A.velocity), a, limit_bound * norm<double>(a));
  j.add("dx/dt", "m/s", rate(r, position, s.A.position), s.A.velocity, limit_bound * (norm<double>(s.A.velocity) + norm<double>(a) * steps[0]));
  return j;
}

Scenario draw_torque(Random& random, bool turned) {
  Scenario s;
  s.A = at_rest(random, turned);
  s.A.torque = arrow(random, 2, 6);
  return s;
}
Scenario draw_gyroscopic(Random& random, bool turned) {
  Scenario s;
  s.A = at_rest(random, turned);
  const Vec3<double> w_B = arrow(random, 0.75, 2);
  s.A.spin = apply<double>(s.A.R_WB(), w_B);
  return s;
}
Judgement judge_spin(const Scenario& s, const std::vector<Reply>& r, bool own) {
  const Mat3<double> I = own ? mat(r[0].A_helpers.world_inertia) : s.A.world_inertia();
  const Mat3<double> inverse = own ? mat(r[0].A_helpers.world_inverse_inertia) : s.A.world_inverse();
  const Vec3<double> right = angular_acceleration<double>(s.A.world_inertia(), s.A.world_inverse(), s.A.spin, s.A.torque);
  Vec3<double> want = angular_acceleration<double>(I, inverse, s.A.spin, s.A.torque);
  if (!(norm<double>(want) > 0.02 * norm<double>(right))) want = right;  // tensors of zero do not make an idle update right
  Judgement j;
  j.add("dw/dt", "rad/s^2", rate(r, spin, s.A.spin), want, limit_bound * norm<double>(want));
  return j;
}

Scenario draw_rotation(Random& random, int) {
  Scenario s;
  s.A = cube(random);
  s.A.spin = arrow(random, 0.75, 1.75);
  return s;
}
Judgement judge_rotation(const Scenario& s, const std::vector<Reply>& r, bool) {
  Judgement j;
  j.add("dR/dt", "1/s", rate(r, rotation, s.A.R_WB()), rotation_rate<double>(s.A.spin, s.A.R_WB()),
        limit_bound * norm<double>(s.A.spin));
  return j;
}
bool spin_off_the_axis(const Scenario& s) {  // else [w] R = R [w] and a wrong side is right
  const Vec3<double> axis(s.A.turn[1], s.A.turn[2], s.A.turn[3]);
  const double off = norm<double>(cross<double>(axis, s.A.spin)) / (norm<double>(axis) * norm<double>(s.A.spin));
  return off > 0.3 || !(norm<double>(axis) > 0);
}

Scenario draw_orthonormal(Random& random, int number) {
  Scenario s;
  s.A = cube(random);
  s.h = s.constants.delta_t = 1.0 / 256;
  const Vec3<double> w = arrow(random, 2, 4);
  s.A.spin = w * (5.12 / norm<double>(w));  // |w| dt = 0.02: a naive step is off by 4e-4 at once
  s.variant = number % 20 == 0 ? 1000 : 1;  // steps
  return s;
}
std::vector<Call> ask_orthonormal(const Scenario& s) {
  Request q = request(Function::update, s);
  q.count = std::uint32_t(s.variant);
  return {{s.constants, q, 2}};
}
Judgement judge_orthonormal(const Scenario& s, const std::vector<Reply>& r, bool) {
  const Mat3<double> R = mat(r[0].A.rotation), gram = R.transpose() * R;
  Judgement j;
  j.add_happened("to a body that moves and turns", (R - s.A.R_WB()).norm() > 1e-6 || norm<double>(Vec3<double>(vec(r[0].A.position) - s.A.position)) > 1e-6 ||
                                                       norm<double>(Vec3<double>(vec(r[0].A.spin) - s.A.spin)) > 1e-6);
  j.add("R^T R", "1", gram, identity3<double>(), 1e-5);
  j.add("det R", "1", dot<double>(cross<double>(R.col(0), R.col(1)), R.col(2)), 1, 1e-4);
  return j;
}

Scenario draw_clears(Random& random, int) {
  Scenario s;
  s.A = draw_box(random, true);
  s.A.force = arrow(random, 1, 9);
  s.A.torque = arrow(random, 1, 9);
  s.constants.delta_t = s.h;
  return s;
}
std::vector<Call> ask_once(const Scenario& s) { return {{s.constants, request(Function::update, s)}}; }
Judgement judge_clears(const Scenario& s, const std::vector<Reply>& r, bool) {
  Judgement j;
  j.add("net force afterwards", "N", vec(r[0].A.net_force), zero3<double>(), 1e-9 * norm<double>(s.A.force));
  j.add("net torque afterwards", "N m", vec(r[0].A.net_torque), zero3<double>(), 1e-9 * norm<double>(s.A.torque));
  return j;
}

// Which one-step scheme it is, for the report: the one legitimate reading that gives the same numbers. Nothing is said
// where velocity and spin are not those of one step: then position and rotation do not tell either.
Scenario draw_scheme(Random& random, int number) {
  Scenario s = draw_clears(random, number);
  s.A.spin = arrow(random, 0.75, 1.75);
  return s;
}
Judgement judge_scheme(const Scenario& s, const std::vector<Reply>& r, bool) {
  const BodyRecord got = r[0].A;
  const auto matches = [&](const std::string& ids, bool velocities) {
    const Call call = ask_once(s)[0];
    const BodyRecord model = model_answer(habits_with(ids), call.constants, call.request).A;
    const auto same = [](const double* a, const double* b, double scale) { return norm<double>(Vec3<double>(vec(a) - vec(b))) <= 1e-9 * scale; };
    return velocities ? same(got.velocity, model.velocity, norm<double>(s.A.velocity)) && same(got.spin, model.spin, norm<double>(s.A.spin))
                      : same(got.position, model.position, norm<double>(s.A.velocity)) && (mat(got.rotation) - mat(model.rotation)).norm() <= 1e-9;
  };
  Judgement j;
  if (!matches("", true)) return j;
  std::vector<std::string> seen;
  for (const std::string position : {"", "explicit-position", "midpoint-position"})
    for (const std::string spin : {"", "old-spin"})
      for (const std::string repair : {"", "rows", "polar", "exponential", "quaternion"}) {
        std::string ids;
        for (const std::string& part : {position, spin, repair}) ids += ids.empty() || part.empty() ? part : "+" + part;
        if (matches(ids, false)) seen.push_back(ids);
      }
  if (seen.empty()) j.note = "none of the known one-step schemes";
  // semi-implicit Euler with Gram-Schmidt is the one the sheet describes: nothing to remark
  if (seen.size() == 1 && !seen.front().empty()) j.note = "scheme: " + seen.front();
  return j;
}

// A cube under constant force and torque for 1 s, in 50, 100, 200 and 400 steps.
constexpr int ladder[4] = {50, 100, 200, 400};
Scenario draw_convergence(Random& random, int) {
  Scenario s;
  s.A = cube(random);
  s.A.spin = arrow(random, 0.5, 1);
  s.A.force = arrow(random, 1, 4);
  s.A.torque = arrow(random, 0.5, 1);
  return s;
}
std::vector<Call> ask_ladder(const Scenario& s) {
  std::vector<Call> calls;
  for (const int n : ladder) {
    Scenario at = s;
    at.h = at.constants.delta_t = 1.0 / n;
    Request q = request(Function::update, at);
    q.count = std::uint32_t(n);
    q.flags = hold_forces;
    calls.push_back({at.constants, q, 2});
  }
  return calls;
}
// R' = [w(t)] R with w linear in t (a cube has no gyroscopic torque): Magnus steps of order 4, 512 of them, error 1e-12.
Mat3<double> cube_attitude(const Box& b, double t) {
  const Vec3<double> alpha = apply<double>(b.world_inverse(), b.torque);
  const int n = 512;
  const double h = t / n;
  Mat3<double> R = b.R_WB();
  for (int k = 0; k < n; ++k) {
    const Vec3<double> w = b.spin + (k + 0.5) * h * alpha;  // mean of w over the step; [w1, w2] gives the h³ term
    const Vec3<double> theta = h * w - h * h * h / 12 * cross<double>(w, alpha);
    R = exp_so3<double>(theta) * R;
  }
  return R;
}
void add_order(Judgement& j, const std::string& name, const std::array<double, 4>& error) {
  // right: the finest pair shows order 0.9 or more, or the error is rounding already
  const bool tiny = error[3] <= 1e-6;
  const double order = tiny ? 1 : std::log2(error[2] / error[3]);
  j.add("order of convergence, " + name, "1", order, std::fmax(order, 0.9), std::isfinite(order) ? 1e-9 : 0);
  j.add("error at 400 steps, " + name, "of its scale", error[3], 0, 0.1);
}
std::array<double, 4> scales(const Scenario& s) {
  const double speed = norm<double>(s.A.velocity) + norm<double>(s.A.force) / s.A.mass;
  return {speed, speed, norm<double>(s.A.spin) + norm<double>(apply<double>(s.A.world_inverse(), s.A.torque)), 1};
}
bool converges(const std::array<double, 4>& error) { return error[3] <= 1e-6 || (std::log2(error[2] / error[3]) >= 0.9 && error[3] <= 0.1); }
double apart(int part, const BodyRecord& a, const BodyRecord& b) {
  switch (part) {
    case 0: return norm<double>(Vec3<double>(vec(a.position) - vec(b.position)));
    case 1: return norm<double>(Vec3<double>(vec(a.velocity) - vec(b.velocity)));
    case 2: return norm<double>(Vec3<double>(vec(a.spin) - vec(b.spin)));
    default: return (mat(a.rotation) - mat(b.rotation)).norm();
  }
}
// Differences to the finest in place of errors: of order h they fall 3 to 1 from 100 to 200 steps.
std::array<double, 4> differences(const Scenario& s, const std::vector<Reply>& r, int part) {
  const double scale = scales(s)[std::size_t(part)], at_100 = apart(part, r[1].A, r[3].A) / scale, at_200 = apart(part, r[2].A, r[3].A) / scale;
  return {apart(part, r[0].A, r[3].A) / scale, at_100, at_100 / 1.5, at_200 / 1.5};
}
constexpr const char* parts[4] = {"position", "velocity", "spin", "rotation"};

// `own`: with another inertia the limit of spin and rotation is another one; then the answers must converge among themselves.
Judgement judge_convergence(const Scenario& s, const std::vector<Reply>& r, bool own) {
  const Convergence c = convergence(s, r);
  Judgement j;
  for (int part = 0; part < 4; ++part) add_order(j, parts[part], own && part >= 2 ? differences(s, r, part) : c.error[std::size_t(part)]);
  return j;
}
// Where the law of velocity or spin in one step is another (half the acceleration), so is the limit, of the rotation too: what
// does not converge to the right one must do so among itself, by small differences (damping in every step has large ones)
// and away from where it began (a quantity that stays, or moves by dt squared, does not). With the right spin the
// rotation has no limit but the right one.
Judgement converges_to_its_own(const Scenario& s, const std::vector<Reply>& r, bool) {
  const Convergence c = convergence(s, r);
  Judgement j;
  for (int part = 0; part < 4; ++part) {
    if (converges(c.error[std::size_t(part)])) continue;
    const bool its_own = part != 3 || !converges(c.error[2]);
    const std::array<double, 4> between = differences(s, r, part);
    add_order(j, parts[part], its_own ? between : c.error[3]);
    j.add("difference of 200 and 400 steps, " + std::string(parts[part]), "of its scale", 1.5 * between[3], 0, 0.02);
    j.add_happened("to the " + std::string(parts[part]), apart(part, r[3].A, record(s.A)) > 0.01 * scales(s)[std::size_t(part)]);
  }
  return j;
}

}  // namespace

Convergence convergence(const Scenario& s, const std::vector<Reply>& r) {
  const Vec3<double> a = s.A.force / s.A.mass, alpha = apply<double>(s.A.world_inverse(), s.A.torque);
  const Vec3<double> x = s.A.position + s.A.velocity + a / 2, v = s.A.velocity + a, w = s.A.spin + alpha;
  const Mat3<double> R = cube_attitude(s.A, 1);
  const std::array<double, 4> scale = scales(s);
  Convergence c;
  for (std::size_t k = 0; k < 4; ++k) {
    const BodyRecord& got = r[k].A;
    c.h[k] = 1.0 / ladder[k];
    c.error[0][k] = norm<double>(Vec3<double>(vec(got.position) - x)) / scale[0];
    c.error[1][k] = norm<double>(Vec3<double>(vec(got.velocity) - v)) / scale[1];
    c.error[2][k] = norm<double>(Vec3<double>(vec(got.spin) - w)) / scale[2];
    c.error[3][k] = (mat(got.rotation) - R).norm();
  }
  return c;
}

std::vector<Check> update_checks() {
  const auto with = [](auto draw, bool turned) { return [draw, turned](Random& random, int) { return draw(random, turned); }; };
  const auto update = StudentFunction::update;
  std::vector<Check> list{
      {"update.linear", "Dynamics", update, "motion.linear", "dv/dt = F/m and dx/dt = v", 5,
       {"update.position-stays", "update.velocity-stays", "update.no-mass", "update.dt-missing-position",
        "update.dt-missing-velocity", "update.dt-squared-position", "update.half-step", "update.damps-velocity"},
       draw_linear, ask_limit, judge_linear},
      {"update.torque", "Dynamics", update, "motion.euler", "a torque at rest gives dw/dt = I^-1 torque (R = 1)", 3,
       {"update.spin-stays", "update.dt-missing-spin", "update.inertia-not-inverted", "update.no-inertia"},
       with(draw_torque, false), ask_limit, judge_spin, true},
      {"update.torque-turned", "Dynamics", update, "motion.euler", "the same with a generic rotation: the inverse tensor is in world axes", 4,
       {"update.spin-stays", "update.inverse-body", "update.inertia-not-inverted", "update.no-inertia"},
       with(draw_torque, true), ask_limit, judge_spin, true},
      {"update.gyroscopic", "Dynamics", update, "motion.euler", "without torque dw/dt = -I^-1 (w x I w) (R = 1)", 3,
       {"update.no-gyroscopic", "update.gyroscopic-sign", "update.damps-spin"},
       with(draw_gyroscopic, false), ask_limit, judge_spin, true},
      {"update.gyroscopic-turned", "Dynamics", update, "motion.euler", "the same with a generic rotation: w x I w with the world tensor", 3,
       {"update.no-gyroscopic", "update.gyroscopic-sign", "update.gyroscopic-body", "update.inverse-body"},
       with(draw_gyroscopic, true), ask_limit, judge_spin, true},
      {"update.rotation", "Dynamics", update, "rotation.rate", "dR/dt = [w] R, w in world axes", 4,
       {"update.rotation-stays", "update.dt-missing-rotation", "update.dt-squared-rotation", "update.rotation-right",
        "update.rotation-reversed", "update.half-rotation", "update.half-step", "update.degrees"},
       draw_rotation, ask_limit, judge_rotation},
      {"update.orthonormal", "Dynamics", update, "rotation.gram_schmidt", "R stays orthonormal with determinant 1, after one step and after 1000", 3,
       {"update.not-orthonormal"}, draw_orthonormal, ask_orthonormal, judge_orthonormal},
      {"update.clears", "Dynamics", update, "step.semi_implicit", "net force and net torque are zero afterwards", 2,
       {"update.keeps-force", "update.keeps-torque"}, draw_clears, ask_once, judge_clears},
      {"update.order", "Dynamics", update, "step.semi_implicit", "information: which one-step scheme it is", 0, {}, draw_scheme, ask_once, judge_scheme},
      {"update.convergence", "Dynamics", update, "step.semi_implicit", "halving the step halves the error of position, velocity, spin and rotation (or better)", 3,
       {}, draw_convergence, ask_ladder, judge_convergence, true},
  };
  list[5].sound = spin_off_the_axis;
  list.back().follows = {"update.linear", "update.torque", "update.torque-turned"};
  list.back().given = converges_to_its_own;
  return list;
}

}  // namespace rigor::grader
