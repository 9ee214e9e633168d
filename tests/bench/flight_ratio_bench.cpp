// Exact flight beside the prototype in one run: tests/bench/flight builds both and calls this with the prototype's library.
// The two take turns, in processor time.
#include <dlfcn.h>
#include <time.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <random>
#include <rigor/engine/flight_batch.hpp>
#include <rigor/linalg/rotation.hpp>
#include <string>
#include <vector>

#include "flight_prototype.hpp"

namespace {
using namespace rigor;
using V = Vec3<double>;
using Precision = ExactFlight::Precision;

template <class Function>
Function* found(void* library, const char* name) {
  void* const symbol = dlsym(library, name);
  if (symbol == nullptr) std::fprintf(stderr, "%s is not in the prototype's library\n", name), std::exit(2);
  return reinterpret_cast<Function*>(symbol);
}
void use(const void* value) { asm volatile("" : : "r"(value) : "memory"); }

double now() {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return double(t.tv_sec) * 1e9 + double(t.tv_nsec);
}
double nanoseconds(const std::function<void()>& run) {
  const double start = now();
  run();
  return now() - start;
}
// Nanoseconds of each, the smallest, and the ratio, of the turns' the middle one: within a turn the two see the same clock.
struct Times {
  double ours = INFINITY, prototype = INFINITY, ratio = 0;
};
Times in_turns(long turns, const std::function<void()>& ours, const std::function<void()>& prototype) {
  const auto warm = [](const std::function<void()>& run) {  // the first finds the other's data in the caches
    double best = INFINITY;
    for (int k = 0; k < 3; ++k) best = std::min(best, nanoseconds(run));
    return best;
  };
  Times best;
  std::vector<double> ratios;
  for (long k = 0; k < turns; ++k) {
    const double theirs = warm(prototype), mine = warm(ours);
    best.prototype = std::min(best.prototype, theirs), best.ours = std::min(best.ours, mine);
    ratios.push_back(mine / theirs);
  }
  std::nth_element(ratios.begin(), ratios.begin() + turns / 2, ratios.end());
  best.ratio = ratios[std::size_t(turns / 2)];
  return best;
}
void row(const std::string& what, const Times& times, double count, const char* bar, bool held) {
  std::printf("%-34s %9.1f %9.1f %7.2f  %s%s\n", what.c_str(), times.ours / count, times.prototype / count, times.ratio, bar, held ? "" : "  OVER");
}

}  // namespace

int main(int argc, char** argv) {
  void* const library = argc == 2 ? dlopen(argv[1], RTLD_NOW | RTLD_LOCAL) : nullptr;
  if (library == nullptr) return std::fprintf(stderr, "%s\n", argc == 2 ? dlerror() : "wants the prototype's library: call tests/bench/flight"), 2;
  auto* const set_up = found<PrototypeSetUp>(library, "prototype_set_up");
  auto* const make = found<PrototypeFlight>(library, "prototype_flight");
  auto* const evaluate = found<PrototypeEvaluate>(library, "prototype_evaluate");
  auto* const make_all = found<PrototypeFlights>(library, "prototype_flights");
  auto* const evaluate_all = found<PrototypeEvaluateAll>(library, "prototype_evaluate_all");

  constexpr long turns = 1001;
  std::printf("%-34s %9s %9s %7s  %s\n", "ns of processor time", "ours", "prototype", "ratio", "at most");
  const V I(13 / 12., 10 / 12., 5 / 12.);  // cuboid 1 x 2 x 3 m, 1 kg
  const std::pair<const char*, V> cases[] = {{"A", {0.3, 2, 0.2}}, {"B", {5, 0.01, 0.01}}, {"C", {1e-6, 2, 1e-6}}};
  double apart = 0;
  for (const auto& [name, w] : cases) {
    const ExactFlight flight = *ExactFlight::make(I, w, identity3<double>());
    void* const theirs = make(I.data(), w.data());
    constexpr long count = 300;
    double rows[9], last = 0;
    const auto ours = [&] {
      double t = 10;
      for (long k = 0; k < count; ++k, t += 1e-3) {
        const Attitude a = flight.at(t);
        use(&a);
        last = t;
      }
    };
    const Times times = in_turns(turns, ours, [&] { evaluate(theirs, 10, 1e-3, count, rows); });
    row(std::string("one evaluation, case ") + name, times, count, "ratio 1.2", times.ratio <= 1.2);
    Mat3<double> R;
    for (int k = 0; k < 9; ++k) R(k / 3, k % 3) = rows[k];
    apart = std::max(apart, angle_between<double>(R, flight.at(last).R_WB));
  }
  for (const auto& [precision, what, most] : {std::tuple{Precision::plain, "plain", 1000.}, {Precision::extended, "extended", 10000.}})
    for (const auto& [name, spin] : cases) {
      constexpr long count = 10;
      const V w = spin;
      const auto ours = [&, precision = precision] {
        for (long k = 0; k < count; ++k) {
          use(I.data()), use(w.data());
          const auto made = ExactFlight::make(I, w, identity3<double>(), precision);
          use(&made);
        }
      };
      const Times times = in_turns(turns / 4, ours, [&, precision = precision] { set_up(I.data(), w.data(), precision == Precision::extended, count); });
      row(std::string("set-up, ") + what + ", case " + name, times, count, precision == Precision::plain ? "1000 ns" : "10000 ns", times.ours / count <= most);
    }

  // cuboids of 0.5 to 3 m, m <= 1/2: the series the prototype has as arrays
  constexpr long bodies = 1000;
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> edge(0.5, 3);
  std::normal_distribution<double> spin;
  std::vector<ExactFlight> flights;
  std::vector<double> moments, spins;
  while (long(flights.size()) < bodies) {
    const double a = edge(random), b = edge(random), c = edge(random);
    const V box(b * b + c * c, a * a + c * c, a * a + b * b), w(spin(random), spin(random), spin(random));
    const ExactFlight flight = *ExactFlight::make(box, w, identity3<double>());
    if (flight.tuned().kind != ExactFlight::Tuned::Kind::theta) continue;
    flights.push_back(flight);
    moments.insert(moments.end(), box.data(), box.data() + 3), spins.insert(spins.end(), w.data(), w.data() + 3);
  }
  void* const all = make_all(bodies, moments.data(), spins.data());
  if (all == nullptr) return std::fprintf(stderr, "the prototype takes another series for one of the bodies\n"), 2;
  FlightBatch batch(flights);
  double t = 3.7, u = 3.7;
  for (const Instructions with : supported_instructions()) {
    const Times times = in_turns(turns, [&] { batch.evaluate(t += 1e-3, 1, with); }, [&] { evaluate_all(all, u += 1e-3); });
    const bool widest = with == widest_instructions();
    row("1000 flights, " + std::string(name(with)), times, bodies, widest ? "ratio 1.3" : "", !widest || times.ratio <= 1.3);
  }
  std::printf("one flight of ours and of the prototype: attitudes at most %.1e rad apart\n", apart);
}
