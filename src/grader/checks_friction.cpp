#include <optional>
#include <rigor/formulas/effective_mass.hpp>
#include <rigor/formulas/friction_tangent.hpp>
#include <rigor/grader/check.hpp>
#include <rigor/grader/misconceptions.hpp>
#include <rigor/grader/contacts.hpp>

namespace rigor::grader {
namespace {

constexpr double tight = 1e-5;

// ---- frictionTangent

std::vector<Call> ask_tangent(const Scenario& s) { return {{s.constants, request(Function::friction_tangent, s)}}; }

Scenario draw_slip(Random& random, int) {
  Scenario s;
  s.A = draw_box(random, true);
  s.A.force = arrow(random, 2, 9);
  s.normal = draw_direction(random);
  s.plane_point = arrow(random, 0.5, 3);
  const int k = integer(random, 0, 7);
  place(s.A, k, 1e-3, s.plane_point, s.normal, arrow(random, 0.5, 2));
  s.point = s.A.position + corner_W(s.A, k);
  return s;
}
Vec3<double> slip_tangent(const Scenario& s) {
  const Vec3<double> v = point_velocity<double>(s.A.velocity, s.A.spin, Vec3<double>(s.point - s.A.position));
  return friction_tangent<double>(v, s.A.force, s.normal);
}
// −t is as good as t: "the tangential direction in which the friction force will be applied".
Judgement judge_direction(const Scenario& s, const std::vector<Reply>& r, bool) {
  const Vec3<double> got = vec(r[0].vector), want = slip_tangent(s);
  const bool against = dot<double>(got, want) < 0;
  Judgement j;
  j.add("tangent", "1", got, against ? Vec3<double>(-want) : want, tight);
  j.add("velocity (must be left alone)", "m/s", vec(r[0].A.velocity), s.A.velocity, tight);
  if (against) j.note = find_misconception("tangent-against-slip")->text;
  return j;
}
Scenario draw_resting(Random& random, int number) {
  Scenario s = draw_slip(random, number);
  s.A.velocity = s.A.spin = zero3<double>();
  return s;
}
Scenario draw_nothing(Random& random, int number) {
  Scenario s = draw_resting(random, number);
  s.A.force = zero3<double>();
  return s;
}
// At rest, and once slipping: there the answer must not be zero.
std::vector<Call> ask_zero(const Scenario& s) {
  Scenario slipping = s;
  slipping.A.velocity = cross<double>(s.normal, Vec3<double>(std::fabs(s.normal[0]) < 0.6 ? Vec3<double>(1, 0, 0) : Vec3<double>(0, 1, 0)));
  return {ask_tangent(s)[0], ask_tangent(slipping)[0]};
}
Judgement judge_zero(const Scenario&, const std::vector<Reply>& r, bool) {
  Judgement j;
  j.add("tangent", "1", vec(r[0].vector), zero3<double>(), 1e-6);
  j.add_happened("where it slips", norm<double>(vec(r[1].vector)) > 1e-3);
  return j;
}
bool clear_tangent(const Scenario& s) {  // slip and force both well off the normal, and off each other
  const Vec3<double> v = point_velocity<double>(s.A.velocity, s.A.spin, Vec3<double>(s.point - s.A.position));
  for (const Vec3<double>& a : {v, s.A.force})
    if (norm<double>(a) > 0 && norm<double>(cross<double>(a, s.normal)) < 0.3 * norm<double>(a)) return false;
  return true;
}

// ---- friction of applyCollisionResponse: e = 0, the corner straight below the centre (n parallel to the arm, so
// normal and tangent are not coupled and every law agrees), slip along an eigenvector of K, R = 1.

struct Aligned {
  Vec3<double> arm, t;      // t: eigenvector of K, unit, tangential
  double j_n, k_tt;         // normal impulse; effective inverse mass along t
};
// `shift`: of the contact along n, m.
Aligned aligned(const Scenario& s, double shift = 0) {
  Aligned a;
  a.arm = corner_W(s.A, s.variant) + shift * s.normal;
  const ImpactBody<double> body = impact_body(s.A, a.arm);
  const double v_n = dot<double>(point_velocity<double>(s.A.velocity, s.A.spin, a.arm), s.normal);
  a.j_n = -v_n / normal_inverse_mass<double>({}, body, s.normal);
  const Mat3<double> K = effective_inverse_mass<double>({}, body);
  // the tangential 2×2 block in any basis, its larger eigenvalue's direction
  Vec3<double> e1 = cross<double>(s.normal, Vec3<double>(1, 0, 0));
  if (norm<double>(e1) < 0.5) e1 = cross<double>(s.normal, Vec3<double>(0, 1, 0));
  e1 /= norm<double>(e1);
  const Vec3<double> e2 = cross<double>(s.normal, e1), K1 = apply<double>(K, e1), K2 = apply<double>(K, e2);
  const double angle = std::atan2(2 * dot<double>(e1, K2), dot<double>(e1, K1) - dot<double>(e2, K2)) / 2;
  a.t = std::cos(angle) * e1 + std::sin(angle) * e2;
  a.k_tt = dot<double>(a.t, apply<double>(K, a.t));
  return a;
}

Scenario draw_aligned(Random& random, int number, double mu_s, double mu_d) {
  Scenario s;
  s.variant = number % 8;
  s.A.size = draw_edges(random);
  s.A.mass = grid(random, 1.25, 4);
  s.A.force = arrow(random, 2, 9);
  const Vec3<double> arm = corner_W(s.A, s.variant);
  s.normal = -arm / norm<double>(arm);
  s.plane_point = arrow(random, 0.5, 3);
  place(s.A, s.variant, 1e-3 * norm<double>(s.A.size), s.plane_point, s.normal, arrow(random, 0.5, 2));
  s.A.velocity = -grid(random, 1, 2) * s.normal;
  s.A.spin = grid(random, 0.5, 1) * s.normal;  // about the normal: no slip from it
  s.point = s.A.position + arm;
  s.constants = {0, mu_s, mu_d, 1.0 / 240};
  return s;
}
bool clear_of_others(const Scenario& s) { return single_corner(s, s.variant); }

Request with_slip(const Scenario& s, double slip) {
  Scenario at = s;
  at.A.velocity += slip * aligned(s).t;
  return request(Function::plane_response, at);
}
// What must hold for any law: the impulse read off the velocity also explains the spin.
void judge_impulse(Judgement& j, const Scenario& s, const Aligned& a, const Reply& r, double slip, double want, const std::string& when) {
  const Vec3<double> before = s.A.velocity + slip * a.t, J = s.A.mass * (vec(r.A.velocity) - before);
  const Vec3<double> turn = apply<double>(s.A.world_inverse(), cross<double>(a.arm, J));
  const double bound = tight * s.A.mass * (norm<double>(before) + std::fabs(slip));
  j.add("friction impulse against the slip" + when, "N s", -dot<double>(J, a.t), want, bound);
  j.add("friction impulse across the slip" + when, "N s", dot<double>(J, cross<double>(s.normal, a.t)), 0, bound);
  j.add("spin change without r x impulse" + when, "rad/s", norm<double>(Vec3<double>(vec(r.A.spin) - s.A.spin - turn)), 0,
        tight * (norm<double>(s.A.spin) + s.A.inverse_I_B().maxCoeff() * s.A.reach() * s.A.mass * norm<double>(before)));
}

double slide_speed(const Scenario& s) {
  const Aligned a = aligned(s);
  return 2.25 * s.constants.static_friction * a.j_n * std::fmax(a.k_tt, 1 / s.A.mass);
}
std::vector<Call> ask_slide(const Scenario& s) { return {{s.constants, with_slip(s, slide_speed(s))}}; }
Judgement judge_slide(const Scenario& s, const std::vector<Reply>& r, bool) {
  Judgement j;
  const Aligned a = aligned(s);
  judge_impulse(j, s, a, r[0], slide_speed(s), s.constants.dynamic_friction * a.j_n, "");
  return j;
}

// Three forms of sticking are right: m v_t (the sheet's), v_t/k_tt (the effective mass), and none (the rule read literally).
enum class Form { short_form, effective, literal, unknown };
double stick_speed(const Scenario& s) { return 0.3 * s.constants.static_friction * aligned(s).j_n / s.A.mass; }
double impulse_of(Form form, const Scenario& s, const Aligned& a, double slip) {
  const double stop = form == Form::effective ? slip / a.k_tt : s.A.mass * slip;
  if (form == Form::literal || stop > s.constants.static_friction * a.j_n) return s.constants.dynamic_friction * a.j_n;
  return stop;
}
Form form_seen(const Scenario& s, const Aligned& a, const Reply& r, double slip) {
  const double got = -s.A.mass * dot<double>(Vec3<double>(vec(r.A.velocity) - s.A.velocity - slip * a.t), a.t);
  for (const Form form : {Form::short_form, Form::effective, Form::literal})
    if (std::fabs(got - impulse_of(form, s, a, slip)) <= tight * s.A.mass * (norm<double>(s.A.velocity) + slip)) return form;
  return Form::unknown;
}
std::string note_of(Form form) {
  if (form == Form::effective) return find_misconception("friction-effective-mass")->text;
  if (form == Form::literal) return find_misconception("friction-literal")->text;
  return "";
}

std::vector<Call> ask_stick(const Scenario& s) { return {{s.constants, with_slip(s, stick_speed(s))}}; }
Judgement judge_stick(const Scenario& s, const std::vector<Reply>& r, bool) {
  const double slip = stick_speed(s);
  const Aligned a = aligned(s);
  const Form form = form_seen(s, a, r[0], slip);
  Judgement j;
  j.note = note_of(form);
  judge_impulse(j, s, a, r[0], slip, impulse_of(form, s, a, slip), "");
  return j;
}

// At 0.8 and 1.25 times the limit of the form seen when sticking.
std::vector<double> limit_speeds(const Scenario& s) {
  const Aligned a = aligned(s);
  const double limit = s.constants.static_friction * a.j_n;
  return {stick_speed(s), 0.8 * limit / s.A.mass, 1.25 * limit / s.A.mass, 0.8 * limit * a.k_tt, 1.25 * limit * a.k_tt};
}
std::vector<Call> ask_limit(const Scenario& s) {
  std::vector<Call> calls;
  for (const double slip : limit_speeds(s)) calls.push_back({s.constants, with_slip(s, slip)});
  return calls;
}
Judgement judge_limit(const Scenario& s, const std::vector<Reply>& r, bool) {
  const std::vector<double> slips = limit_speeds(s);
  const Aligned a = aligned(s);
  const Form form = form_seen(s, a, r[0], slips[0]);
  const std::size_t first = form == Form::effective ? 3 : 1;
  Judgement j;
  j.note = note_of(form);
  judge_impulse(j, s, a, r[first], slips[first], impulse_of(form, s, a, slips[first]), " at 0.8 of the limit");
  judge_impulse(j, s, a, r[first + 1], slips[first + 1], impulse_of(form, s, a, slips[first + 1]), " at 1.25 of the limit");
  return j;
}

// The law of friction by the answer's own normal impulse, and its own contact point: the corner where it is now, where it
// was before the push-out (the body has moved since), or on the plane. All answers of a case by one form and one point.
Judgement judge_own_contact(const Scenario& s, const std::vector<Reply>& r, const std::vector<double>& slips) {
  const double pushed = dot<double>(Vec3<double>(vec(r[0].A.position) - s.A.position), s.normal);
  const double depth = depths(s.A, s.plane_point, s.normal).deepest;
  std::optional<Judgement> best;
  for (const double shift : {0.0, -pushed, depth - pushed})
    for (const Form form : {Form::short_form, Form::effective, Form::literal}) {
      Judgement j;
      for (std::size_t k = 0; k < r.size(); ++k) {
        Aligned a = aligned(s, shift);
        const double right = a.j_n;
        a.j_n = s.A.mass * dot<double>(Vec3<double>(vec(r[k].A.velocity) - s.A.velocity), s.normal);  // the slip is across n
        judge_impulse(j, s, a, r[k], slips[k], impulse_of(form, s, a, slips[k]), "");
        j.add_happened("along the normal", a.j_n > 0.01 * right);
      }
      if (!best || j.ratio() < best->ratio()) best = j;
    }
  return *best;
}

}  // namespace

std::vector<Check> friction_checks() {
  const auto tangent = StudentFunction::friction_tangent, plane = StudentFunction::plane_response;
  const std::string group = "Friction";
  constexpr double mu_s[3] = {0.5, 0.6, 0.75};
  const auto drawn = [=](double ratio) {
    return [=](Random& random, int k) { return draw_aligned(random, k, mu_s[k / 8 % 3], ratio * mu_s[k / 8 % 3]); };
  };
  std::vector<Check> list{
      {"tangent.slip", group, tangent, "friction.tangent", "with slip: its tangential part, normalised", 4,
       {"tangent.not-normalised", "tangent.not-projected", "tangent.of-centre", "tangent.force-first"}, draw_slip, ask_tangent, judge_direction},
      {"tangent.force", group, tangent, "friction.tangent", "without slip: the tangential part of the net force, normalised", 2,
       {"tangent.no-fallback", "tangent.not-normalised", "tangent.not-projected"}, draw_resting, ask_tangent, judge_direction},
      {"tangent.zero", group, tangent, "friction.tangent", "without slip and force: the zero vector", 1, {}, draw_nothing, ask_zero, judge_zero},
      {"plane.friction-slide", group, plane, "friction.sheet", "fast slip: friction is mu_d times the normal impulse, against the slip", 3,
       {"friction.missing", "friction.reversed", "friction.unlimited", "friction.mu-swapped", "friction.no-turn", "friction.spin-only",
        "friction.bare-coefficients", "friction.not-over-mass"},
       drawn(0.6), ask_slide, judge_slide},
      {"plane.friction-stick", group, plane, "friction.sheet", "slow slip: friction stops it (m v_t, or v_t over the tangential inverse mass)", 3,
       {"friction.missing", "friction.reversed", "friction.no-turn", "friction.spin-only"}, drawn(0.5), ask_stick, judge_stick},
      {"plane.friction-limit", group, plane, "friction.sheet", "it sticks up to mu_s times the normal impulse and slides beyond", 2,
       {"friction.unlimited", "friction.mu-swapped", "friction.bare-coefficients", "friction.missing", "friction.contact-before-push"}, drawn(0.5), ask_limit, judge_limit},
  };
  list[0].sound = list[1].sound = clear_tangent;
  list[3].given = [](const Scenario& s, const std::vector<Reply>& r, bool) { return judge_own_contact(s, r, {slide_speed(s)}); };
  list[4].given = [](const Scenario& s, const std::vector<Reply>& r, bool) { return judge_own_contact(s, r, {stick_speed(s)}); };
  list[5].given = [](const Scenario& s, const std::vector<Reply>& r, bool) { return judge_own_contact(s, r, limit_speeds(s)); };
  for (const std::size_t k : {3u, 4u, 5u}) {
    list[k].follows = {"plane.correction", "plane.impulse"};
    list[k].sound = clear_of_others;
    list[k].renew = [](Scenario& s) {
      const Vec3<double> arm = corner_W(s.A, s.variant);
      s.normal = -arm / norm<double>(arm);
      place(s.A, s.variant, 1e-3 * norm<double>(s.A.size), s.plane_point, s.normal, zero3<double>());
      s.A.velocity = -norm<double>(s.A.velocity) * s.normal;
      s.A.spin = norm<double>(s.A.spin) * s.normal;
      s.point = s.A.position + arm;
    };
  }
  return list;
}

}  // namespace rigor::grader
