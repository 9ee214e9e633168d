// Our methods beside the prototype's loops on case A: in turn in one process, the least of many rounds. See tests/bench/prototype.
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <rigor/engine/exact_flight.hpp>
#include <rigor/integrators/method.hpp>
#include <rigor/linalg/rotation.hpp>
#include <string>
#include <tests/bench/prototype_rows.hpp>
#include <time.h>

namespace {
using namespace rigor;

const Cuboid<double> plate = *Cuboid<double>::make(1, {1, 2, 3});
const Vec3<double> w_B(0.3, 2, 0.2);
constexpr double T = 10;

double seconds() {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}
Mat3<double> ours(const std::string& name, int n) {
  const auto flight = [] { return *ExactFlight::make(plate.inertia(), w_B, identity3<double>()); };
  Mat3<double> R;
  if (name == "exact, evaluation") {
    const ExactFlight f = flight();
    for (int k = 1; k <= n; ++k) R = f.at(T * k / n).R_WB;
  } else if (name == "exact, set-up too") {
    for (int k = 1; k <= n; ++k) R = flight().at(T).R_WB;
  } else {
    const Method& m = *find_method(name);
    State<double> start;
    start.w_WB = w_B;
    Motion x = motion_of(plate, start);
    if (m.fly != nullptr) return m.fly(plate, x, T / n, n).state.R_WB;
    for (int k = 0; k < n; ++k) x = m.step(plate, x, {}, T / n);
    R = x.state.R_WB;
  }
  return R;
}
Mat3<double> theirs(const PrototypeRow& row, int n) {
  double R[9];
  row.fly(plate.inertia().data(), w_B.data(), T, n, R);
  Mat3<double> out;
  for (int i = 0; i < 9; ++i) out(i / 3, i % 3) = R[i];
  return out;
}

}  // namespace

int main() {
  struct Pair {
    const char *ours, *theirs;
    int n;
    const char* other = "";  // how it is another map; else both end at the same attitude, to rounding
  };
  const Pair pairs[] = {{"euler-momentum", "symEuler+GS", 6400},
                        {"euler-momentum-cross", "symEuler+GS", 6400},
                        {"sheet", "symEuler+GS", 6400, "spin form, third column projected"},
                        {"euler-momentum-exponential", "Euler-exp", 6400},
                        {"euler-exponential", "Euler-exp", 6400, "spin form"},
                        {"implicit-midpoint", "impl-midpoint-Lie", 1600},
                        {"buss-augmented", "buss-aug2", 1600, "commutator of the other sign"},
                        {"rk4", "RK4-quat", 1600},
                        {"rkmk4", "RKMK4", 800},
                        {"commutator-free4", "CF4", 800},
                        {"split3", "split3-Strang", 1600},
                        {"split3-yoshida4", "split3-Yoshida4", 800},
                        {"split2", "split2-Strang", 1600, "axes in other order"},
                        {"split2-yoshida4", "split2-Yoshida4", 800, "axes in other order"},
                        {"split2-kahan-li6", "split2-KahanLi6", 200, "axes in other order"},
                        {"split2-kahan-li8", "split2-KahanLi8", 100, "axes in other order"},
                        {"moser-veselov", "DMV2", 1600},
                        {"moser-veselov4", "DMV4", 800},
                        {"moser-veselov8", "DMV8", 200},
                        {"taylor16", "Taylor16", 50},
                        {"exact, evaluation", "tuned-ld-eval", 2000},
                        {"exact, set-up too", "tuned-ld-setup+eval", 20}};
  const std::vector<PrototypeRow> tables[2] = {rows_with_our_flags(), rows_with_their_flags()};
  std::printf("case A, T = 10 s; ns a step: ours, the prototype with our flags, with its own; ours over each; angle between the ends, rad\n");
  bool good = true;
  for (const Pair& p : pairs) {
    const auto row = [&](const std::vector<PrototypeRow>& rows) {
      return *std::find_if(rows.begin(), rows.end(), [&](const PrototypeRow& r) { return std::strcmp(r.name, p.theirs) == 0; });
    };
    const PrototypeRow with_ours = row(tables[0]), with_theirs = row(tables[1]);
    double least[3] = {1e9, 1e9, 1e9};
    for (int round = 0; round < 80; ++round) {
      double start = seconds();
      ours(p.ours, p.n);
      least[0] = std::min(least[0], seconds() - start);
      start = seconds();
      theirs(with_ours, p.n);
      least[1] = std::min(least[1], seconds() - start);
      start = seconds();
      theirs(with_theirs, p.n);
      least[2] = std::min(least[2], seconds() - start);
    }
    const double apart = angle_between<double>(ours(p.ours, p.n), theirs(with_ours, p.n));
    const bool agree = *p.other != 0 || apart < 1e-11;  // 6400 steps of a few u, grown by the flow
    good = good && agree;
    std::printf("%-27s %-20s %5d %8.1f %8.1f %8.1f %8.2f %8.2f   %.0e%s%s\n", p.ours, p.theirs, p.n, 1e9 * least[0] / p.n, 1e9 * least[1] / p.n, 1e9 * least[2] / p.n,
                least[0] / least[1], least[0] / least[2], apart, *p.other != 0 ? ", " : agree ? "" : ", should be one map", p.other);
  }
  return good ? 0 : 1;
}
