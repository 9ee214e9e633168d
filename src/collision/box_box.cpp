#include <algorithm>
#include <cmath>
#include <limits>
#include <rigor/collision/box_box.hpp>
#include <rigor/scalar/gamma.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;

// Both boxes seen from A: C = R_WAᵀ R_WB, t = R_WAᵀ (p_WB − p_WA), half edges.
struct Pair {
  Mat3<double> C;
  V t, half_A, half_B;
  double extent;  // sum of half edges and distance: the scale of every rounding error here

  Pair(const Cuboid<double>& A, const State<double>& a, const Cuboid<double>& B, const State<double>& b)
      : half_A(A.size() / 2), half_B(B.size() / 2) {
    for (int j = 0; j < 3; ++j) C.col(j) = apply_transposed<double>(a.R_WB, b.R_WB.col(j));
    t = apply_transposed<double>(a.R_WB, V(b.p_WB - a.p_WB));
    extent = half_A.sum() + half_B.sum() + norm<double>(t);
  }
};

// Gap along a unit axis given in A's axes, and the axis turned to point from A to B.
struct Axis {
  double gap;
  V n_A;
};
Axis along(const Pair& p, const V& n) {
  double reach = 0;
  for (int i = 0; i < 3; ++i) reach += std::fabs(n[i]) * p.half_A[i] + std::fabs(dot<double>(n, p.C.col(i))) * p.half_B[i];
  const double distance = dot<double>(n, p.t);
  return {std::fabs(distance) - reach, distance < 0 ? V(-n) : n};
}

struct Best {
  double gap = -std::numeric_limits<double>::infinity();
  V n_A = zero3<double>();
  int axis = -1;
};

Best best_axis(const Pair& p) {
  Best best;
  const auto offer = [&](const Axis& candidate, double slack, int axis) {
    if (candidate.gap > best.gap + slack) best = {candidate.gap, candidate.n_A, axis};
  };
  for (int i = 0; i < 3; ++i) offer(along(p, V(V::Unit(i))), 0, i);
  for (int j = 0; j < 3; ++j) offer(along(p, p.C.col(j)), 0, 3 + j);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const V edge = cross<double>(V(V::Unit(i)), p.C.col(j));
      const double sine = norm<double>(edge);
      if (sine < 1e-8) continue;
      Axis candidate = along(p, V(edge / sine));
      candidate.gap -= 8 * unit_roundoff<double>() * p.extent / sine;
      offer(candidate, 1e-9 * p.extent, 6 + 3 * i + j);
    }
  return best;
}

// A convex polygon, cut by half-spaces one after another (Sutherland and Hodgman); four sides and four cuts: at most 8.
struct Polygon {
  std::array<V, 16> at;
  int count = 0;

  void add(const V& point) { at[std::size_t(count++)] = point; }
  // Keeps sign · x[axis] ≤ limit.
  Polygon cut(int axis, double sign, double limit) const {
    Polygon kept;
    for (int k = 0; k < count; ++k) {
      const V &from = at[std::size_t(k)], &to = at[std::size_t((k + 1) % count)];
      const double d0 = sign * from[axis] - limit, d1 = sign * to[axis] - limit;
      if (d0 <= 0) kept.add(from);
      if ((d0 < 0 && d1 > 0) || (d0 > 0 && d1 < 0)) kept.add(V(from + d0 / (d0 - d1) * (to - from)));
    }
    return kept;
  }
};

