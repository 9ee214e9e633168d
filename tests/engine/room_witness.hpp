#pragma once
// One tumbling cuboid in the assignment's room from impact to impact, in 60 digits from end to end: attitude by the Taylor
// series, the parabola, corner distances, roots by the secant rule, Newton's restitution with Coulomb friction. Shares no
// formula with the engine and nothing of its search: the planes are watched at moments 1 ms apart (in double).
#include <Eigen/Dense>
#include <cmath>
#include <reference/taylor.hpp>
#include <rigor/scene/simulate.hpp>
#include <vector>

namespace rigor::witness {

using P = reference::Precise;

template <class T>
struct Body {
  Vec3<T> p, v, w;  // world axes
  Mat3<T> R;
};
struct Impact {
  P t;
  std::size_t plane;
  Body<P> before, after;
};

/// The assignment's room with one cuboid thrown into it.
inline Scene room(double e, double mu) {
  Scene s = builtin_scene("assignment", 1);
  s.method = "located";
  s.surface = *Surface<double>::make(e, mu, mu);
  s.friction_law = FrictionLaw::coulomb;
  State<double> start;
  start.p_WB = Vec3<double>(0.5, 2.5, -1);
  start.R_WB = Mat3<double>::Identity();
  start.v_WB = Vec3<double>(12, 3, -15);
  start.w_WB = Vec3<double>(2, -3, 1);
  s.bodies = {{*Cuboid<double>::make(2, {0.5, 0.75, 1.25}), start}};
  s.until = 20;
  s.every = 20;
  return s;
}

template <class To, class From>
Vec3<To> cast(const Vec3<From>& a) {
  return Vec3<To>(To(a[0]), To(a[1]), To(a[2]));
}
template <class T>
Body<T> fly(const Scene& scene, const Body<T>& from, const T& t, int order) {
  Vec3<T> size, I;
  for (int k = 0; k < 3; ++k) size[k] = T(scene.bodies[0].shape.size()[k]);
  for (int k = 0; k < 3; ++k) I[k] = size[(k + 1) % 3] * size[(k + 1) % 3] + size[(k + 2) % 3] * size[(k + 2) % 3];  // up to a factor, which a free body does not feel
  const auto a = reference::taylor_free_body<T>(I, Vec3<T>(from.R.transpose() * from.w), from.R, t, order, 0.02);
  const Vec3<T> g = scene.gravity.cast<T>();
  Body<T> s;
  s.R = a.R_WB;
  s.w = a.R_WB * a.w_B;
  for (int i = 0; i < 3; ++i) s.p[i] = from.p[i] + t * (from.v[i] + t * g[i] / T(2)), s.v[i] = from.v[i] + t * g[i];
  return s;
}
template <class T>
Vec3<T> corner_arm(const Scene& scene, const Body<T>& s, int k) {
  Vec3<T> r_B;
  for (int i = 0; i < 3; ++i) r_B[i] = T((k >> i) & 1 ? 0.5 : -0.5) * T(scene.bodies[0].shape.size()[i]);
  return s.R * r_B;
}
/// The smallest distance of any corner from any plane: whose, and from which.
template <class T>
T lowest_gap(const Scene& scene, const Body<T>& s, std::size_t& plane, int& corner) {
  T lowest = T(1000);
  for (std::size_t q = 0; q < scene.planes.size(); ++q)
    for (int k = 0; k < 8; ++k) {
      const Vec3<T> n = scene.planes[q].normal().cast<T>(), at = scene.planes[q].point().cast<T>();
      const T gap = n.dot(Vec3<T>(s.p + corner_arm<T>(scene, s, k) - at));
      if (gap < lowest) lowest = gap, plane = q, corner = k;
    }
  return lowest;
}

/// Newton's restitution with Coulomb friction at a point: stick if the cone of mu allows it, else slide.
inline void strike(const Scene& scene, Body<P>& s, std::size_t plane, const Vec3<P>& r) {
  const double e = scene.surface.restitution(), mu = scene.surface.dynamic_friction();
  const Vec3<P> n = scene.planes[plane].normal().cast<P>(), size = scene.bodies[0].shape.size().cast<P>();
  const P m = scene.bodies[0].shape.mass();
  Mat3<P> inverse_I = Mat3<P>::Zero(), r_x = Mat3<P>::Zero();
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    inverse_I += s.R.col(k) * s.R.col(k).transpose() * (P(12) / (m * (size[i] * size[i] + size[j] * size[j])));
    r_x(i, j) = -r[k], r_x(j, i) = r[k];
  }
  const Mat3<P> K = Mat3<P>(Mat3<P>::Identity() / m) - Mat3<P>(r_x * inverse_I * r_x);
  const Vec3<P> u = s.v + s.w.cross(r);
  const P u_n = u.dot(n);
  Vec3<P> j = n * (-(1 + P(e)) * u_n / n.dot(Vec3<P>(K * n)));
  if (mu > 0) {
    const Vec3<P> stick = -(K.inverse() * Vec3<P>(u + P(e) * u_n * n));
    const P along = stick.dot(n);
    if (Vec3<P>(stick - along * n).norm() <= P(mu) * along) {
      j = stick;
    } else {
      const Vec3<P> slip = u - u_n * n, push = n - slip * (P(mu) / slip.norm());
      j = push * (-(1 + P(e)) * u_n / n.dot(Vec3<P>(K * push)));
    }
  }
  s.v += j / m;
  s.w += inverse_I * r.cross(j);
}

/// The first impacts, from a start in 60 digits.
inline std::vector<Impact> impacts(const Scene& scene, Body<P> s, std::size_t count) {
  std::vector<Impact> seen;
  P now = 0;
  while (seen.size() < count && now < P(scene.until)) {
    Body<double> rough{cast<double>(s.p), cast<double>(s.v), cast<double>(s.w), {}};
    for (int i = 0; i < 9; ++i) rough.R(i / 3, i % 3) = double(s.R(i / 3, i % 3));
    const double step = 1e-3;
    std::size_t plane = 0;
    int corner = 0;
    double t = 0;
    do rough = fly<double>(scene, rough, step, 10), t += step;
    while (lowest_gap<double>(scene, rough, plane, corner) > 0 && t < scene.until);
    const P watched = P(t) - P(step);  // the last moment at which all was clear
    const Body<P> base = fly<P>(scene, s, watched, 40);
    Body<P> there;
    const auto gap = [&](const P& at) { return there = fly<P>(scene, base, at, 40), lowest_gap<P>(scene, there, plane, corner); };
    P t0 = P(step), t1 = P(step) / 2, g1 = gap(t1), g0 = gap(t0);
    for (int k = 0; k < 12 && abs(g0) > P(1e-45); ++k) {
      const P next = t0 - g0 * (t0 - t1) / (g0 - g1);
      t1 = t0, g1 = g0;
      t0 = next, g0 = gap(t0);
    }
    now += watched + t0;
    seen.push_back({now, plane, there, there});
    strike(scene, seen.back().after, plane, corner_arm<P>(scene, there, corner));
    s = seen.back().after;
  }
  return seen;
}
inline Body<P> start_of(const Scene& scene) {
  const State<double>& s = scene.bodies[0].start;
  return {s.p_WB.cast<P>(), s.v_WB.cast<P>(), s.w_WB.cast<P>(), s.R_WB.cast<P>()};
}

}  // namespace rigor::witness
