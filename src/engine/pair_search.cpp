#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <rigor/engine/first_root.hpp>
#include <rigor/engine/pair_search.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;
constexpr double infinity = std::numeric_limits<double>::infinity(), u = 0x1p-53;
constexpr long most_advances = 100000;

struct Moving {
  State<double> s;
  V half;                       // m
  std::array<V, 3> axis, turn;  // body axes in the world, and their rates ω × axis
  explicit Moving(const Cuboid<double>& shape, const State<double>& state) : s(state), half(shape.size() / 2) {
    for (int i = 0; i < 3; ++i) {
      axis[std::size_t(i)] = s.R_WB.col(i);
      turn[std::size_t(i)] = cross<double>(s.w_WB, axis[std::size_t(i)]);
    }
  }
  /// N·(arm) and its rate for corner k when N turns with rate N1.
  void corner(int k, const V& N, const V& N1, double& value, double& rate) const {
    value = rate = 0;
    for (int i = 0; i < 3; ++i) {
      const double h = k >> i & 1 ? half[i] : -half[i];
      value += h * dot<double>(N, axis[std::size_t(i)]);
      rate += h * (dot<double>(N1, axis[std::size_t(i)]) + dot<double>(N, turn[std::size_t(i)]));
    }
  }
};

struct Bounds {
  double N1, N2, D, V, rest;  // of the docstring; `rest` is Ω_A + Ω_B + |Δa|
  double longest;             // D and V hold for this long
};

/// How long the two stay apart along the axis N, as far as the bounds can tell; 0 when they touch and approach there.
double safe_along(const Moving& A, const Moving& B, const V& N, const V& N1, const Bounds& bounds, double rounding, bool& touching) {
  const V d = B.s.p_WB - A.s.p_WB, d1 = B.s.v_WB - A.s.v_WB;
  const double between = dot<double>(N, d), between_rate = dot<double>(N1, d) + dot<double>(N, d1);
  const double c = -(bounds.N2 * bounds.D + 2 * bounds.N1 * bounds.V + bounds.rest);
  std::array<double, 8> a, a1, b, b1;
  double lowest = infinity, highest = -infinity;
  for (int k = 0; k < 8; ++k) {
    A.corner(k, N, N1, a[std::size_t(k)], a1[std::size_t(k)]);
    B.corner(k, N, N1, b[std::size_t(k)], b1[std::size_t(k)]);
    lowest = std::fmin(lowest, b[std::size_t(k)]);
    highest = std::fmax(highest, a[std::size_t(k)]);
  }
  if (between + lowest - highest < -rounding) return 0;  // no separating axis
  double safe = bounds.longest;
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t j = 0; j < 8; ++j) {
      const double gap = between + b[j] - a[i], rate = between_rate + b1[j] - a1[i];
      if (gap <= rounding && rate < 0) touching = true;
      safe = std::fmin(safe, first_root(gap <= rounding ? 0 : gap, rate, c));
    }
  return safe;
}

}  // namespace

double touching_gap(const Cuboid<double>& A, const State<double>& a, const Cuboid<double>& B, const State<double>& b) {
  double terms = norm<double>(V(b.p_WB - a.p_WB)) + norm<double>(A.size()) / 2 + norm<double>(B.size()) / 2;
  for (int i = 0; i < 3; ++i) terms += std::fabs(a.p_WB[i]) + std::fabs(b.p_WB[i]);
  return 16 * u * terms;
}

