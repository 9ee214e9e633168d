#include <rigor/grader/build.hpp>
#include <rigor/grader/records.hpp>
#include <rigor/studies/student.hpp>

namespace rigor::studies {
namespace {

using namespace grader;
using V = Vec3<double>;

Request request_for(Function function, double h, long count) {
  Request q{};
  q.function = std::uint32_t(function);
  q.count = std::uint32_t(count);
  q.direct = 1;
  q.h = h;
  return q;
}
Outcome<Reply> ask(Worker& worker, const Request& q, double seconds) {
  const Answer answer = worker.call(q, seconds);
  if (const Death* death = std::get_if<Death>(&answer)) return Fault{Fault::Kind::unsupported, "submission", death->words};
  const Reply& reply = std::get<Reply>(answer);
  if (reply.status != std::uint32_t(Status::done)) return Fault{Fault::Kind::unsupported, "submission", "its function did not return"};
  return reply;
}

}  // namespace

Outcome<Student> Student::make(const std::filesystem::path& path) {
  const auto opened = open_submission(path);
  if (!opened) return opened.fault();
  const auto built = build(*opened);
  if (!built) return built.fault();
  const auto compiled = [&](StudentFunction f) { return built->of(f).kind == FunctionStatus::Kind::compiled; };
  if (built->executable.empty() || !compiled(StudentFunction::update))
    return Fault{Fault::Kind::unsupported, path.string(), "has no Cuboid::update that compiles: " + (built->of(StudentFunction::update).error.empty() ? std::string("not implemented") : built->of(StudentFunction::update).error)};
  Student s;
  s.executable_ = built->executable;
  s.name_ = "submission " + opened->name + " " + opened->hash.substr(0, 12);
  s.has_plane_ = compiled(StudentFunction::plane_response);
  s.own_constants_ = built->own_constants;
  return s;
}

Outcome<Student::Flown> Student::fly(const Problem& problem, long steps, int repeats) {
  if (problem.load && !problem.falls) return Fault{Fault::Kind::unsupported, "submission", "is only asked for loads that are constant"};
  const double h = problem.until / double(steps);
  Constants constants;
  constants.delta_t = h;
  Limits limits;
  limits.total_s = 600;
  Worker worker(executable_, constants, limits);
  Request q = request_for(Function::update, h, steps);
  q.flags = hold_forces;
  q.A = record(problem.body.size(), problem.body.mass(), problem.start, problem.body.inertia(), problem.body.inverse_inertia());
  put(q.A.net_force, problem.load_at(0, problem.start).f_W);
  const Request nothing = request_for(Function::constants, h, 1);
  if (const auto warm = ask(worker, q, 20); !warm) return warm.fault();
  Flown flown;
  std::vector<double> wall, empty;
  for (int k = 0; k < std::max(1, repeats); ++k) {
    double start = wall_seconds();
    if (const auto reply = ask(worker, nothing, 20); !reply) return reply.fault();
    empty.push_back(wall_seconds() - start);
    start = wall_seconds();
    const auto reply = ask(worker, q, 20);
    if (!reply) return reply.fault();
    wall.push_back(wall_seconds() - start);
    flown.end = state(reply->A);
  }
  const Timing call = summary(wall, wall), none = summary(empty, empty);
  const double least = std::max(1e-9, call.wall_min - none.wall_min), median = std::max(1e-9, call.wall_median - none.wall_median);
  flown.timing = {least, median, least, median};
  return flown;
}

Outcome<bool> Student::bounce(const Cuboid<double>& body, const State<double>& start, const Plane<double>& plane, const Surface<double>& surface, const V& gravity, double h, long steps,
                              const std::function<bool(double t, const State<double>&)>& see) {
  const auto unsupported = [](const char* what) { return Fault{Fault::Kind::unsupported, "submission", what}; };
  if (!has_plane_) return unsupported("has no plane response that compiles");
  if (own_constants_) return unsupported("brings constants of its own: restitution and friction cannot be set");
  Constants constants{surface.restitution(), surface.static_friction(), surface.dynamic_friction(), h};
  Limits limits;
  limits.total_s = 600;
  Worker worker(executable_, constants, limits);
  Request hit = request_for(Function::plane_response, h, 1), move = request_for(Function::update, h, 1);
  put(hit.plane_point, plane.point());
  put(hit.plane_normal, plane.normal());
  BodyRecord A = record(body.size(), body.mass(), start, body.inertia(), body.inverse_inertia());
  for (long k = 0; k < steps; ++k) {
    hit.A = A;
    put(hit.A.net_force, V(body.mass() * gravity));
    const auto after = ask(worker, hit, 0);
    if (!after) return after.fault();
    move.A = after->A;
    const auto moved = ask(worker, move, 0);
    if (!moved) return moved.fault();
    A = moved->A;
    if (!see(double(k + 1) * h, state(A))) break;
  }
  return true;
}

}  // namespace rigor::studies
