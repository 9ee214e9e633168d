#include <Eigen/Dense>
#include <cmath>
#include <reference/impacts.hpp>
#include <reference/sundials.hpp>
#include <reference/taylor.hpp>
#include <rigor/linalg/rotation.hpp>

namespace rigor::reference {
namespace {

using P = Precise;

// Central moments up to m/12, which a free body does not feel.
template <class T>
Vec3<T> moments(const Throw& scene) {
  const Vec3<T> s = scene.size.cast<T>();
  return Vec3<T>(s[1] * s[1] + s[2] * s[2], s[2] * s[2] + s[0] * s[0], s[0] * s[0] + s[1] * s[1]);
}
template <class T>
Thrown<T> flight(const Throw& scene, const Thrown<T>& from, const T& t, int order) {
  const auto a = taylor_free_body<T>(moments<T>(scene), Vec3<T>(from.R_WB.transpose() * from.w_WB), from.R_WB, t, order, 0.02);
  const Vec3<T> g = scene.gravity.cast<T>();
  Thrown<T> s;
  s.R_WB = a.R_WB;
  s.w_WB = a.R_WB * a.w_B;
  s.p_WB = from.p_WB + t * (from.v_WB + g * (t / T(2)));
  s.v_WB = from.v_WB + t * g;
  return s;
}

// The smallest distance of any corner from any wall: whose, and how far from the centre.
template <class T>
struct Lowest {
  T gap;
  std::size_t wall;
  Vec3<T> arm_W;
};
template <class T>
Lowest<T> lowest_corner(const Throw& scene, const Vec3<T>& p_WB, const Mat3<T>& R_WB) {
  Lowest<T> lowest{T(1e6), 0, Vec3<T>()};
  for (int k = 0; k < 8; ++k) {
    Vec3<T> r_B;
    for (int i = 0; i < 3; ++i) r_B[i] = T((k >> i) & 1 ? 0.5 : -0.5) * T(scene.size[i]);
    const Vec3<T> r_W = R_WB * r_B;
    for (std::size_t w = 0; w < scene.walls.size(); ++w) {
      const Vec3<T> n = scene.walls[w].normal.cast<T>(), d = p_WB + r_W - scene.walls[w].point.cast<T>();
      const T gap = n.dot(d);
      if (gap < lowest.gap) lowest = {gap, w, r_W};
    }
  }
  return lowest;
}
template <class T>
Lowest<T> lowest_corner(const Throw& scene, const Thrown<T>& s) {
  return lowest_corner<T>(scene, s.p_WB, s.R_WB);
}

template <class To, class From>
Thrown<To> cast(const Thrown<From>& s) {
  const auto number = [](const From& x) { return static_cast<To>(x); };
  return {s.p_WB.unaryExpr(number), s.v_WB.unaryExpr(number), s.w_WB.unaryExpr(number), s.R_WB.unaryExpr(number)};
}

}  // namespace

template <class T>
Thrown<T> struck(const Throw& scene, const Thrown<T>& before, const Vec3<double>& normal, const Vec3<T>& r) {
  const T e(scene.restitution), mu(scene.friction), m(scene.mass);
  const Vec3<T> n = normal.cast<T>(), I = moments<T>(scene) * (m / T(12));
  Mat3<T> inverse_I = Mat3<T>::Zero(), r_x = Mat3<T>::Zero();
  for (int k = 0; k < 3; ++k) {
    inverse_I += before.R_WB.col(k) * before.R_WB.col(k).transpose() / I[k];
    r_x((k + 1) % 3, (k + 2) % 3) = -r[k], r_x((k + 2) % 3, (k + 1) % 3) = r[k];
  }
  const Mat3<T> K = Mat3<T>(Mat3<T>::Identity() / m) - Mat3<T>(r_x * inverse_I * r_x);
  const Vec3<T> u = before.v_WB + before.w_WB.cross(r);
  const T u_n = u.dot(n);
  Vec3<T> j = n * (-(T(1) + e) * u_n / n.dot(Vec3<T>(K * n)));
  if (scene.friction > 0) {
    const Vec3<T> stick = -(K.inverse() * Vec3<T>(u + e * u_n * n));
    const T along = stick.dot(n);
    if (Vec3<T>(stick - along * n).norm() <= mu * along) {
      j = stick;
    } else {
      const Vec3<T> slip = u - u_n * n, push = n - slip * (mu / slip.norm());
      j = push * (-(T(1) + e) * u_n / n.dot(Vec3<T>(K * push)));
    }
  }
  Thrown<T> after = before;
  after.v_WB += j / m;
  after.w_WB += inverse_I * r.cross(j);
  return after;
}
template Thrown<double> struck<double>(const Throw&, const Thrown<double>&, const Vec3<double>&, const Vec3<double>&);
template Thrown<Precise> struck<Precise>(const Throw&, const Thrown<Precise>&, const Vec3<double>&, const Vec3<Precise>&);

Thrown<P> precise_flight(const Throw& scene, const Thrown<P>& from, const P& t) { return flight<P>(scene, from, t, 40); }

std::vector<WallImpact<P>> precise_impacts(const Throw& scene, Thrown<P> from, double until, std::size_t count) {
  std::vector<WallImpact<P>> seen;
  P now = 0;
  while (seen.size() < count && now < P(until)) {
    const double step = 1e-3;
    Thrown<double> rough = cast<double>(from);
    long steps = 0;
    do rough = flight<double>(scene, rough, step, 10), ++steps;
    while (lowest_corner<double>(scene, rough).gap > 0 && double(steps) * step < until);
    if (lowest_corner<double>(scene, rough).gap > 0) break;
    const P watched = P(steps - 1) * P(step);  // the last moment at which all was clear
    const Thrown<P> base = precise_flight(scene, from, watched);
    const auto gap = [&](const P& t) { return lowest_corner<P>(scene, precise_flight(scene, base, t)).gap; };
    P t0 = P(step), t1 = P(step) / 2, g0 = gap(t0), g1 = gap(t1);
    for (int k = 0; k < 12 && abs(g0) > P(1e-45); ++k) {
      const P next = t0 - g0 * (t0 - t1) / (g0 - g1);
      t1 = t0, g1 = g0;
      t0 = next, g0 = gap(t0);
    }
    const Thrown<P> there = precise_flight(scene, base, t0);
    const Lowest<P> corner = lowest_corner<P>(scene, there);
    now += watched + t0;
    from = struck<P>(scene, there, scene.walls[corner.wall].normal, corner.arm_W);
    seen.push_back({now, corner.wall, there, from});
  }
  return seen;
}

Outcome<std::vector<WallImpact<double>>> cvode_impacts(const Throw& scene, Thrown<double> from, double until, std::size_t count, double tolerance) {
  const Rhs turning = free_body_rhs(moments<double>(scene));
  const Rhs flying = [&](double t, std::span<const double> y, std::span<double> d) {  // y = (p, v, ω_B, q), q from the last impact on
    for (std::size_t i = 0; i < 3; ++i) d[i] = y[3 + i], d[3 + i] = scene.gravity[Eigen::Index(i)];
    turning(t, y.subspan(6), d.subspan(6));
  };
  std::vector<WallImpact<double>> seen;
  double now = 0;
  while (seen.size() < count && now < until) {
    const Vec3<double> w_B = from.R_WB.transpose() * from.w_WB;
    const auto state = [&](std::span<const double> y) {
      const Mat3<double> R = from.R_WB * rotation_of<double>(Vec4<double>(y[9], y[10], y[11], y[12]));
      return Thrown<double>{{y[0], y[1], y[2]}, {y[3], y[4], y[5]}, R * Vec3<double>(y[6], y[7], y[8]), R};
    };
    std::vector<double> y;
    for (const Vec3<double>& part : {from.p_WB, from.v_WB, w_B}) y.insert(y.end(), part.data(), part.data() + 3);
    y.insert(y.end(), {1, 0, 0, 0});
    const auto hit = first_fall(flying, [&](double, std::span<const double> at) { return lowest_corner<double>(scene, state(at)).gap; }, y, 0, until - now, tolerance);
    if (!hit && hit.fault().kind == Fault::Kind::out_of_range && hit.fault().where == "event") break;
    if (!hit) return hit.fault();
    const Thrown<double> there = state(hit->y);
    const Lowest<double> corner = lowest_corner<double>(scene, there);
    now += hit->t;
    from = struck<double>(scene, there, scene.walls[corner.wall].normal, corner.arm_W);
    seen.push_back({now, corner.wall, there, from});
  }
  return seen;
}

}  // namespace rigor::reference
