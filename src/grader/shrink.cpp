#include <cmath>
#include <rigor/grader/shrink.hpp>

namespace rigor::grader {
namespace {

using Change = std::function<void(Scenario&)>;

// Simplest first: a whole vector away, then one component away, then whole numbers, then one digit.
void add_vector(std::vector<Change>& list, Vec3<double>& (*field)(Scenario&)) {
  list.push_back([=](Scenario& s) { field(s) = zero3<double>(); });
  for (int i = 0; i < 3; ++i) list.push_back([=](Scenario& s) { field(s)[i] = 0; });
  for (const double unit : {1.0, 0.5}) {
    list.push_back([=](Scenario& s) {
      for (int i = 0; i < 3; ++i) field(s)[i] = unit * std::round(field(s)[i] / unit);
    });
    for (int i = 0; i < 3; ++i) list.push_back([=](Scenario& s) { field(s)[i] = unit * std::round(field(s)[i] / unit); });
  }
}
void add_box(std::vector<Change>& list, Box& (*box)(Scenario&)) {
  list.push_back([=](Scenario& s) { box(s).turn = Vec4<double>(1, 0, 0, 0); });
  for (int axis = 1; axis < 4; ++axis)  // a turn about one axis, with tangent 1/2 of the half angle
    list.push_back([=](Scenario& s) {
      box(s).turn = Vec4<double>(2, 0, 0, 0);
      box(s).turn[axis] = 1;
    });
  for (const double mass : {1.0, 2.0, 3.0}) list.push_back([=](Scenario& s) { box(s).mass = mass; });
  list.push_back([=](Scenario& s) { box(s).size = Vec3<double>(1, 2, 3); });
  list.push_back([=](Scenario& s) {
    for (int i = 0; i < 3; ++i) box(s).size[i] = std::fmax(1, std::round(box(s).size[i]));
  });
}

const std::vector<Change>& changes() {
  static const std::vector<Change> list = [] {
    std::vector<Change> all;
    add_box(all, [](Scenario& s) -> Box& { return s.A; });
    add_box(all, [](Scenario& s) -> Box& { return s.B; });
    add_vector(all, [](Scenario& s) -> Vec3<double>& { return s.A.force; });
    add_vector(all, [](Scenario& s) -> Vec3<double>& { return s.A.torque; });
    add_vector(all, [](Scenario& s) -> Vec3<double>& { return s.A.spin; });
    add_vector(all, [](Scenario& s) -> Vec3<double>& { return s.A.velocity; });
    add_vector(all, [](Scenario& s) -> Vec3<double>& { return s.B.spin; });
    add_vector(all, [](Scenario& s) -> Vec3<double>& { return s.B.velocity; });
    add_vector(all, [](Scenario& s) -> Vec3<double>& { return s.vector; });
    add_vector(all, [](Scenario& s) -> Vec3<double>& { return s.plane_point; });
    for (int axis = 0; axis < 3; ++axis)
      for (const double sign : {1.0, -1.0})
        all.push_back([=](Scenario& s) { s.normal = sign * Vec3<double>(Vec3<double>::Unit(axis)); });
    // positions only together with what is measured from them
    all.push_back([](Scenario& s) {
      const Vec3<double> shift = s.A.position;
      s.A.position -= shift, s.B.position -= shift, s.point -= shift, s.plane_point -= shift;
    });
    add_vector(all, [](Scenario& s) -> Vec3<double>& { return s.point; });
    add_vector(all, [](Scenario& s) -> Vec3<double>& { return s.B.position; });
    return all;
  }();
  return list;
}

// How hard a case is to read: 0 for a zero, more for more digits. Only a change that lowers it counts.
double effort(double x) {
  if (x == 0) return 0;
  if (std::fabs(x) == 1) return 1;
  if (x == std::round(x)) return std::fabs(x) <= 3 ? 1.5 : 2;
  return 2 * x == std::round(2 * x) ? 3 : 4;
}
double effort(const Scenario& s) {
  double sum = 0;
  const auto add = [&](const auto& v) {
    for (int i = 0; i < v.size(); ++i) sum += effort(v[i]);
  };
  for (const Box* b : {&s.A, &s.B}) {
    sum += effort(b->mass);
    add(b->size), add(b->turn), add(b->position), add(b->velocity), add(b->spin), add(b->force), add(b->torque);
  }
  add(s.normal), add(s.point), add(s.vector), add(s.plane_point);
  return sum;
}

}  // namespace

Scenario shrink(const Check& check, const Scenario& failing, const std::function<bool(const Scenario&)>& fails, int calls) {
  Scenario best = failing;
  for (bool again = true; again && calls > 0;) {
    again = false;
    for (const Change& change : changes()) {
      if (calls <= 0) break;
      Scenario simpler = best;
      change(simpler);
      check.renew(simpler);
      if (!(effort(simpler) < effort(best)) || !usable(check, simpler)) continue;
      --calls;
      if (fails(simpler)) {
        best = simpler;
        again = true;
      }
    }
  }
  return best;
}

}  // namespace rigor::grader
