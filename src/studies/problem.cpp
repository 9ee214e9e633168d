#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <mutex>
#include <reference/taylor.hpp>
#include <rigor/base/suggest.hpp>
#include <rigor/grader/build_hash.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/scene/scene.hpp>
#include <rigor/studies/cell.hpp>
#include <rigor/studies/loaded.hpp>
#include <rigor/studies/problem.hpp>

namespace rigor::studies {
namespace {

using V = Vec3<double>;

// The end of a torque-free flight by the Taylor series in 60 digits, rounded once.
Problem free_flight(const std::string& name, const std::string& says, const Cuboid<double>& body, const V& w_B, double until,
                    const Mat3<double>& R_WB = rotation_of<double>(Vec4<double>(1, 2, -1, 3))) {
  Problem p{name, says, "Taylor series of order 40 in 60 digits, steps of at most 0.02 s; own error below 1e-40, then rounded to double", body, {}, nullptr, until, {}};
  p.start.R_WB = R_WB;
  p.start.w_WB = apply<double>(p.start.R_WB, w_B);
  const V w_used = apply_transposed<double>(p.start.R_WB, p.start.w_WB);
  const auto end = reference::taylor_free_body<reference::Precise>({body.inertia(), w_used, p.start.R_WB}, reference::Precise(until), 40, std::fmin(0.02, 0.1 / norm<double>(w_B)));
  p.end.R_WB = end.R_WB.cast<double>();
  p.end.w_WB = (end.R_WB * end.w_B).cast<double>();
  p.falls = zero3<double>();
  return p;
}

// The same with a centre that falls.
void throw_it(Problem& p, const V& v, const V& a) {
  p.start.v_WB = v;
  p.falls = a;
  p.load = [weight = V(p.body.mass() * a)](double, const State<double>&) { return Load{weight, zero3<double>()}; };
  p.end.v_WB = v + p.until * a;
  p.end.p_WB = p.start.p_WB + p.until * v + p.until * p.until / 2 * a;
  p.reference = "parabola for the centre; " + p.reference;
}

Problem thrown(double until) {
  Problem p = free_flight("thrown", "case FB-02 with the public box: 0.1 x 0.4 x 0.9 m, 10 kg, thrown with v = (1, 2, 3) m/s and w = (0.1, 5, 0.1) rad/s under gravity",
                          cuboid(10, {0.1, 0.4, 0.9}), V(0.1, 5, 0.1), until);
  throw_it(p, V(1, 2, 3), V(0, -9.8, 0));
  return p;
}

double kinetic(const Problem& p, const State<double>& s) {
  return (p.body.mass() * dot<double>(s.v_WB, s.v_WB) + dot<double>(s.w_WB, motion_of(p.body, s).L_W)) / 2;
}

struct Recipe {
  const char* name;
  double until;  // s, where nobody asks for another
  Problem (*make)(const std::string& name, double until);
  bool loaded = false;  // by more than gravity
};
const Cuboid<double> plate = cuboid(1, {1, 2, 3});
constexpr const char* flight_of_plate = "free flight of a cuboid 1 x 2 x 3 m, 1 kg, spin ";
Problem tumbling(const std::string& name, double until) {
  return free_flight(name, std::string(flight_of_plate) + "(0.3, 2, 0.2) rad/s in body axes: tumbling near the unstable axis", plate, V(0.3, 2, 0.2), until);
}
constexpr Recipe recipes[] = {
    {"case-A", 10, tumbling},
    {"case-B", 10, [](const std::string& name, double until) {
       return free_flight(name, std::string(flight_of_plate) + "(5, 0.01, 0.01) rad/s: about the stable axis", plate, V(5, 0.01, 0.01), until);
     }},
    {"case-C", 10, [](const std::string& name, double until) {
       return free_flight(name, std::string(flight_of_plate) + "(1e-6, 2, 1e-6) rad/s: next to the separatrix, errors grow 1.5e4 times in 10 s", plate, V(1e-6, 2, 1e-6), until);
     }},
    {"short-A", 1, tumbling},
    {"fb-01", 10, [](const std::string& name, double until) {
       return free_flight(name, "case FB-01: the same cuboid spinning about its first axis alone, 3 rad/s", plate, V(3, 0, 0), until);
     }},
    {"fb-03", 10, [](const std::string& name, double until) {
       return free_flight(name, "case FB-03: a square prism 1 x 1 x 3 m, 2 kg, spin (1, 0.5, 3) rad/s: steady precession", cuboid(2, {1, 1, 3}), V(1, 0.5, 3), until);
     }},
    {"fb-05", 10, [](const std::string& name, double until) {
       return free_flight(name, "case FB-05, the public box: 0.1 x 0.4 x 0.9 m, 10 kg, spin (0.1, 5, 0.1) rad/s", cuboid(10, {0.1, 0.4, 0.9}), V(0.1, 5, 0.1), until);
     }},
    {"fb-07", 10, [](const std::string& name, double until) {
       // I in the ratio 20 : 17 : 5: L^2 = 2 E I2 where w1 = w3
       return free_flight(name, "case FB-07, on the separatrix: a cuboid 1 x 2 x 4 m, 12 kg, spin (0.75, 1, 0.75) rad/s from the attitude 1; it settles on the unstable axis", cuboid(12, {1, 2, 4}), V(0.75, 1, 0.75), until,
                          identity3<double>());
     }},
    {"thrown", 2, [](const std::string&, double until) { return thrown(until); }},
    {"f-01", 2, constant_push, true},
    {"f-02", 2, axial_torque, true},
    {"f-03", 3, springs, true},
    {"f-04", 3, drag, true},
    {"f-05", 4, lagrange_top, true},
    {"f-06", 4, kovalevskaya_top, true},
    {"f-07", 4, goryachev_top, true},
    {"f-08", 2, chosen_motion, true},
    {"forced", 2, changing_load, true},
};

Outcome<Problem> from_scene(const std::string& path, double until) {
  const auto opened = open_scene(path);
  if (!opened) return opened.fault();
  const Scene& scene = *opened;
  const auto refuse = [&](const std::string& what) { return Fault{Fault::Kind::unsupported, path, what}; };
  if (scene.bodies.size() != 1) return refuse("has " + std::to_string(scene.bodies.size()) + " cuboids, a flight is studied with one");
  if (!scene.planes.empty() || !scene.forces.empty() || !scene.actions.empty()) return refuse("has planes, forces or actions: a flight is studied without");
  const SceneBody& body = scene.bodies[0];
  const V w_B = apply_transposed<double>(body.start.R_WB, body.start.w_WB);
  const double T = until > 0 ? until : scene.until;
  if (!(T > 0)) return Fault{Fault::Kind::not_positive, path, "ends at 0 s: nothing to study"};
  Problem p = free_flight(path, "the cuboid of " + std::filesystem::path(path).filename().string(), body.shape, w_B, T, body.start.R_WB);
  p.start.p_WB = p.end.p_WB = body.start.p_WB;
  throw_it(p, body.start.v_WB, scene.gravity);
  std::string read = digits(body.shape.mass()) + " " + digits(T);
  const auto add = [&](const auto& v) {
    for (const double x : v.reshaped()) read += " " + digits(x);
  };
  for (const V& v : {V(body.shape.size()), body.start.p_WB, body.start.v_WB, body.start.w_WB, scene.gravity}) add(v);
  add(body.start.R_WB);
  p.content = grader::sha256(read).substr(0, 16);
  return p;
}

}  // namespace

std::vector<std::string> problem_names() {
  std::vector<std::string> names;
  for (const Recipe& r : recipes) names.push_back(r.name);
  return names;
}

std::vector<std::string> free_flight_names() {
  std::vector<std::string> names;
  for (const Recipe& r : recipes)
    if (!r.loaded) names.push_back(r.name);
  return names;
}

Outcome<const Problem*> open_problem(const std::string& name, double until) {
  static std::map<std::pair<std::string, double>, Problem> made;  // nodes stay where they are
  static std::mutex mutex;
  if (!(until >= 0) || std::isinf(until)) return Fault{Fault::Kind::out_of_range, "until", "is " + digits(until) + ", must be > 0 s"};
  const Recipe* recipe = nullptr;
  for (const Recipe& r : recipes)
    if (name == r.name) recipe = &r;
  if (recipe == nullptr && !name.ends_with(".json"))
    return Fault{Fault::Kind::unknown_key, "problem",
                 fmt::format("there is no problem '{}'{}; known: {}, or a scene file", name, did_you_mean(name, problem_names()), fmt::join(problem_names(), ", "))};
  const std::lock_guard lock(mutex);
  const auto key = std::pair{name, until};
  if (const auto it = made.find(key); it != made.end()) return &it->second;
  if (recipe == nullptr) {
    auto problem = from_scene(name, until);
    if (!problem) return problem.fault();
    return &made.emplace(key, *problem).first->second;
  }
  Problem problem = recipe->make(name, until > 0 ? until : recipe->until);
  return &made.emplace(key, problem).first->second;
}

const Problem* find_problem(const std::string& name) {
  const auto problem = open_problem(name);
  return problem ? *problem : nullptr;
}

std::vector<std::string> laws(const Problem& p) {
  if (p.falls) return {"motion.free"};
  return {"motion.loaded", "load." + p.name};
}

std::vector<std::string> givens(const Problem& p) {
  const auto vector = [](const V& v) { return "(" + digits(v[0]) + ", " + digits(v[1]) + ", " + digits(v[2]) + ")"; };
  const auto turned = [](const V& v) {  // out of world axes: the last digit is that of the turn, 0.29999999999999998 for 0.3
    return fmt::format("({}, {}, {})", brief(v[0], "%.15g"), brief(v[1], "%.15g"), brief(v[2], "%.15g"));
  };
  const Vec4<double> q = quaternion_of<double>(p.start.R_WB);
  return {"m = " + digits(p.body.mass()) + " kg,  I = " + vector(p.body.inertia()) + " kg m²" + (p.falls ? ",  g = " + vector(*p.falls) + " m/s²" : ""),
          "at t = 0:  x = " + vector(p.start.p_WB) + " m,  v = " + vector(p.start.v_WB) + " m/s,  ω = " + turned(apply_transposed<double>(p.start.R_WB, p.start.w_WB)) +
              " rad/s",
          fmt::format("          R of the quaternion ({}, {}, {}, {})", digits(q[0]), digits(q[1]), digits(q[2]), digits(q[3]))};
}

Errors errors_of(const Problem& p, const State<double>& end) {
  const V L0 = motion_of(p.body, p.start).L_W, L = motion_of(p.body, end).L_W, L_want = motion_of(p.body, p.end).L_W;
  const double momentum = std::fmax(norm<double>(L0), norm<double>(L_want)), energy = std::fmax(kinetic(p, p.start), kinetic(p, p.end));
  const auto relative = [](double off, double size) { return off == 0 ? 0 : off / size; };  // a body that does not turn keeps that it does not
  return {angle_between<double>(end.R_WB, p.end.R_WB), relative(norm<double>(V(L - L_want)), momentum), relative(std::fabs(kinetic(p, end) - kinetic(p, p.end)), energy), norm<double>(V(end.p_WB - p.end.p_WB))};
}

}  // namespace rigor::studies
