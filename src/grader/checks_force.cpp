#include <rigor/formulas/force_sum.hpp>
#include <rigor/grader/check.hpp>

namespace rigor::grader {
namespace {

constexpr double tight = 1e-5;

Scenario draw(Random& random, int) {
  Scenario s;
  s.A = draw_box(random, true);
  s.A.force = arrow(random, 2, 9);  // already there: the new force must be added
  s.A.torque = arrow(random, 2, 9);
  s.vector = arrow(random, 2, 9);
  s.point = s.A.position + arrow(random, 0.25, 1);
  return s;
}
Scenario draw_at_centre(Random& random, int number) {
  Scenario s = draw(random, number);
  s.point = s.A.position;
  return s;
}
std::vector<Call> ask(const Scenario& s) { return {{s.constants, request(Function::apply_force, s)}}; }

Wrench<double> want(const Scenario& s) {
  return add_force<double>({s.A.force, s.A.torque}, Vec3<double>(s.point - s.A.position), s.vector);
}
double force_scale(const Scenario& s) { return norm<double>(s.A.force) + norm<double>(s.vector); }
double torque_scale(const Scenario& s) { return norm<double>(s.A.torque) + s.A.reach() * norm<double>(s.vector); }

Judgement judge_force(const Scenario& s, const std::vector<Reply>& r, bool) {
  Judgement j;
  j.add("net force", "N", vec(r[0].A.net_force), want(s).f_W, tight * force_scale(s));
  return j;
}
Judgement judge_torque(const Scenario& s, const std::vector<Reply>& r, bool) {
  Judgement j;
  j.add("net torque", "N m", vec(r[0].A.net_torque), want(s).tau_W, tight * torque_scale(s));
  return j;
}
// At the centre, and once off it: there something must happen.
std::vector<Call> ask_pure(const Scenario& s) {
  Scenario off = s;
  off.point = s.A.position + Vec3<double>(0.5, 0.25, 0.75);
  return {ask(s)[0], ask(off)[0]};
}
// An added torque of zero: whatever a student does with the torque that was there is force.torque's business.
Judgement judge_pure(const Scenario& s, const std::vector<Reply>& r, bool) {
  Judgement j;
  const Vec3<double> torque = vec(r[0].A.net_torque);
  const bool overwritten = norm<double>(torque) <= tight * torque_scale(s);
  j.add("net torque", "N m", torque, overwritten ? zero3<double>() : s.A.torque, tight * torque_scale(s));
  j.add("velocity", "m/s", vec(r[0].A.velocity), s.A.velocity, tight * norm<double>(s.A.velocity));
  j.add_happened("for a force off the centre", norm<double>(Vec3<double>(vec(r[1].A.net_force) - s.A.force)) > tight * force_scale(s) ||
                                                   norm<double>(Vec3<double>(vec(r[1].A.net_torque) - s.A.torque)) > tight * torque_scale(s));
  return j;
}

}  // namespace

std::vector<Check> force_checks() {
  std::vector<Check> list{
      {"force.sum", "Force", StudentFunction::apply_force, "force.sum", "the force is added to the net force", 4,
       {"force.overwritten", "force.no-force", "force.over-mass", "force.reversed"}, draw, ask, judge_force},
      {"force.torque", "Force", StudentFunction::apply_force, "force.torque",
       "r x F is added to the net torque, r from the centre of mass in world axes", 4,
       {"force.torque-reversed", "force.arm-from-origin", "force.arm-in-body", "force.arm-plus-centre", "force.torque-overwritten",
        "force.no-torque"},
       draw, ask, judge_torque},
      {"force.pure", "Force", StudentFunction::apply_force, "force.torque", "a force at the centre of mass gives no torque", 2,
       {"force.arm-from-origin", "force.arm-plus-centre"}, draw_at_centre, ask_pure, judge_pure},
  };
  list[2].renew = [](Scenario& s) { s.point = s.A.position; };
  return list;
}

}  // namespace rigor::grader
