#include <cmath>
#include <rigor/base/interrupt.hpp>
#include <rigor/scalar/gamma.hpp>
#include <rigor/verify/inputs.hpp>
#include <rigor/verify/verify.hpp>

namespace rigor::verify {
namespace {

using In = Inputs<double>;
using V = Vec3<double>;

double relative(const V& got, const V& want, double scale) {
  return std::sqrt(dot<double>(got - want, got - want)) / scale;
}

// The volume integral of density times (y^2 + z^2, ...) by two Gauss points per axis: exact for quadratics.
double gauss_inertia(const In& in) {
  V sum = zero3<double>();
  for (int k = 0; k < 8; ++k) {
    V x;
    for (int i = 0; i < 3; ++i) x[i] = (k >> i & 1 ? 0.5 : -0.5) * in.s_B[i] / std::sqrt(3.0);
    for (int i = 0; i < 3; ++i) sum[i] += in.m / 8 * (dot<double>(x, x) - x[i] * x[i]);
  }
  return relative(in.I_B, sum, norm<double>(sum));
}

struct Row {
  const char *id, *oracle;
  double bound;
  double (*distance)(const In&);
};

const Row rows[] = {
    {"inertia.cuboid", "Gauss product rule, two points per axis, relative", gamma_bound(16), gauss_inertia},
};

}  // namespace

std::vector<Agreement> agreements(const std::string& only, long cases, std::uint64_t seed) {
  std::vector<Agreement> results;
  for (const Row& row : rows) {
    if (!only.empty() && only != row.id) continue;
    Agreement result{row.id, row.oracle, 0, row.bound, 0};
    Random random(seed);
    for (long c = 0; c < cases && interrupted() == 0; ++c) {
      const double distance = row.distance(draw<double>(random));
      if (!(distance <= result.worst)) result.worst = distance;  // keeps NaN, which then is not ok
      ++result.cases;
    }
    results.push_back(result);
  }
  return results;
}

}  // namespace rigor::verify
