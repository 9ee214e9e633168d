#include <algorithm>
#include <cmath>
#include <cstdio>
#include <rigor/grader/contacts.hpp>
#include <rigor/grader/picture.hpp>
#include <rigor/report/html.hpp>

namespace rigor::grader {
namespace {

using V = Vec3<double>;

std::string print(const char* format, double a, double b = 0, double c = 0, double d = 0) {
  char text[160];
  std::snprintf(text, sizeof text, format, a, b, c, d);
  return text;
}
V unit(const V& v) { return v / norm<double>(v); }

/// An orthographic view: `up` points up on the paper, tilted towards the reader so that one looks down on the scene.
class View {
 public:
  View(const V& up, const V& rightish, double yaw) {
    V r = rightish - dot<double>(rightish, up) * up;
    r = unit(r);
    const V depth = cross<double>(r, up);  // towards the reader
    right_ = std::cos(yaw) * r - std::sin(yaw) * depth;
    const V towards = std::sin(yaw) * r + std::cos(yaw) * depth;
    constexpr double tilt = 0.4;
    up_ = std::cos(tilt) * up - std::sin(tilt) * towards;
    reader_ = std::cos(tilt) * towards + std::sin(tilt) * up;
  }
  std::pair<double, double> at(const V& p) const { return {dot<double>(p, right_), -dot<double>(p, up_)}; }
  bool faces_reader(const V& normal) const { return dot<double>(normal, reader_) > 0; }

 private:
  V right_, up_, reader_;
};

/// Collects shapes in space; draws them when all are known, so that they fill the paper.
class Drawing {
 public:
  explicit Drawing(const View& view) : view_(view) {}

  void line(const V& a, const V& b, const std::string& style) { shapes_.push_back({{a, b}, style, "", Shape::Kind::line}); }
  void area(const std::vector<V>& corners, const std::string& style) { shapes_.push_back({corners, style, "", Shape::Kind::area}); }
  void dot_at(const V& a, const std::string& colour) { shapes_.push_back({{a}, "fill=\"" + colour + "\"", "", Shape::Kind::dot}); }
  void arrow(const V& a, const V& along, const std::string& colour, const std::string& name, bool dashed = false) {
    if (!(norm<double>(along) > 0)) return;
    shapes_.push_back({{a, V(a + along)}, "stroke=\"" + colour + "\" fill=\"" + colour + "\"" + (dashed ? " stroke-dasharray=\"5 4\"" : ""), name, Shape::Kind::arrow});
  }
  void label(const V& a, const std::string& name) { shapes_.push_back({{a}, "", name, Shape::Kind::label}); }

  /// A cuboid: faces towards the reader tinted, hidden edges dashed.
  void box(const Box& b, const std::string& colour) {
    const Mat3<double> R = b.R_WB();
    const auto corner = [&](int k) { return V(b.position + corner_W(b, k)); };
    bool front[3][2];
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side) {
        front[axis][side] = view_.faces_reader(V((side ? 1 : -1) * R.col(axis)));
        if (!front[axis][side]) continue;
        const int i = 1 << (axis + 1) % 3, j = 1 << (axis + 2) % 3, base = side << axis;
        area({corner(base), corner(base | i), corner(base | i | j), corner(base | j)}, "fill=\"" + colour + "\" fill-opacity=\"0.13\"");
      }
    for (int k = 0; k < 8; ++k)
      for (int axis = 0; axis < 3; ++axis) {
        if ((k >> axis & 1) != 0) continue;
        const int i = (axis + 1) % 3, j = (axis + 2) % 3;
        const bool hidden = !front[i][k >> i & 1] && !front[j][k >> j & 1];
        line(corner(k), corner(k | 1 << axis), "stroke=\"" + colour + "\"" + (hidden ? " stroke-width=\"1\" stroke-dasharray=\"3 3\" opacity=\"0.6\"" : " stroke-width=\"1.8\""));
      }
  }

  std::string svg(const std::string& title, const std::string& says) const {
    double low_x = 1e300, low_y = 1e300, high_x = -1e300, high_y = -1e300;
    for (const Shape& s : shapes_)
      for (const V& p : s.points) {
        const auto [x, y] = view_.at(p);
        low_x = std::min(low_x, x), high_x = std::max(high_x, x), low_y = std::min(low_y, y), high_y = std::max(high_y, y);
      }
    constexpr double width = 420, height = 320, margin = 34;
    const double scale = std::min((width - 2 * margin) / std::max(1e-9, high_x - low_x), (height - 2 * margin) / std::max(1e-9, high_y - low_y));
    const auto at = [&](const V& p) {
      const auto [x, y] = view_.at(p);
      return std::pair{width / 2 + scale * (x - (low_x + high_x) / 2), height / 2 + scale * (y - (low_y + high_y) / 2)};
    };
    std::string out = print("<svg role=\"img\" viewBox=\"0 0 %g %g\" width=\"%g\" height=\"%g\">", width, height, width, height) + "<title>" + report::escape(title) +
                      "</title><desc>" + report::escape(says) + "</desc>" + world_axes(height);
    for (const Shape& s : shapes_) out += drawn(s, at);
    return out + "</svg>";
  }

