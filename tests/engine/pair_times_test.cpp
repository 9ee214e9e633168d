// A thousand courses of two cuboids against dense sampling in long double that shares nothing with the search: attitudes by
// the Taylor series, separation as the largest of the fifteen axes' gaps, its root by bisection.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <reference/taylor.hpp>
#include <rigor/engine/pair_search.hpp>

#include "pair_courses.hpp"

namespace rigor {
namespace {

using X = long double;

struct Pose {
  Vec3<X> p, v, w;
  Mat3<X> R;
};
Pose start_of(const State<double>& s) { return {s.p_WB.cast<X>(), s.v_WB.cast<X>(), s.w_WB.cast<X>(), s.R_WB.cast<X>()}; }
Pose fly(const Cuboid<double>& shape, const Pose& from, X t) {
  const Vec3<X> size = shape.size().cast<X>();
  Vec3<X> I;
  for (int k = 0; k < 3; ++k) I[k] = size[(k + 1) % 3] * size[(k + 1) % 3] + size[(k + 2) % 3] * size[(k + 2) % 3];
  const auto a = reference::taylor_free_body<X>(I, Vec3<X>(from.R.transpose() * from.w), from.R, t, 18, 0.01);
  Pose s{from.p + t * from.v, from.v, a.R_WB * a.w_B, a.R_WB};
  s.p[1] += t * t / 2 * X(-9.8), s.v[1] += t * X(-9.8);
  return s;
}
// Positive if and only if the two are apart.
X gap(const Cuboid<double>& A, const Pose& a, const Cuboid<double>& B, const Pose& b) {
  const Vec3<X> d = b.p - a.p;
  X largest = -1000;
  const auto along = [&](const Vec3<X>& axis) {
    const X length = std::sqrt(axis.dot(axis));
    if (length < 1e-9L) return;  // two edges in line: a face normal does it
    X reach = 0;
    for (int k = 0; k < 3; ++k) reach += std::fabs(axis.dot(a.R.col(k))) * X(A.size()[k]) / 2 + std::fabs(axis.dot(b.R.col(k))) * X(B.size()[k]) / 2;
    largest = std::max(largest, (std::fabs(axis.dot(d)) - reach) / length);
  };
  for (int i = 0; i < 3; ++i) {
    along(a.R.col(i)), along(b.R.col(i));
    for (int k = 0; k < 3; ++k) along(cross<X>(Vec3<X>(a.R.col(i)), Vec3<X>(b.R.col(k))));
  }
  return largest;
}

TEST(PairTimes, EveryFirstImpactIsFoundAtItsTime) {
  const int courses = std::getenv("RIGOR_ALL") != nullptr ? 1000 : 60;
  constexpr int samples = 600;  // of 3 s: 5 ms apart, then 1 us around the time found
  Draw draw;
  int met = 0;
  double worst = 0;
  for (int c = 0; c < courses; ++c) {
    const Course x = course(draw);
    const Flight a(x.A, x.a, Vec3<double>(0, -9.8, 0)), b(x.B, x.b, Vec3<double>(0, -9.8, 0));
    const PairContact found = next_pair_contact(x.A, a, 0, x.B, b, 0, 0, 3);
    ASSERT_NE(found.kind, PairContact::Kind::endless);
    const bool touch = found.kind == PairContact::Kind::touch;
    const Pose start_a = start_of(x.a), start_b = start_of(x.b);
    const auto gap_at = [&](X t) { return gap(x.A, fly(x.A, start_a, t), x.B, fly(x.B, start_b, t)); };
    Pose on_a = start_a, on_b = start_b;
    const X step = 3.0L / samples;
    for (int k = 0; k * step < (touch ? X(found.time) : 3.0L); ++k, on_a = fly(x.A, on_a, step), on_b = fly(x.B, on_b, step))
      ASSERT_GT(gap(x.A, on_a, x.B, on_b), -1e-15L) << "course " << c << ": an impact before " << double(k * step) << " was missed";
    if (!touch) continue;
    ++met;
    X low = X(found.time) - 1e-6L, high = X(found.time) + 1e-6L;
    ASSERT_GT(gap_at(low), 0) << c;
    ASSERT_LT(gap_at(high), 0) << c << ": it was about to overlap";
    const X rate = (gap_at(low) - gap_at(high)) / (high - low);
    while (high - low > 1e-17L && low < (low + high) / 2 && (low + high) / 2 < high) (gap_at((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
    const double closing = norm<double>(V(x.a.v_WB - x.b.v_WB)) + norm<double>(x.a.w_WB) * norm<double>(x.A.size()) / 2 + norm<double>(x.b.w_WB) * norm<double>(x.B.size()) / 2;
    const double allowed = std::max(1.0, closing / double(rate)), off = std::fabs(double(X(found.time) - low));
    EXPECT_LT(off, 1e-12 * allowed) << "course " << c;
    worst = std::max(worst, off / allowed);
  }
  std::printf("pairs: %d of %d courses meet, time off by %.1e of max(1 s, closing speed over gap rate)\n", met, courses, worst);
  EXPECT_GT(met, courses * 3 / 10);
  EXPECT_LT(met, courses);
}

}  // namespace
}  // namespace rigor