PairContact next_pair_contact(const Cuboid<double>& A, const Flight& flight_A, double since_A, const Cuboid<double>& B, const Flight& flight_B,
                              double since_B, double from, double limit, double slack) {
  const double r_A = norm<double>(A.size()) / 2, r_B = norm<double>(B.size()) / 2, W_A = flight_A.spin_bound(), W_B = flight_B.spin_bound();
  const double pull = norm<double>(V(flight_B.acceleration() - flight_A.acceleration()));
  const double k = 1 + 1 / std::sqrt(3.0), thinnest = std::min(A.size().minCoeff(), B.size().minCoeff());
  PairContact found;
  double t = from;
  for (;;) {
    const Moving a(A, flight_A.at(since_A + t)), b(B, flight_B.at(since_B + t));
    const V d = b.s.p_WB - a.s.p_WB, v = b.s.v_WB - a.s.v_WB;
    const double distance = norm<double>(d), speed = norm<double>(v);
    double safe = 0;
    bool touching = false;
    const auto rounded_at = [&](double time) { return flight_A.rounding(since_A + time) + flight_B.rounding(since_B + time) + slack; };
    const double rounded = rounded_at(t), R = r_A + r_B + rounded, clear = distance - R;
    if (clear > 0) {  // the spheres around them: exact when both fall alike
      if (pull == 0) {
        // |d×v| and not the squares of d·v and of |d| |v|, whose difference is lost where they come from 1e8 sizes away
        const double approach = -dot<double>(d, v), past = norm<double>(cross<double>(d, v)), half_chord = (speed * R - past) * (speed * R + past);
        const double nearest = approach / speed / speed;
        if (approach > 0 && half_chord >= 0) safe = clear * (distance + R) / (approach + std::sqrt(half_chord));
        else if (approach > 0 && past < speed * (r_A + r_B + rounded_at(t + nearest))) safe = nearest / 2;  // by then it may not be known that they miss
        else safe = infinity;
      } else {
        safe = first_root(clear, -speed, -pull);
      }
    }
    if (!(safe > 0) && rounded > thinnest / 2) return {PairContact::Kind::blurred, t, found.advances};
    if (!(safe > 0) || safe < 0.05 * (r_A + r_B) / (speed + W_A * r_A + W_B * r_B)) {
      const double fastest = speed + W_A * r_A + W_B * r_B;
      // D and V must hold during the whole advance: it is cut where the distance could have grown by half the sizes
      const double longest = first_root((r_A + r_B) / 2, -fastest, -pull);
      const double V_bound = fastest + pull * longest, D = distance + 1.5 * (r_A + r_B);
      const double rounding = touching_gap(A, a.s, B, b.s) + slack;
      const double rest = flight_A.acceleration_bound(r_A) + flight_B.acceleration_bound(r_B) + pull;
      double best = 0;
      bool best_touches = false;
      const auto try_axis = [&](V N, V N1, const Bounds& bounds) {
        const double scale = norm<double>(N);
        if (scale < 1e-8) return;  // parallel edges: a face axis says the same
        if (dot<double>(N, d) < 0) N = -N, N1 = -N1;
        bool touches = false;
        const double along = safe_along(a, b, N, N1, bounds, rounding * scale, touches);
        if (along > best || (along == best && touches)) best = along, best_touches = touches;
      };
      for (std::size_t i = 0; i < 3; ++i) {
        try_axis(a.axis[i], a.turn[i], {W_A, k * W_A * W_A, D, V_bound, rest, longest});
        try_axis(b.axis[i], b.turn[i], {W_B, k * W_B * W_B, D, V_bound, rest, longest});
      }
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          try_axis(cross<double>(a.axis[i], b.axis[j]), V(cross<double>(a.turn[i], b.axis[j]) + cross<double>(a.axis[i], b.turn[j])),
                   {W_A + W_B, k * W_A * W_A + 2 * W_A * W_B + k * W_B * W_B, D, V_bound, rest, longest});
      if (best > safe) safe = best;
      touching = best_touches && t + safe <= t * (1 + 4 * u);
      if (safe == 0 || touching) return {PairContact::Kind::touch, t, found.advances};
    }
    if (!(safe <= limit - t)) return {PairContact::Kind::none, limit, found.advances};
    t = t + safe > t ? t + safe : std::nextafter(t, infinity);
    if (++found.advances > most_advances) return {PairContact::Kind::endless, t, found.advances};
  }
}

AxisBox swept_box(const Flight& flight, double radius, double from, double to, double t) {
  const V &p = flight.start().p_WB, &v = flight.start().v_WB, &a = flight.acceleration();
  AxisBox box;
  double places = 0;
  for (int k = 0; k < 3; ++k) {
    const auto at = [&](double tau) { return p[k] + tau * (v[k] + tau / 2 * a[k]); };
    const double first = at(from), last = at(to), turns = a[k] == 0 ? from : -v[k] / a[k];
    box.low[k] = std::fmin(first, last), box.high[k] = std::fmax(first, last);
    if (from < turns && turns < to) box.low[k] = std::fmin(box.low[k], at(turns)), box.high[k] = std::fmax(box.high[k], at(turns));
    places += std::fmax(std::fabs(box.low[k]), std::fabs(box.high[k]));
  }
  const double late = 8 * u * (std::fabs(t) + to);  // a time in double is off by no more
  const double reach = radius * 1.001 + 1e-12 * places + flight.rounding(to) + late * (norm<double>(v) + (to + late) * norm<double>(a));
  for (int k = 0; k < 3; ++k) box.low[k] -= reach, box.high[k] += reach;
  return box;
}

}  // namespace rigor