 private:
  struct Shape {
    std::vector<V> points;
    std::string style, name;
    enum class Kind { line, area, dot, arrow, label } kind;
  };

  static std::string name_at(double x, double y, const std::string& name, const std::string& anchor = "middle") {
    return name.empty() ? "" : print("<text class=\"name\" x=\"%.1f\" y=\"%.1f\" ", x, y + 4) + "text-anchor=\"" + anchor + "\">" + report::escape(name) + "</text>";
  }

  template <class At>
  static std::string drawn(const Shape& s, const At& at) {
    const auto [x, y] = at(s.points[0]);
    switch (s.kind) {
      case Shape::Kind::dot: return print("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4\" ", x, y) + s.style + "/>";
      case Shape::Kind::label: return name_at(x, y, s.name);
      case Shape::Kind::area: {
        std::string points;
        for (const V& p : s.points) points += print("%.1f,%.1f ", at(p).first, at(p).second);
        return "<polygon points=\"" + points + "\" " + s.style + "/>";
      }
      default: break;
    }
    const auto [x2, y2] = at(s.points[1]);
    const std::string stroke = print("<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" ", x, y, x2, y2) + s.style;
    if (s.kind == Shape::Kind::line) return stroke + "/>";
    const double length = std::hypot(x2 - x, y2 - y);
    if (length < 3) return print("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"5\" fill-opacity=\"0.2\" ", x, y) + s.style + "/>" + name_at(x + 14, y - 10, s.name);  // towards the reader, or away
    const double c = (x2 - x) / length, d = (y2 - y) / length, head = std::min(10.0, length / 2);
    return stroke + " stroke-width=\"2.4\"/>" + print("<polygon points=\"%.1f,%.1f ", x2, y2) + print("%.1f,%.1f ", x2 - head * c + head * 0.42 * d, y2 - head * d - head * 0.42 * c) +
           print("%.1f,%.1f\" ", x2 - head * c - head * 0.42 * d, y2 - head * d + head * 0.42 * c) + s.style + "/>" + name_at(x2 + 8 * c, y2 + 13 * d, s.name, c > 0.3 ? "start" : c < -0.3 ? "end" : "middle");
  }

  std::string world_axes(double height) const {
    std::string out;
    for (int k = 0; k < 3; ++k) {
      const auto [x, y] = view_.at(V::Unit(k));
      out += print("<line class=\"axis\" x1=\"40\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\"/>", height - 30, 40 + 20 * x, height - 30 + 20 * y) +
             print("<text class=\"soft\" x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\">", 40 + 27 * x, height - 26 + 27 * y) + "xyz"[k] + "</text>";
    }
    return out;
  }

  View view_;
  std::vector<Shape> shapes_;
};

// Arrows of one kind of quantity have lengths in proportion; the longest is as long as the largest body reaches.
struct ArrowScale {
  double scale = 0;
  ArrowScale(double length, std::initializer_list<V> all) {
    double most = 0;
    for (const V& v : all) most = std::max(most, norm<double>(v));
    if (most > 0) scale = length / most;
  }
  V operator()(const V& v) const { return V(scale * v); }
};

const std::string blue = "var(--s0)", orange = "var(--s1)", green = "var(--s2)", violet = "var(--s3)", ochre = "var(--s4)", teal = "var(--s5)", ink = "var(--ink)";

void edges(Drawing& d, const Box& b) {  // named by their numbers, on edges that meet in one corner
  const auto middle = [&](int k, int axis) { return V(b.position + (corner_W(b, k) + corner_W(b, k | 1 << axis)) / 2 * 1.16); };
  const char* names[] = {"w ", "h ", "d "};
  const int at[] = {4, 5, 1};
  for (int axis = 0; axis < 3; ++axis) d.label(middle(at[axis], axis), names[axis] + print("%.4g m", b.size[axis]));
}

std::string inertia(const Box& b, bool world) {
  Drawing d(View(V(0, 1, 0), V(1, 0, 0), 0.55));
  d.box(b, blue);
  const char* names[] = {"x of the body", "y of the body", "z of the body"};
  if (world)
    for (int k = 0; k < 3; ++k) d.arrow(b.position, V(0.95 * b.reach() * b.R_WB().col(k)), k == 0 ? orange : k == 1 ? green : violet, names[k]);
  else edges(d, b);
  const std::string says = world ? "The cuboid and its body axes; the small cross shows the world axes." : "The cuboid with its full edge lengths: width w along x, height h along y, depth d along z of the body.";
  return d.svg("The cuboid", says) + "<figcaption>" + says + "</figcaption>";
}

std::string forced(const Scenario& s, bool at_point) {
  Drawing d(View(V(0, 1, 0), V(1, 0, 0), 0.55));
  const double reach = s.A.reach();
  d.box(s.A, blue);
  const ArrowScale speed(reach, {s.A.velocity}), turn(reach, {s.A.spin});
  if (at_point) {
    d.arrow(s.A.position, V(s.point - s.A.position), ink, "", true);
    d.label(V((s.A.position + s.point) / 2), "r");
    d.arrow(s.point, ArrowScale(reach, {s.vector})(s.vector), orange, "f");
    d.dot_at(s.point, orange);
  } else {
    d.arrow(s.A.position, ArrowScale(reach, {s.A.force})(s.A.force), orange, "F");
    d.arrow(s.A.position, ArrowScale(reach, {s.A.torque})(s.A.torque), ochre, "τ");
    d.arrow(s.A.position, speed(s.A.velocity), teal, "v");
    d.arrow(s.A.position, turn(s.A.spin), violet, "ω");
  }
  d.dot_at(s.A.position, ink);
  const std::string says = at_point ? "The cuboid, the force f at its point, and the arm r from the centre of mass to that point."
                                    : "The cuboid with its velocity v, spin ω, net force F and net torque τ; what is zero is left out. Lengths of different quantities cannot be compared.";
  return d.svg(at_point ? "A force on the cuboid" : "The cuboid before the step", says) + "<figcaption>" + says + "</figcaption>";
}

std::string plane(const Scenario& s, const V& contact) {
  const V n = s.normal, side = std::fabs(n[0]) < 0.8 ? V(1, 0, 0) : V(0, 0, 1);
  Drawing d(View(n, side, 0.45));
  const double reach = s.A.reach();
  const V foot = s.A.position - dot<double>(V(s.A.position - s.plane_point), n) * n, a = unit(V(side - dot<double>(side, n) * n)), b = cross<double>(n, a);
  const double half = 1.25 * reach;
  d.area({V(foot + half * (a + b)), V(foot + half * (a - b)), V(foot - half * (a + b)), V(foot + half * (b - a))}, "fill=\"var(--s7)\" fill-opacity=\"0.16\" stroke=\"var(--soft)\"");
  d.box(s.A, blue);
  const V at_contact = point_velocity<double>(s.A.velocity, s.A.spin, V(contact - s.A.position));
  const ArrowScale speed(0.9 * reach, {s.A.velocity, at_contact}), turn(0.9 * reach, {s.A.spin});
  d.arrow(s.A.position, speed(s.A.velocity), teal, "v");
  d.arrow(s.A.position, turn(s.A.spin), violet, "ω");
  d.arrow(contact, V(0.7 * reach * n), green, "n");
  d.arrow(contact, speed(at_contact), orange, "v_c");
  d.arrow(s.A.position, ArrowScale(0.9 * reach, {s.A.force})(s.A.force), ochre, "F");
  d.dot_at(s.A.position, ink);
  d.dot_at(contact, orange);
  const std::string says = "The cuboid on the plane, drawn with the plane's normal n upwards; the contact (dot) with its velocity v_c, the velocity v of the centre and the spin ω. What is zero is left out.";
  return d.svg("The cuboid meets the plane", says) + "<figcaption>" + says + "</figcaption>";
}

std::string pair(const Scenario& s) {
  const V n = s.normal, up = std::fabs(n[1]) < 0.9 ? V(0, 1, 0) : V(0, 0, 1);
  Drawing d(View(up, n, 0.3));
  const double reach = std::max(s.A.reach(), s.B.reach());
  d.box(s.A, blue);
  d.box(s.B, orange);
  const ArrowScale speed(0.8 * reach, {s.A.velocity, s.B.velocity}), turn(0.8 * reach, {s.A.spin, s.B.spin});
  const std::pair<const Box*, const char*> bodies[] = {{&s.A, "₁"}, {&s.B, "₂"}};
  for (const auto& [b, index] : bodies) {
    d.arrow(b->position, speed(b->velocity), teal, std::string("v") + index);
    d.arrow(b->position, turn(b->spin), violet, std::string("ω") + index);
    d.line(b->position, s.point, "stroke=\"var(--soft)\" stroke-dasharray=\"5 4\"");
    if (norm<double>(V(b->position - s.point)) > 0) d.label(V((b->position + s.point) / 2), std::string("r") + index);
    d.dot_at(b->position, ink);
  }
  d.arrow(s.point, V(0.7 * reach * n), green, "n");
  d.dot_at(s.point, green);
  const std::string says = "Body 1 (blue) and body 2 (orange), the contact with the normal n from 1 to 2, the arms r to it, velocities and spins; what is zero is left out. The case is made as simple as it stays wrong, so the two need not touch.";
  return d.svg("Two cuboids meet", says) + "<figcaption>" + says + "</figcaption>";
}

}  // namespace

std::string picture(const Counterexample& e) {
  std::string inside;
  switch (e.function) {
    case Function::body_inertia: inside = inertia(e.inputs.A, false); break;
    case Function::world_inertia: inside = inertia(e.inputs.A, true); break;
    case Function::apply_force: inside = forced(e.inputs, true); break;
    case Function::update: inside = forced(e.inputs, false); break;
    case Function::friction_tangent:
    case Function::plane_response: inside = plane(e.inputs, contact_point(e)); break;
    case Function::pair_response: inside = pair(e.inputs); break;
    default: return "";
  }
  return "<figure class=\"case\">" + inside + "</figure>\n";
}

}  // namespace rigor::grader
