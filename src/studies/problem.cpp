#include <cmath>
#include <map>
#include <reference/sundials.hpp>
#include <reference/taylor.hpp>
#include <rigor/base/promise.hpp>
#include <rigor/formulas/world_inertia.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/studies/problem.hpp>

namespace rigor::studies {
namespace {

using V = Vec3<double>;

Cuboid<double> cuboid(double m, const V& size) { return *Cuboid<double>::make(m, size); }

// The end of a torque-free flight by the Taylor series in 60 digits, rounded once.
Problem free_flight(const std::string& name, const std::string& says, const Cuboid<double>& body, const V& w_B, double until) {
  Problem p{name, says, "Taylor series of order 40 in 60 digits, steps of 0.02 s; own error below 1e-40, then rounded to double", body, {}, nullptr, until, {}};
  p.start.R_WB = rotation_of<double>(Vec4<double>(1, 2, -1, 3));
  p.start.w_WB = apply<double>(p.start.R_WB, w_B);
  const V w_used = apply_transposed<double>(p.start.R_WB, p.start.w_WB);
  const auto end = reference::taylor_free_body<reference::Precise>({body.inertia(), w_used, p.start.R_WB}, reference::Precise(until));
  p.end.R_WB = end.R_WB.cast<double>();
  p.end.w_WB = (end.R_WB * end.w_B).cast<double>();
  return p;
}

Problem thrown() {
  Problem p{"thrown", "a 10 kg box, 0.1 x 0.4 x 0.9 m, thrown with v = (1, 2, 3) m/s and w = (0.1, 5, 0.1) rad/s under gravity, T = 2 s",
            "parabola for the centre; Taylor series in 60 digits for the rotation", cuboid(10, {0.1, 0.4, 0.9}), {}, nullptr, 2, {}};
  p = [&] {
    Problem q = free_flight(p.name, p.says, p.body, V(0.1, 5, 0.1), p.until);
    q.reference = p.reference;
    return q;
  }();
  const V g(0, -9.8, 0);
  p.start.v_WB = V(1, 2, 3);
  p.load = [weight = V(10 * g)](double, const State<double>&) { return Load{weight, zero3<double>()}; };
  p.end.v_WB = p.start.v_WB + p.until * g;
  p.end.p_WB = p.until * p.start.v_WB + p.until * p.until / 2 * g;
  return p;
}

// Gravity and a torque that changes in time: every term is active. Reference: CVODE on (p, v, q, L).
Problem forced() {
  Problem p{"forced", "a cuboid 1 x 2 x 3 m, 1 kg, under F = (sin t, -1, cos 2t) N and torque (cos t, sin 2t, 1/2) N m, T = 2 s",
            "CVODE Adams at tolerance 1e-14, own error about 1e-12", cuboid(1, {1, 2, 3}), {}, nullptr, 2, {}};
  p.start.R_WB = rotation_of<double>(Vec4<double>(1, 2, -1, 3));
  p.start.w_WB = V(0.3, 1, -0.4);
  p.start.v_WB = V(1, 0, -1);
  const auto force = [](double t) { return V(std::sin(t), -1, std::cos(2 * t)); };
  const auto torque = [](double t) { return V(std::cos(t), std::sin(2 * t), 0.5); };
  p.load = [=](double t, const State<double>&) { return Load{force(t), torque(t)}; };
  const Cuboid<double> body = p.body;
  const reference::Rhs rhs = [=](double t, std::span<const double> y, std::span<double> d) {
    const Mat3<double> R = rotation_of<double>(Vec4<double>(y[6], y[7], y[8], y[9]));
    const V L(y[10], y[11], y[12]), L_B = R.transpose() * L, w = R * L_B.cwiseProduct(body.inverse_inertia()), f = force(t), tau = torque(t);
    for (std::size_t i = 0; i < 3; ++i) d[i] = y[3 + i], d[3 + i] = f[int(i)] / body.mass(), d[10 + i] = tau[int(i)];
    d[6] = -0.5 * (w[0] * y[7] + w[1] * y[8] + w[2] * y[9]);  // q' = (0, w) q / 2, w in world axes
    d[7] = 0.5 * (w[0] * y[6] + w[1] * y[9] - w[2] * y[8]);
    d[8] = 0.5 * (w[1] * y[6] + w[2] * y[7] - w[0] * y[9]);
    d[9] = 0.5 * (w[2] * y[6] + w[0] * y[8] - w[1] * y[7]);
  };
  const Vec4<double> q = quaternion_of<double>(p.start.R_WB);
  const V L = motion_of(p.body, p.start).L_W;
  const auto end = reference::cvode(rhs, {0, 0, 0, 1, 0, -1, q[0], q[1], q[2], q[3], L[0], L[1], L[2]}, 0, p.until, 1e-14);
  promise(bool(end), "CVODE solves the forced problem of the catalogue");
  const std::vector<double>& y = end->y;
  p.end.p_WB = V(y[0], y[1], y[2]);
  p.end.v_WB = V(y[3], y[4], y[5]);
  p.end.R_WB = rotation_of<double>(Vec4<double>(y[6], y[7], y[8], y[9]));
  const V L_B = apply_transposed<double>(p.end.R_WB, V(y[10], y[11], y[12]));
  p.end.w_WB = apply<double>(p.end.R_WB, V(L_B.cwiseProduct(p.body.inverse_inertia())));
  return p;
}

double kinetic(const Problem& p, const State<double>& s) {
  return (p.body.mass() * dot<double>(s.v_WB, s.v_WB) + dot<double>(s.w_WB, motion_of(p.body, s).L_W)) / 2;
}

}  // namespace

namespace {

struct Recipe {
  const char* name;
  Problem (*make)(const std::string& name);
};
const Cuboid<double> plate = cuboid(1, {1, 2, 3});
constexpr Recipe recipes[] = {
    {"case-A", [](const std::string& name) {
       return free_flight(name, "free flight of a cuboid 1 x 2 x 3 m, 1 kg, spin (0.3, 2, 0.2) rad/s in body axes: tumbling near the unstable axis, T = 10 s", plate, V(0.3, 2, 0.2), 10);
     }},
    {"case-B", [](const std::string& name) { return free_flight(name, "the same cuboid, spin (5, 0.01, 0.01) rad/s: about the stable axis, T = 10 s", plate, V(5, 0.01, 0.01), 10); }},
    {"case-C", [](const std::string& name) {
       return free_flight(name, "the same cuboid, spin (1e-6, 2, 1e-6) rad/s: next to the separatrix, errors grow 1.5e4 times by T = 10 s", plate, V(1e-6, 2, 1e-6), 10);
     }},
    {"short-A", [](const std::string& name) { return free_flight(name, "case A up to T = 1 s, where first-order methods are asymptotic", plate, V(0.3, 2, 0.2), 1); }},
    {"fb-05", [](const std::string& name) {
       return free_flight(name, "the public box, 0.1 x 0.4 x 0.9 m, 10 kg, spin (0.1, 5, 0.1) rad/s, T = 10 s", cuboid(10, {0.1, 0.4, 0.9}), V(0.1, 5, 0.1), 10);
     }},
    {"thrown", [](const std::string&) { return thrown(); }},
    {"forced", [](const std::string&) { return forced(); }},
};

}  // namespace

std::vector<std::string> problem_names() {
  std::vector<std::string> names;
  for (const Recipe& r : recipes) names.push_back(r.name);
  return names;
}

const Problem* find_problem(const std::string& name) {
  static std::map<std::string, Problem> made;
  for (const Recipe& r : recipes)
    if (name == r.name) {
      auto it = made.find(name);
      if (it == made.end()) it = made.emplace(name, r.make(name)).first;
      return &it->second;
    }
  return nullptr;
}

Errors errors_of(const Problem& p, const State<double>& end) {
  const V L0 = motion_of(p.body, p.start).L_W, L = motion_of(p.body, end).L_W, L_want = motion_of(p.body, p.end).L_W;
  return {angle_between<double>(end.R_WB, p.end.R_WB), norm<double>(V(L - L_want)) / norm<double>(L0),
          std::fabs(kinetic(p, end) - kinetic(p, p.end)) / kinetic(p, p.start), norm<double>(V(end.p_WB - p.end.p_WB))};
}

}  // namespace rigor::studies
