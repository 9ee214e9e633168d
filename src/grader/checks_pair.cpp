#include <cmath>
#include <cstdio>
#include <rigor/formulas/momentum.hpp>
#include <rigor/grader/check.hpp>
#include <rigor/grader/contacts.hpp>

namespace rigor::grader {
namespace {

constexpr double tight = 1e-5;
constexpr double restitutions[4] = {0.5, 0.75, 0.25, 0.875};

// Two generic bodies, a contact off both centres, approaching there.
Scenario draw(Random& random, int number, bool turned) {
  Scenario s;
  s.A = draw_box(random, turned);
  s.B = draw_box(random, turned);
  s.normal = s.vector = draw_direction(random);  // the request's `vector` is the normal
  s.point = s.A.position + arrow(random, 0.25, 0.75);
  s.B.position = s.point + arrow(random, 0.25, 0.75);
  s.constants = {restitutions[number % 4], 0, 0, 1.0 / 240};
  const Vec3<double> v_A = point_velocity<double>(s.A.velocity, s.A.spin, Vec3<double>(s.point - s.A.position));
  const Vec3<double> v_B = point_velocity<double>(s.B.velocity, s.B.spin, Vec3<double>(s.point - s.B.position));
  const double wanted = -grid(random, 0.75, 2), has = dot<double>(Vec3<double>(v_B - v_A), s.normal);
  s.B.velocity += (wanted - has) * s.normal;
  return s;
}
// With e = 0, where a wrong sign in front of e cannot be seen: that is pair.restitution's business.
Scenario draw_plastic(Random& random, int number, bool turned) {
  Scenario s = draw(random, number, turned);
  s.constants.restitution = 0;
  return s;
}
std::vector<Call> ask(const Scenario& s) {
  Scenario at = s;
  at.vector = s.normal;
  Request q = request(Function::pair_response, at);
  q.flags = want_helpers;
  return {{s.constants, q}};
}

// The same with every velocity reversed as well: who takes an approach for a parting does something there.
std::vector<Call> ask_either_way(const Scenario& s) {
  Scenario parting = s;
  for (Box* b : {&parting.A, &parting.B}) b->velocity = -b->velocity, b->spin = -b->spin;
  return {ask(s)[0], ask(parting)[0]};
}

struct Meeting {
  ImpactBody<double> A, B;
  PairVelocity<double> before;
};
Meeting meeting(const Scenario& s, const Reply* own = nullptr) {
  return {impact_body(s.A, Vec3<double>(s.point - s.A.position), own ? own->A_helpers.world_inverse_inertia : nullptr),
          impact_body(s.B, Vec3<double>(s.point - s.B.position), own ? own->B_helpers.world_inverse_inertia : nullptr),
          {{s.A.velocity, s.A.spin}, {s.B.velocity, s.B.spin}}};
}
PairVelocity<double> after(const Reply& r) { return {{vec(r.A.velocity), vec(r.A.spin)}, {vec(r.B.velocity), vec(r.B.spin)}}; }
double normal_speed(const Meeting& m, const PairVelocity<double>& u, const Vec3<double>& n) {
  return dot<double>(relative_velocity<double>(m.A, m.B, u), n);
}
double speed_scale(const Scenario& s) {
  double sum = 0;
  for (const Box* b : {&s.A, &s.B}) sum += norm<double>(b->velocity) + norm<double>(b->spin) * b->reach();
  return sum;
}
double spin_scale(const Box& b, const Scenario& s) {
  return norm<double>(b.spin) + b.inverse_I_B().maxCoeff() * b.reach() * std::fmin(s.A.mass, s.B.mass) * speed_scale(s);
}
// A law that holds when nothing happens must not pass a function that does nothing: of a meeting and the same with every
// velocity reversed, one at least must show an impulse.
void add_something_happened(Judgement& j, const Scenario& s, const std::vector<Reply>& r) {
  const Meeting m = meeting(s);
  const double before = normal_speed(m, m.before, s.normal);
  j.add_happened("to the normal speed", std::fabs(normal_speed(m, after(r[0]), s.normal) - before) > 1e-3 * speed_scale(s) ||
                                            std::fabs(normal_speed(m, after(r[1]), s.normal) + before) > 1e-3 * speed_scale(s));
}

Judgement judge_restitution(const Scenario& s, const std::vector<Reply>& r, bool) {
  const Meeting m = meeting(s);
  Judgement j;
  j.add("normal relative speed afterwards", "m/s", normal_speed(m, after(r[0]), s.normal),
        -s.constants.restitution * normal_speed(m, m.before, s.normal), tight * speed_scale(s));
  return j;
}
Judgement judge_impulse(const Scenario& s, const std::vector<Reply>& r, bool own) {
  const Meeting m = meeting(s, own ? &r[0] : nullptr);
  const double j_n = normal_impulse<double>(s.constants.restitution, normal_speed(m, m.before, s.normal),
                                            normal_inverse_mass<double>(m.A, m.B, s.normal));
  const PairVelocity<double> want = apply_pair_impulse<double>(m.A, m.B, m.before, Vec3<double>(j_n * s.normal));
  const PairVelocity<double> got = after(r[0]);
  Judgement j;
  j.add("velocity of body 1 afterwards", "m/s", got.A.v_WB, want.A.v_WB, tight * speed_scale(s));
  j.add("spin of body 1 afterwards", "rad/s", got.A.w_WB, want.A.w_WB, tight * spin_scale(s.A, s));
  j.add("velocity of body 2 afterwards", "m/s", got.B.v_WB, want.B.v_WB, tight * speed_scale(s));
  j.add("spin of body 2 afterwards", "rad/s", got.B.w_WB, want.B.w_WB, tight * spin_scale(s.B, s));
  return j;
}
Vec3<double> linear(const Scenario& s, const PairVelocity<double>& u) {
  return linear_momentum<double>(s.A.mass, u.A.v_WB) + linear_momentum<double>(s.B.mass, u.B.v_WB);
}
Vec3<double> angular(const Scenario& s, const PairVelocity<double>& u, const Reply* own) {  // about the world's origin
  const Mat3<double> I_A = own ? inverse3(mat(own->A_helpers.world_inverse_inertia)) : s.A.world_inertia();
  const Mat3<double> I_B = own ? inverse3(mat(own->B_helpers.world_inverse_inertia)) : s.B.world_inertia();
  return angular_momentum<double>(s.A.mass, I_A, s.A.position, u.A.v_WB, u.A.w_WB, zero3<double>()) +
         angular_momentum<double>(s.B.mass, I_B, s.B.position, u.B.v_WB, u.B.w_WB, zero3<double>());
}
Judgement judge_linear(const Scenario& s, const std::vector<Reply>& r, bool) {
  Judgement j;
  j.add("total linear momentum", "N s", linear(s, after(r[0])), linear(s, meeting(s).before), tight * (s.A.mass + s.B.mass) * speed_scale(s));
  add_something_happened(j, s, r);
  return j;
}
Judgement judge_angular(const Scenario& s, const std::vector<Reply>& r, bool own) {
  const Reply* helpers = own ? &r[0] : nullptr;
  const double scale = (s.A.mass * (s.A.reach() + norm<double>(s.A.position)) + s.B.mass * (s.B.reach() + norm<double>(s.B.position))) * speed_scale(s);
  Judgement j;
  j.add("total angular momentum about the origin", "kg m^2/s", angular(s, after(r[0]), helpers),
        angular(s, meeting(s).before, helpers), tight * scale);
  add_something_happened(j, s, r);
  return j;
}

Scenario draw_leaving(Random& random, int number) {
  Scenario s = draw(random, number, true);
  s.B.velocity += (0.5 - normal_speed(meeting(s), meeting(s).before, s.normal)) * s.normal;
  return s;
}
Judgement judge_unchanged(const Scenario& s, const std::vector<Reply>& r, bool) {
  const PairVelocity<double> got = after(r[0]);
  Judgement j;
  j.add("velocity of body 1 afterwards", "m/s", got.A.v_WB, s.A.velocity, tight * speed_scale(s));
  j.add("velocity of body 2 afterwards", "m/s", got.B.v_WB, s.B.velocity, tight * speed_scale(s));
  return j;
}

// The same meeting told the other way round: bodies exchanged, normal reversed.
std::vector<Call> ask_both(const Scenario& s) {
  Scenario other = s;
  std::swap(other.A, other.B);
  other.normal = -s.normal;
  return {ask(s)[0], ask(other)[0]};
}
Judgement judge_symmetry(const Scenario& s, const std::vector<Reply>& r, bool) {
  const PairVelocity<double> one = after(r[0]), two = after(r[1]);
  Judgement j;
  j.add("velocity of body 1, told both ways", "m/s", one.A.v_WB, two.B.v_WB, tight * speed_scale(s));
  j.add("velocity of body 2, told both ways", "m/s", one.B.v_WB, two.A.v_WB, tight * speed_scale(s));
  return j;
}

std::vector<Call> ask_scene(const Scenario& s) {
  Request q = request(Function::scene_steps, s);
  q.h = s.constants.delta_t;
  q.count = std::uint32_t(20 / s.constants.delta_t);
  q.seed = 1 + std::uint32_t(s.variant);
  q.flags = s.variant % 2 == 1 ? vacuum_on : 0;
  return {{s.constants, q, 20}};
}
Judgement judge_scene(const Scenario&, const std::vector<Reply>& r, bool) {
  Judgement j;
  j.add("every number stayed finite (1: yes)", "1", r[0].scene[3], 1, 0.5);
  j.add("centre behind a plane", "m", std::fmax(0.0, -r[0].scene[0]), 0, 1e-6);
  if (r[0].scene[3] == 1) return j;
  for (const auto& [time, energy, momentum, angular] : r[0].trace)
    if (time > 0 && !std::isfinite(energy + momentum + angular)) {
      char text[64];
      std::snprintf(text, sizeof text, "the scene blew up at t = %.3g s", time);
      j.note = text;
      break;
    }
  return j;
}

}  // namespace

std::vector<Check> pair_checks() {
  const auto pair = StudentFunction::pair_response;
  const auto plastic = [](bool turned) { return [turned](Random& random, int k) { return draw_plastic(random, k, turned); }; };
  const auto drawn = [](bool turned) { return [turned](Random& random, int k) { return draw(random, k, turned); }; };
  const std::string group = "Pair";
  std::vector<Check> list{
      {"pair.restitution", group, pair, "impulse.normal", "the contact points separate at e times the speed they met with", 3,
       {"pair.printed-restitution", "pair.restitution-ignored", "pair.restitution-one", "pair.signs-reversed", "pair.first-only",
        "pair.second-only", "pair.not-over-mass"},
       drawn(true), ask, judge_restitution},
      {"pair.impulse", group, pair, "impulse.apply_pair", "both bodies' velocities and spins change by the impulse (R = 1)", 4,
       {"pair.signs-reversed", "pair.first-only", "pair.second-only", "pair.same-direction", "pair.masses-swapped", "pair.tensors-swapped",
        "pair.first-tensor", "pair.second-tensor",
        "pair.one-arm", "pair.first-no-spin", "pair.second-no-spin", "pair.no-spin", "pair.spin-reversed", "pair.centre-velocity",
        "pair.spin-sign", "pair.no-arm", "pair.arm-from-origin", "pair.no-inertia-term", "pair.inertia-not-inverted",
        "pair.not-over-mass", "pair.restitution-one"},
       plastic(false), ask, judge_impulse, true},
      {"pair.impulse-turned", group, pair, "impulse.apply_pair", "the same with generic rotations: arms and inertias in world axes", 3,
       {"pair.arm-in-body", "pair.inverse-body", "pair.no-spin"}, plastic(true), ask, judge_impulse, true},
      {"pair.linear-momentum", group, pair, "momentum.linear", "the impulse keeps the total linear momentum", 2,
       {"pair.first-only", "pair.second-only", "pair.same-direction", "pair.masses-swapped"}, plastic(true), ask_either_way, judge_linear},
      {"pair.angular-momentum", group, pair, "momentum.angular", "the impulse keeps the total angular momentum", 3,
       {"pair.first-no-spin", "pair.second-no-spin", "pair.no-spin", "pair.spin-reversed", "pair.inverse-body", "pair.first-only", "pair.second-only"},
       plastic(true), ask_either_way, judge_angular, true},
      {"scene.runs", "Scene", pair, "step.semi_implicit", "information: the assignment's scene runs 20 s, finite, and nothing leaves the room", 0, {},
       [](Random&, int number) {
         Scenario s;
         s.variant = number;
         return s;
       },
       ask_scene, judge_scene},
      {"pair.separating", group, pair, "impulse.normal", "advice: a contact that already separates needs no impulse", 0, {}, draw_leaving, ask, judge_unchanged},
      {"pair.symmetry", group, pair, "impulse.apply_pair", "information: the same meeting told with the bodies exchanged", 0, {}, drawn(true), ask_both, judge_symmetry},
  };
  for (Check& check : list)
    if (check.id == "scene.runs") check.cases = 3;
  return list;
}

}  // namespace rigor::grader
