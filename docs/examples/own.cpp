// A worked example: src/grader/own.cpp with a misconception and a check that the grader does not have. A course adds
// gravity by applyForce; some students write it into update() as well.
#include <rigor/grader/check.hpp>
#include <rigor/grader/misconceptions.hpp>

namespace rigor::grader {

std::vector<Misconception> own_misconceptions() {
  return {{"update.gravity-built-in", StudentFunction::update, "step.semi_implicit", "update() adds gravity, which comes by applyForce already",
           [](Habits& h) {
             // what this student's answer has that a right one has not, after `count` steps of h
             h.besides = [](const Constants&, const Request& q, Reply& r) {
               if (Function(q.function) != Function::update) return;
               const double n = q.count;
               r.A.velocity[1] -= 9.8 * q.h * n;
               r.A.position[1] -= 9.8 * q.h * q.h * n * (n + 1) / 2;
             };
           }}};
}

namespace {

Scenario draw(Random& random, int) {
  Scenario s;
  s.A = draw_box(random, true);  // three edges, turned, moving and spinning
  s.constants.delta_t = s.h;
  return s;
}
std::vector<Call> ask(const Scenario& s) { return {{s.constants, request(Function::update, s)}}; }
// Bounds leave room for a student who computes in float (6e-8 of the numbers themselves).
Judgement judge(const Scenario& s, const std::vector<Reply>& r, bool) {
  Judgement j;
  j.add("velocity", "m/s", vec(r[0].A.velocity), s.A.velocity, 1e-5 * s.A.velocity.norm());
  j.add("displacement", "m", Vec3<double>(vec(r[0].A.position) - s.A.position), Vec3<double>(s.h * s.A.velocity), 1e-6 * s.A.position.norm());
  return j;
}

}  // namespace

std::vector<Check> own_checks() {
  return {{"update.free-flight", "Dynamics", StudentFunction::update, "step.semi_implicit", "without a force a body flies straight on at its speed", 2,
           {"update.gravity-built-in", "update.position-stays"}, draw, ask, judge}};
}

}  // namespace rigor::grader
