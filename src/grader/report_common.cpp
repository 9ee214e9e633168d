#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <rigor/grader/contacts.hpp>
#include <rigor/grader/report.hpp>

namespace rigor::grader {

const char* name(Verdict verdict) {
  constexpr const char* names[] = {"pass", "fail", "crash", "timeout", "memory", "not-compiled", "not-implemented", "skipped"};
  return names[int(verdict)];
}

std::string shortest(double x) {
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, x == 0 ? 0.0 : x);
  return std::string(text, end.ptr);
}

namespace {

// Seven digits: a case is to be read; the replay command gives the exact one.
std::string rounded(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.7g", x == 0 ? 0.0 : x);
  return text;
}
std::string triple(const Vec3<double>& v) { return "(" + rounded(v[0]) + ", " + rounded(v[1]) + ", " + rounded(v[2]) + ")"; }
std::string rows(const Mat3<double>& M) {
  return "[" + triple(Vec3<double>(M.row(0))) + ", " + triple(Vec3<double>(M.row(1))) + ", " + triple(Vec3<double>(M.row(2))) + "]";
}

using Rows = std::vector<std::pair<std::string, std::string>>;

void add_box(Rows& list, const Box& b, const std::string& which, bool moves) {
  list.push_back({"width, height, depth" + which, triple(b.size) + " m"});
  list.push_back({"mass" + which, rounded(b.mass) + " kg"});
  list.push_back({"worldRotation" + which, b.turn.tail<3>().isZero() ? "identity" : rows(b.R_WB())});
  if (!moves) return;
  list.push_back({"worldTranslation" + which, triple(b.position) + " m"});
  list.push_back({"linearVelocity" + which, triple(b.velocity) + " m/s"});
  list.push_back({"angularVelocity" + which, triple(b.spin) + " rad/s"});
}

}  // namespace

Vec3<double> contact_point(const Counterexample& e) {
  if (e.function != Function::plane_response) return e.inputs.point;
  const Depths d = depths(e.inputs.A, e.inputs.plane_point, e.inputs.normal);
  return e.inputs.A.position + corner_W(e.inputs.A, d.corner);
}

std::vector<std::pair<std::string, std::string>> named_inputs(const Counterexample& e) {
  const Scenario& s = e.inputs;
  Rows list;
  switch (e.function) {
    case Function::body_inertia:
    case Function::world_inertia: add_box(list, s.A, "", false); break;
    case Function::apply_force:
      add_box(list, s.A, "", true);
      list.push_back({"netForce before", triple(s.A.force) + " N"});
      list.push_back({"netTorque before", triple(s.A.torque) + " N m"});
      list.push_back({"worldPosition", triple(s.point) + " m"});
      list.push_back({"force", triple(s.vector) + " N"});
      break;
    case Function::update:
      add_box(list, s.A, "", true);
      list.push_back({"netForce", triple(s.A.force) + " N"});
      list.push_back({"netTorque", triple(s.A.torque) + " N m"});
      list.push_back({"delta", rounded(s.h) + " s and smaller, where a limit is taken"});
      break;
    case Function::friction_tangent:
    case Function::plane_response:
      add_box(list, s.A, "", true);
      list.push_back({"netForce", triple(s.A.force) + " N"});
      list.push_back({"pointOnPlane", triple(s.plane_point) + " m"});
      list.push_back({"normal", triple(s.normal)});
      list.push_back({e.function == Function::plane_response ? "deepest corner" : "contact point", triple(contact_point(e)) + " m"});
      break;
    case Function::pair_response:
      add_box(list, s.A, " of body 1", true);
      add_box(list, s.B, " of body 2", true);
      list.push_back({"collisionPoint", triple(s.point) + " m"});
      list.push_back({"collisionNormal", triple(s.normal)});
      break;
    default: list.push_back({"scene", "the assignment's, seed " + std::to_string(1 + s.variant)});
  }
  if (e.function == Function::plane_response || e.function == Function::pair_response)
    list.push_back({"restitution, static and dynamic friction",
                    rounded(s.constants.restitution) + ", " + rounded(s.constants.static_friction) + ", " + rounded(s.constants.dynamic_friction)});
  return list;
}

namespace {

// A word of a shell's, on one line whatever is in it.
std::string quoted(const std::string& word) {
  const auto control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; };
  if (std::any_of(word.begin(), word.end(), control)) {
    std::string text = "$'";
    for (const char c : word) {
      char hex[8];
      std::snprintf(hex, sizeof hex, "\\x%02x", static_cast<unsigned char>(c));
      text += control(c) || c == '\'' || c == '\\' ? hex : std::string(1, c);
    }
    return text + "'";
  }
  if (word.find_first_of(" '\"\\$`*?[]{}()<>|&;#~!") == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

}  // namespace

bool shown(const Report& report, const CheckResult& result) { return report.reader == Reader::instructor || std::string_view(result.visibility) == "visible"; }

std::string withheld(const Report& report) {
  int checks = 0;
  double points = 0;
  for (const CheckResult& r : report.results)
    if (!shown(report, r)) ++checks, points += r.max_points;
  if (checks == 0) return "";
  return counted(checks, "check") + " worth " + rounded(points) + (checks == 1 ? " is" : " are") + " not shown here; the total counts " + (checks == 1 ? "it" : "them");
}

std::string counted(int n, const char* what) { return std::to_string(n) + " " + what + (n == 1 ? "" : "s"); }

std::string said_of(const CheckResult& r) { return (r.verdict == Verdict::fail && r.max_points > 0 ? "must hold: " : "") + r.check->says; }

const Component* worst(const Counterexample& e) {
  const Component* most = nullptr;
  double ratio = -1;
  for (const Component& c : e.judgement.components) {
    const double r = c.got == c.want ? 0 : std::fabs(c.got - c.want) / c.bound;
    if (std::isnan(r)) return &c;
    if (r > ratio) ratio = r, most = &c;
  }
  return most;
}

std::string replay_command(const Report& report, const CheckResult& result) {
  if (report.reader == Reader::platform) return "";
  const std::string which = " --check " + result.check->id + " --case " + std::to_string(result.counterexample ? result.counterexample->number : 0) +
                            (report.asked_cases > 0 ? " --cases " + std::to_string(report.asked_cases) : "");
  if (report.reader == Reader::practice) return "./practice" + which;
  return "rigor grade " + quoted(report.submission_path) + (report.rubric_path.empty() ? "" : " --rubric " + quoted(report.rubric_path)) + which + " --seed " + std::to_string(report.seed);
}

}  // namespace rigor::grader
