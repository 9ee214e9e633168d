#include <cmath>
#include <map>
#include <reference/loaded_body.hpp>
#include <reference/taylor.hpp>
#include <rigor/base/promise.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/studies/cell.hpp>
#include <rigor/studies/table.hpp>

namespace rigor::studies {
namespace {

using P = reference::Precise;
using V = Vec3<double>;

std::string thirty(const P& x) { return x.str(30, std::ios_base::scientific); }

// The lines of a table: a case is its stratum and its number there.
class Lines {
 public:
  explicit Lines(const std::string& head) : text_(head) {}
  void begin(const std::string& stratum) { text_ += stratum + "-" + std::to_string(++counts_[stratum]) + "," + stratum; }
  void put(double x) { text_ += "," + digits(x); }
  void put(const V& x) {
    for (int i = 0; i < 3; ++i) put(x[i]);
  }
  void put(const P& x) { text_ += "," + thirty(x); }
  void put(const Vec3<P>& x) {
    for (int i = 0; i < 3; ++i) put(x[i]);
  }
  void put(const Mat3<P>& R) {  // as a quaternion, w >= 0
    const Vec4<P> q = quaternion_of<P>(R);
    for (int i = 0; i < 4; ++i) put(q[i]);
  }
  void end() { text_ += "\n"; }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::map<std::string, int> counts_;
};

struct Flight {
  const char* stratum;
  V inertia, w_B;   // kg m^2, rad/s; exact in binary
  double t;         // s
};

// Every stratum is one kind of difficulty; every number a multiple of a power of two.
std::vector<Flight> flights() {
  std::vector<Flight> all;
  const V bodies[] = {{1, 1.25, 1.5}, {0.5, 1.5, 1.75}, {2, 3, 4.5}, {0.125, 1, 1.0625}};
  for (int k = 0; k < 8; ++k) all.push_back({"generic", bodies[k % 4], V(1 + 0.25 * k, -0.75 + 0.5 * (k % 3), 0.5 - 0.125 * k), 1 + 0.5 * k});
  for (int k = 0; k < 6; ++k) all.push_back({"separatrix", bodies[k % 4], V(std::ldexp(1, -10 - 4 * k), 2, std::ldexp(1, -12 - 4 * k)), 4.0 + k});
  for (int k = 0; k < 6; ++k) all.push_back({"plate", V(1, 1 + std::ldexp(1, -4 - 3 * k), 2), V(0.5, 1 + 0.25 * k, 0.25), 3});           // I1 + I2 = I3, nearly a disc
  for (int k = 0; k < 4; ++k) all.push_back({"needle", V(std::ldexp(1, -8 - 2 * k), 1, 1.0009765625), V(4, 0.5, -0.25), 3});
  for (int k = 0; k < 6; ++k) all.push_back({"symmetric", k % 2 == 0 ? V(1, 1, 1.5) : V(0.5, 1.25, 1.25), V(1, -0.5 + 0.25 * k, 2), 4});
  for (int k = 0; k < 2; ++k) all.push_back({"sphere", V(1, 1, 1), V(1, 2 - k, -2), 5});
  for (int k = 0; k < 6; ++k) all.push_back({"near-axis", bodies[k % 4], k % 2 == 0 ? V(3, std::ldexp(1, -20), std::ldexp(1, -18)) : V(std::ldexp(1, -20), std::ldexp(1, -16), 3), 5});
  for (int k = 0; k < 4; ++k) all.push_back({"fast", bodies[k], V(700 - 100 * k, 300, -500), 0.03125});
  for (int k = 0; k < 4; ++k) all.push_back({"slow", bodies[k], V(std::ldexp(3, -10), std::ldexp(5, -10), std::ldexp(-7, -10)), 256});
  for (int k = 0; k < 3; ++k) all.push_back({"long", bodies[k], V(1, 0.5, -0.75), 64});
  return all;
}

const V bodies[] = {{1, 1.25, 1.5}, {0.5, 1.5, 1.75}, {2, 3, 4.5}, {0.75, 1, 1.125}};

struct Loaded {
  const char* stratum;
  V inertia, w_B, arm, tau, push;
  double rate, t;
};
std::vector<Loaded> loaded_flights() {
  std::vector<Loaded> all;
  const V none(0, 0, 0);
  for (int k = 0; k < 4; ++k) all.push_back({"axial", k % 2 == 0 ? V(1, 1, 1.5) : V(1.25, 1.25, 0.5), V(0.5, -0.25, 1 + 0.25 * k), none, V(0, 0, 0.75 - 0.5 * k), none, 0, 2.0 + 0.5 * k});
  for (int k = 0; k < 4; ++k) all.push_back({"body-torque", bodies[k], V(0.5, 1, -0.25 * k), none, V(0.25, -0.5, 0.125 + 0.25 * k), none, 0, 2});
  // the axis lies level at the start; steady or not, I1 stands alone
  for (int k = 0; k < 4; ++k) all.push_back({"lagrange", k % 2 == 0 ? V(0.5, 1, 1) : V(1.5, 1, 1), V(8 - k, 0, 0.25 * k), V(2, 0, 0), none, none, 0, 2});
  for (int k = 0; k < 4; ++k) all.push_back({"kovalevskaya", V(2, 2, 1), V(0.5 + 0.25 * k, -1.25, 2 - 0.5 * k), V(1.5, 0, 0), none, none, 0, 3});
  for (int k = 0; k < 4; ++k) all.push_back({"goryachev", V(4, 4, 1), V(0.5 + 0.25 * k, 1.25 - 0.5 * k, 0), V(1.5 + 0.5 * k, 0, 0), none, none, 0, 3});  // w3 = 0: L is level
  for (int k = 0; k < 4; ++k) all.push_back({"top", bodies[k], V(1, -0.5 * k, 2), V(0.5, 0.25, -0.75 + 0.5 * k), none, none, 0, 3});
  for (int k = 0; k < 4; ++k) all.push_back({"forced", bodies[k], V(0.25 * k, 1, -0.5), none, none, V(1, -0.5, 0.25), 0.5 + 0.5 * k, 2});
  for (int k = 0; k < 4; ++k) all.push_back({"all", bodies[k], V(1, 0.5, -1), V(0.25, -0.5, 0.5), V(0.125, 0, -0.25 * k), V(0.5, 0.25, -1), 1 + k * 0.25, 3});
  return all;
}

struct Thrown {
  const char* stratum;
  double mass;
  V size;
  double height;
  V v, w_B;
  double g, e;
};
std::vector<Thrown> throws() {
  std::vector<Thrown> all;
  const V sizes[] = {{0.5, 0.25, 1}, {1, 0.5, 0.75}, {0.25, 1, 0.5}, {0.75, 0.75, 0.75}};
  for (int k = 0; k < 4; ++k) all.push_back({"generic", 1 + 0.5 * k, sizes[k], 2, V(0.5, 1 - 0.5 * k, -0.25), V(1, -2 + k, 0.75), 9.8125, 0.25 * k});
  for (int k = 0; k < 4; ++k) all.push_back({"needle", 2, V(0.0625, 1 + 0.25 * k, 0.0625), 1.5 + 0.5 * k, V(0, 1, 0), V(0.5, 0.25, 3 + k), 9.8125, 0.5});
  for (int k = 0; k < 4; ++k) all.push_back({"plate", 1, V(1, 0.03125, 0.75), 1.0 + k, V(0.25, 0, 1), V(2 + k, -1, 1.5), 9.8125, 0.75});
  for (int k = 0; k < 4; ++k) all.push_back({"long", 3, sizes[k], 16, V(1, 8, 0), V(0.75, 4 + k, -0.5), 9.8125, 0.5});
  for (int k = 0; k < 4; ++k) all.push_back({"fast", 1, sizes[k], 1.5, V(0, -2, 1), V(20, -30 + 5 * k, 10), 9.8125, 1 - 0.25 * k});
  for (int k = 0; k < 4; ++k) all.push_back({"weightless", 1, sizes[k], 1.25, V(0.5, -0.5, 0), V(1, 0.5, -0.75 + 0.5 * k), 0, 0.5});
  return all;
}

// A cuboid over the plane y = 0, in 60 digits.
struct Above {
  Vec3<P> half, I, w;
  Mat3<P> R;
  P y, vy, g;

