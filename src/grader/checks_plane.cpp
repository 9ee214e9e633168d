#include <cmath>
#include <rigor/grader/check.hpp>
#include <rigor/grader/contacts.hpp>
#include <rigor/grader/misconceptions.hpp>

namespace rigor::grader {
namespace {

constexpr double tight = 1e-5;
constexpr double restitutions[4] = {0.5, 0.75, 0.25, 0.875};

std::vector<Call> ask(const Scenario& s) {
  Request q = request(Function::plane_response, s);
  q.flags = want_helpers;
  return {{s.constants, q}};
}
double speed_scale(const Scenario& s) { return norm<double>(s.A.velocity) + norm<double>(s.A.spin) * s.A.reach(); }

// A plane that lets corner `k` be the lowest of a box with this attitude: its normal, in body axes, points away from k.
void set_plane(Random& random, Scenario& s, int k) {
  Vec3<double> n_B;
  for (int i = 0; i < 3; ++i) n_B[i] = (k >> i & 1 ? -1 : 1) * grid(random, 0.5, 1.5);
  s.normal = apply<double>(s.A.R_WB(), Vec3<double>(n_B / norm<double>(n_B)));
  s.plane_point = arrow(random, 0.5, 3);
}

// One corner 1e-3 of the size behind a skew plane, coming in; the number of the case says which corner.
Scenario draw_contact(Random& random, int number, bool turned) {
  Scenario s;
  s.variant = number % 8;
  s.A = draw_box(random, turned);
  set_plane(random, s, s.variant);
  place(s.A, s.variant, 1e-3 * norm<double>(s.A.size), s.plane_point, s.normal, arrow(random, 0.5, 2));
  const Vec3<double> at_contact = point_velocity<double>(s.A.velocity, s.A.spin, corner_W(s.A, s.variant));
  const double wanted = -grid(random, 0.75, 2);  // m/s along n
  s.A.velocity += (wanted - dot<double>(at_contact, s.normal)) * s.normal;
  s.constants = {restitutions[number / 8 % 4], 0, 0, 1.0 / 240};
  s.point = s.A.position + corner_W(s.A, s.variant);
  return s;
}
// The same with e = 0, where a wrong sign in front of e cannot be seen: that is plane.restitution's business.
Scenario draw_plastic(Random& random, int number, bool turned) {
  Scenario s = draw_contact(random, number, turned);
  s.constants.restitution = 0;
  return s;
}
bool one_corner(const Scenario& s) { return single_corner(s, s.variant); }

double approach(const Scenario& s) {
  return dot<double>(point_velocity<double>(s.A.velocity, s.A.spin, corner_W(s.A, s.variant)), s.normal);
}

Judgement judge_restitution(const Scenario& s, const std::vector<Reply>& r, bool) {
  const Vec3<double> after = point_velocity<double>(vec(r[0].A.velocity), vec(r[0].A.spin), corner_W(s.A, s.variant));
  Judgement j;
  j.add("normal speed of the contact afterwards", "m/s", dot<double>(after, s.normal), -s.constants.restitution * approach(s),
        tight * speed_scale(s));
  return j;
}
Judgement judge_impulse(const Scenario& s, const std::vector<Reply>& r, bool own) {
  const ImpactBody<double> body = impact_body(s.A, corner_W(s.A, s.variant), own ? r[0].A_helpers.world_inverse_inertia : nullptr);
  const double j_n = normal_impulse<double>(s.constants.restitution, approach(s), normal_inverse_mass<double>({}, body, s.normal));
  const Velocity<double> want = apply_impulse<double>(body, {s.A.velocity, s.A.spin}, Vec3<double>(j_n * s.normal));
  Judgement j;
  j.add("velocity afterwards", "m/s", vec(r[0].A.velocity), want.v_WB, tight * speed_scale(s));
  j.add("spin afterwards", "rad/s", vec(r[0].A.spin), want.w_WB,
        tight * (norm<double>(s.A.spin) + s.A.inverse_I_B().maxCoeff() * s.A.reach() * s.A.mass * speed_scale(s)));
  j.add("rotation", "1", mat(r[0].A.rotation), s.A.R_WB(), 1e-6);
  return j;
}
Judgement judge_unmoved(const Scenario& s, const std::vector<Reply>& r, bool) {
  Judgement j;
  j.add("position", "m", vec(r[0].A.position), s.A.position, tight * norm<double>(s.A.size));
  j.add("velocity afterwards", "m/s", vec(r[0].A.velocity), s.A.velocity, tight * speed_scale(s));
  j.add("spin afterwards", "rad/s", vec(r[0].A.spin), s.A.spin, tight * (norm<double>(s.A.spin) + speed_scale(s) / s.A.reach()));
  return j;
}

// Clear of the plane, from 1 % of the size to the bounding radius, and still coming.
Scenario draw_clear(Random& random, int number) {
  Scenario s = draw_contact(random, number, true);
  const double gaps[4] = {0.01 * norm<double>(s.A.size), 0.1 * s.A.reach(), 0.4 * s.A.reach(), 0.9 * s.A.reach()};
  place(s.A, s.variant, -gaps[number / 8 % 4], s.plane_point, s.normal, arrow(random, 0.5, 2));
  s.A.velocity -= 2.0 * s.normal;
  return s;
}
// There it is left alone; the same cuboid a little behind the plane must not be.
std::vector<Call> ask_clear(const Scenario& s) {
  Scenario touching = s;
  place(touching.A, s.variant, 1e-3 * norm<double>(s.A.size), s.plane_point, s.normal, zero3<double>());
  return {ask(s)[0], ask(touching)[0]};
}
Judgement judge_clear(const Scenario& s, const std::vector<Reply>& r, bool own) {
  Judgement j = judge_unmoved(s, r, own);
  const Vec3<double> at = vec(ask_clear(s)[1].request.A.position);
  j.add_happened("to the same cuboid behind the plane", norm<double>(Vec3<double>(vec(r[1].A.velocity) - s.A.velocity)) > tight * speed_scale(s) ||
                                                            norm<double>(Vec3<double>(vec(r[1].A.position) - at)) > tight * norm<double>(s.A.size) ||
                                                            norm<double>(Vec3<double>(vec(r[1].A.spin) - s.A.spin)) > tight * norm<double>(s.A.spin));
  return j;
}
// Behind the plane, but leaving: an approach test makes nothing happen.
Scenario draw_leaving(Random& random, int number) {
  Scenario s = draw_contact(random, number, true);
  s.A.velocity += (0.5 - approach(s)) * s.normal;
  return s;
}

// Deep enough for the correction to show; one corner, or a face tilted a little.
enum class Deep { floor, any_plane, several_corners };
Scenario draw_deep(Random& random, int number, Deep kind) {
  const bool any_plane = kind != Deep::floor;
  Scenario s = draw_contact(random, number, true);
  s.A.size = s.A.size * (2.0 / s.A.size.minCoeff());  // extents of 2 and more
  if (any_plane && number % 3 == 0) {  // walls, floor and ceiling of a room, off the origin
    s.normal = zero3<double>();
    s.normal[number / 3 % 3] = number / 9 % 2 == 0 ? 1 : -1;
  } else if (!any_plane) {
    s.normal = Vec3<double>(0, 1, 0);
  }
  s.variant = depths(s.A, s.plane_point, s.normal).corner;
  const double share = kind == Deep::several_corners ? grid(random, 0.5, 0.75) : grid(random, 0.0625, 0.125);
  place(s.A, s.variant, share * s.A.size.minCoeff(), s.plane_point, s.normal, arrow(random, 0.5, 2));
  s.A.velocity += (-1 - approach(s)) * s.normal;
  return s;
}
Judgement judge_correction(const Scenario& s, const std::vector<Reply>& r, bool) {
  const Depths before = depths(s.A, s.plane_point, s.normal);
  const Vec3<double> moved = vec(r[0].A.position) - s.A.position;
  const double along = dot<double>(moved, s.normal), size = norm<double>(s.A.size);
  const double most = before.behind == 1 ? before.deepest + 0.01 * size : before.sum + 0.02 * size;
  Judgement j;
  j.add("left behind the plane", "m", std::fmax(0.0, before.deepest - along), 0, 1e-6);
  j.add("moved along the plane", "m", norm<double>(Vec3<double>(moved - along * s.normal)), 0, 1e-6 * size);
  j.add("moved out further than needed", "m", std::fmax(0.0, along - most), 0, 1e-6 * size);
  if (before.sum > before.deepest + 1e-3 * size && std::fabs(along - before.sum) <= 1e-6 * size) j.note = find_misconception("correction-each-corner")->text;
  return j;
}

// However far, it is pushed out of the plane and along the normal only.
Judgement judge_direction(const Scenario& s, const std::vector<Reply>& r, bool) {
  const Vec3<double> moved = vec(r[0].A.position) - s.A.position;
  const double along = dot<double>(moved, s.normal), size = norm<double>(s.A.size);
  Judgement j;
  j.add("moved along the plane", "m", norm<double>(Vec3<double>(moved - along * s.normal)), 0, 1e-6 * size);
  j.add_happened("to the depth", along > 0.1 * depths(s.A, s.plane_point, s.normal).deepest);
  return j;
}

// A post twice as tall as wide, falling flat: what every sound rule keeps when several corners touch.
Scenario draw_post(Random& random, int number) {
  Scenario s;
  const double width = grid(random, 0.5, 1), slenderness = grid(random, 2, 3);
  s.A.size = Vec3<double>(width, width * slenderness, width + grid(random, 0, 0.25));
  s.A.mass = grid(random, 1.25, 4);
  s.plane_point = arrow(random, 0.5, 3);
  s.A.turn = draw_turn(random);
  s.normal = apply<double>(s.A.R_WB(), Vec3<double>(0, 1, 0));
  place(s.A, 0, 1e-3 * s.A.size[1], s.plane_point, s.normal, arrow(random, 0.5, 2));
  s.A.velocity = -grid(random, 0.75, 2) * s.normal;
  const double e[3] = {0.5, 0.75, 0.875};
  s.constants = {e[number % 3], 0, 0, 1.0 / 240};
  return s;
}
double energy(const Box& b, const Mat3<double>& I, const Vec3<double>& v, const Vec3<double>& w) {
  return (b.mass * dot<double>(v, v) + dot<double>(w, apply<double>(I, w))) / 2;
}
Judgement judge_post(const Scenario& s, const std::vector<Reply>& r, bool own) {
  const Mat3<double> I = own ? inverse3(mat(r[0].A_helpers.world_inverse_inertia)) : s.A.world_inertia();
  const double before = energy(s.A, I, s.A.velocity, s.A.spin), after = energy(s.A, I, vec(r[0].A.velocity), vec(r[0].A.spin));
  const double drop = -dot<double>(s.A.velocity, s.normal);
  const double change = dot<double>(Vec3<double>(vec(r[0].A.velocity) - s.A.velocity), s.normal);
  Judgement j;
  j.add("kinetic energy gained", "J", std::fmax(0.0, after - before), 0, tight * before);
  j.add("speed change short of an eighth of the drop", "m/s", std::fmax(0.0, drop / 8 - change), 0, tight * drop);
  if (!std::isfinite(after)) j.add("kinetic energy afterwards", "J", after, before, tight * before);
  return j;
}

}  // namespace

std::vector<Check> plane_checks() {
  const auto plane = StudentFunction::plane_response;
  const auto bounce = [](Random& random, int k) { return draw_contact(random, k, true); };
  const auto plastic = [](bool turned) { return [turned](Random& random, int k) { return draw_plastic(random, k, turned); }; };
  const auto deep = [](Deep kind) { return [kind](Random& random, int k) { return draw_deep(random, k, kind); }; };
  const std::string group = "Plane normal";
  std::vector<Check> list{
      {"plane.ignores-clear", group, plane, "impulse.normal", "a cuboid clear of the plane is left alone", 1,
       {"plane.no-collision-test"}, draw_clear, ask_clear, judge_clear},
      {"plane.correction", group, plane, "contact.correction", "afterwards no corner is behind the floor; the body moved along the normal only", 2,
       {"plane.correction-missing", "plane.correction-half", "plane.correction-doubled", "plane.correction-inwards"}, deep(Deep::floor), ask, judge_correction},
      {"plane.any-orientation", group, plane, "contact.correction", "the same for walls, ceilings and skew planes anywhere", 2,
       {"plane.correction-missing", "plane.correction-inwards"}, deep(Deep::any_plane), ask, judge_correction},
      {"plane.correction-several", group, plane, "contact.correction", "the same with several corners behind the plane, at different depths", 1,
       {"plane.correction-missing", "plane.correction-half", "plane.correction-mean"}, deep(Deep::several_corners), ask, judge_correction},
      {"plane.restitution", group, plane, "impulse.normal", "the contact leaves with e times the speed it came with", 3,
       {"plane.printed-restitution", "plane.restitution-ignored", "plane.restitution-one", "plane.normal-sign", "plane.not-over-mass"},
       bounce, ask, judge_restitution},
      {"plane.impulse", group, plane, "impulse.apply", "velocity and spin change by the impulse at the corner (R = 1)", 3,
       {"plane.centre-velocity", "plane.spin-sign", "plane.no-arm", "plane.arm-from-origin", "plane.no-inertia-term",
        "plane.inertia-not-inverted", "plane.not-over-mass", "plane.no-spin", "plane.spin-reversed", "plane.restitution-one"},
       plastic(false), ask, judge_impulse, true},
      {"plane.impulse-turned", group, plane, "impulse.apply", "the same with a generic rotation: arms and inertia in world axes", 2,
       {"plane.arm-in-body", "plane.inverse-body", "plane.no-spin"}, plastic(true), ask, judge_impulse, true},
      {"plane.energy", group, plane, "energy.kinetic", "a post that falls flat gains no energy and is stopped", 1,
       {"plane.normal-sign"}, draw_post, ask, judge_post, true},
      {"plane.separating", group, plane, "impulse.normal", "advice: a contact that already separates needs no impulse", 0, {}, draw_leaving, ask,
       [](const Scenario& s, const std::vector<Reply>& r, bool own) {
         Judgement j = judge_unmoved(s, r, own);
         j.components.erase(j.components.begin(), j.components.begin() + 3);  // the correction may move it
         return j;
       }},
  };
  for (Check& check : list) {
    if (check.id == "plane.any-orientation") check.follows = {"plane.correction"}, check.given = judge_direction;
    if (check.id == "plane.restitution" || check.id.rfind("plane.impulse", 0) == 0) {
      check.sound = one_corner;
      check.renew = [](Scenario& s) {
        place(s.A, s.variant, 1e-3 * norm<double>(s.A.size), s.plane_point, s.normal, zero3<double>());
        s.point = s.A.position + corner_W(s.A, s.variant);
      };
    }
  }
  return list;
}

}  // namespace rigor::grader