// Reference box with half edges h, at the origin of its own axes; the other box by C (its axes), t (its centre).
// `face` and `out` say which face is the reference, `overlap` how deep the boxes overlap there. Points and depths go to the
// manifold through `place`.
template <class Place>
void clip_face(const V& h, const Mat3<double>& C, const V& t, const V& h_other, int face, double out, double overlap, Place place) {
  int incident = 0;  // the other box's face that looks most against the reference normal
  for (int j = 1; j < 3; ++j)
    if (std::fabs(C(face, j)) > std::fabs(C(face, incident))) incident = j;
  const double side = out * C(face, incident) > 0 ? -1 : 1;
  const int j1 = (incident + 1) % 3, j2 = (incident + 2) % 3;
  Polygon polygon;
  for (const auto& [s1, s2] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
    polygon.add(V(t + side * h_other[incident] * C.col(incident) + s1 * h_other[j1] * C.col(j1) + s2 * h_other[j2] * C.col(j2)));
  V deepest = polygon.at[0];  // edges that kiss: rounding may leave nothing of the face; then a corner of it, brought between the sides
  for (const int axis : {(face + 1) % 3, (face + 2) % 3}) {
    deepest[axis] = std::clamp(deepest[axis], -h[axis], h[axis]);
    for (const double sign : {1.0, -1.0}) polygon = polygon.cut(axis, sign, h[axis]);
  }
  double most = -std::numeric_limits<double>::infinity();
  for (int k = 0; k < polygon.count; ++k) {
    const V& point = polygon.at[std::size_t(k)];
    const double depth = h[face] - out * point[face];
    if (depth > 0) place(point, depth);
    if (depth > most) most = depth, deepest = point;
  }
  if (!(most > 0)) place(deepest, overlap);  // so little overlap that rounding clipped every point
}

// The middle of the shortest line between edge i of A and edge j of B that support the axis n (A's axes).
V edge_point(const Pair& p, const V& n, int i, int j) {
  V on_A = zero3<double>(), on_B = p.t;
  for (int k = 0; k < 3; ++k) {
    if (k != i) on_A[k] = n[k] > 0 ? p.half_A[k] : -p.half_A[k];
    if (k != j) on_B += (dot<double>(n, p.C.col(k)) > 0 ? -1 : 1) * p.half_B[k] * p.C.col(k);
  }
  const V u = V::Unit(i), v = p.C.col(j), w = on_B - on_A;
  const double c = u.dot(v), det = 1 - c * c;
  const double s = (u.dot(w) - c * v.dot(w)) / det, r = (c * u.dot(w) - v.dot(w)) / det;
  return V((on_A + s * u + on_B + r * v) / 2);
}

}  // namespace

V Manifold::centroid() const {
  V sum = zero3<double>();
  for (int k = 0; k < count; ++k) sum += points[std::size_t(k)].p_WC;
  return sum / count;
}

Separation separation(const Cuboid<double>& A, const State<double>& a, const Cuboid<double>& B, const State<double>& b) {
  const Best best = best_axis(Pair(A, a, B, b));
  return {best.gap, apply<double>(a.R_WB, best.n_A), best.axis};
}

Manifold box_box(const Cuboid<double>& A, const State<double>& a, const Cuboid<double>& B, const State<double>& b) {
  const Pair p(A, a, B, b);
  const Best best = best_axis(p);
  Manifold m;
  if (best.axis < 0 || !(best.gap < 0)) return m;  // no axis has a gap where the poses are no numbers
  m.n_AB_W = apply<double>(a.R_WB, best.n_A);
  m.depth = -best.gap;
  m.axis = best.axis;
  const auto add = [&](const V& p_WC, double depth) {
    if (m.count < 8) m.points[std::size_t(m.count++)] = {p_WC, depth};
  };
  if (best.axis < 3) {
    const double out = best.n_A[best.axis] > 0 ? 1 : -1;
    clip_face(p.half_A, p.C, p.t, p.half_B, best.axis, out, m.depth, [&](const V& x, double depth) {
      add(V(a.p_WB + apply<double>(a.R_WB, x) + depth / 2 * m.n_AB_W), depth);
    });
  } else if (best.axis < 6) {  // the same seen from B
    const int face = best.axis - 3;
    const V back = -apply_transposed<double>(p.C, p.t), n_B = apply_transposed<double>(p.C, best.n_A);
    clip_face(p.half_B, Mat3<double>(p.C.transpose()), back, p.half_A, face, n_B[face] > 0 ? -1 : 1, m.depth, [&](const V& x, double depth) {
      add(V(b.p_WB + apply<double>(b.R_WB, x) - depth / 2 * m.n_AB_W), depth);
    });
  } else {
    const int edges = best.axis - 6;
    add(V(a.p_WB + apply<double>(a.R_WB, edge_point(p, best.n_A, edges / 3, edges % 3))), m.depth);
  }
  return m;
}

}  // namespace rigor
