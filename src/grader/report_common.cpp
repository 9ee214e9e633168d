#include <charconv>
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
      list.push_back({"contact point", triple(s.point) + " m"});
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

std::string replay_command(const Report& report, const CheckResult& result) {
  std::string path;
  for (const char c : report.submission_path) {  // quoted for a shell
    if (c == '\'') path += "'\\''";
    else path += c;
  }
  if (path.find_first_of(" \t\n'\"\\$`*?[]{}()<>|&;#~!") != std::string::npos) path = "'" + path + "'";
  return "rigor grade " + path + " --check " + result.check->id + " --case " +
         std::to_string(result.counterexample ? result.counterexample->number : 0) + " --seed " + std::to_string(report.seed);
}

}  // namespace rigor::grader