  Above later(const P& t) const {
    Above s = *this;
    const auto turned = reference::taylor_free_body<P>(I, w, R, t, 40, 0.02 / std::fmax(1, double(w.norm())));
    s.R = turned.R_WB, s.w = turned.w_B;
    s.y = y + t * (vy - g * t / 2), s.vy = vy - g * t;
    return s;
  }
  Vec3<P> lowest() const {  // corner, body axes
    Vec3<P> c;
    for (int i = 0; i < 3; ++i) c[i] = R(1, i) > 0 ? P(-half[i]) : half[i];
    return c;
  }
  P gap() const { return y + Vec3<P>(R * lowest())[1]; }
};

std::string free_flight_table() {
  Lines lines(
      "# Torque-free rotation, 30 digits. Attitude at t = 0 is the identity; q body to world, qw >= 0; I and w in body axes, SI units.\n"
      "# Inputs exact in binary. Taylor series of order 40 in 60 digits, own error below 1e-40. Written by: rigor check-table --write DIR\n"
      "case,stratum,I1,I2,I3,w1,w2,w3,t,qw,qx,qy,qz,wx,wy,wz\n");
  for (const Flight& f : flights()) {
    const auto end = reference::taylor_free_body<P>({f.inertia, f.w_B, identity3<double>()}, P(f.t), 40, 0.02 / std::fmax(1, norm<double>(f.w_B)));
    lines.begin(f.stratum);
    lines.put(f.inertia), lines.put(f.w_B), lines.put(f.t);
    lines.put(end.R_WB), lines.put(end.w_B);
    lines.end();
  }
  return lines.text();
}

std::string loaded_flight_table() {
  Lines lines(
      "# Rotation under torques, 30 digits: I w' = Iw x w + tau - arm x R^T(0,0,1) + R^T push cos(rate t), all but push in body axes, SI units: a\n"
      "# weight of 1 N on an arm, a torque held in the body, one that comes and goes in the world. Attitude at t = 0 is the identity; q body to world, qw >= 0.\n"
      "# Inputs exact in binary. Taylor series of order 28 in 60 digits, own error below 1e-31. Written by: rigor check-table --write DIR\n"
      "case,stratum,I1,I2,I3,w1,w2,w3,arm1,arm2,arm3,tau1,tau2,tau3,push1,push2,push3,rate,t,qw,qx,qy,qz,wx,wy,wz\n");
  for (const Loaded& f : loaded_flights()) {
    const double step = f.stratum == std::string("lagrange") ? 0.01 : 0.02;  // it spins fast
    const auto end = reference::taylor_loaded_body({{f.inertia, f.w_B, identity3<double>()}, f.arm, f.tau, f.push, f.rate}, f.t, 28, step);
    lines.begin(f.stratum);
    for (const V& x : {f.inertia, f.w_B, f.arm, f.tau, f.push}) lines.put(x);
    lines.put(f.rate), lines.put(f.t);
    lines.put(end.R_WB), lines.put(end.w_B);
    lines.end();
  }
  return lines.text();
}

std::string impact_table() {
  Lines lines(
      "# First impact of a cuboid of even density, sides size, on the plane y = 0, 30 digits. At t = 0 its attitude is the identity, its centre at (0, height, 0),\n"
      "# v in world axes, w in body axes; gravity g along -y. At `time` one corner touches and takes an impulse along +y, without friction, that turns its\n"
      "# approach into e times as fast a leaving. q body to world then, qw >= 0; w (body axes) and v of the centre after it. SI units.\n"
      "# Inputs exact in binary. Taylor series of order 40 in 60 digits, root to 1e-45, own error below 1e-38. Written by: rigor check-table --write DIR\n"
      "case,stratum,mass,size1,size2,size3,height,v1,v2,v3,w1,w2,w3,g,e,time,qw,qx,qy,qz,wx,wy,wz,vx,vy,vz\n");
  for (const Thrown& f : throws()) {
    Above s;
    const P m(f.mass);
    for (int i = 0; i < 3; ++i) {
      const P b(f.size[(i + 1) % 3]), c(f.size[(i + 2) % 3]);
      s.half[i] = P(f.size[i]) / 2, s.I[i] = m * (b * b + c * c) / 12, s.w[i] = f.w_B[i];
    }
    s.R = Mat3<P>::Identity();
    s.y = f.height, s.vy = f.v[1], s.g = f.g;
    // up to the step in which it touches, then the secant rule
    const P stride("0.0078125");
    P t = 0;
    for (Above next = s.later(stride); next.gap() > 0; next = s.later(stride)) {
      s = next, t += stride;
      promise(t < 60, "a thrown body of the table comes down");
    }
    P x0 = 0, x1 = stride, g0 = s.gap(), g1 = s.later(x1).gap();
    for (int n = 0; n < 40 && abs(g1) > P("1e-48") && g1 != g0; ++n) {
      const P x2 = x1 - g1 * (x1 - x0) / (g1 - g0);
      x0 = x1, g0 = g1, x1 = x2, g1 = s.later(x1).gap();
    }
    promise(abs(g1) < P("1e-45"), "the secant rule finds the touch");
    const Above at = s.later(x1);
    for (int i = 0; i < 3; ++i) promise(abs(at.R(1, i)) * at.half[i] > P("1e-6"), "one corner alone touches");
    const Vec3<P> r = at.lowest(), n = at.R.row(1).transpose();  // body axes
    const auto across = [](const Vec3<P>& a, const Vec3<P>& b) { return Vec3<P>(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]); };
    const Vec3<P> arm = across(r, n), kick = arm.cwiseQuotient(at.I);
    const P approach = at.vy + across(at.w, r).dot(n);
    promise(approach < 0, "the corner comes down");
    const P j = -(1 + P(f.e)) * approach / (1 / m + arm.dot(kick));
    lines.begin(f.stratum);
    lines.put(f.mass), lines.put(f.size), lines.put(f.height), lines.put(f.v), lines.put(f.w_B), lines.put(f.g), lines.put(f.e);
    lines.put(P(t + x1)), lines.put(at.R), lines.put(Vec3<P>(at.w + j * kick));
    lines.put(P(f.v[0])), lines.put(P(at.vy + j / m)), lines.put(P(f.v[2]));
    lines.end();
  }
  return lines.text();
}

}  // namespace

const std::vector<FrozenTable>& frozen_tables() {
  static const std::vector<FrozenTable> all{{"free-flight", free_flight_table}, {"loaded-flight", loaded_flight_table}, {"impacts", impact_table}};
  return all;
}

}  // namespace rigor::studies
