#pragma once
#include <algorithm>
#include <chrono>
#include <ctime>
#include <vector>

namespace rigor::studies {

/// Seconds for one call: processor time of the thread and time on the wall.
struct Timing {
  double cpu_min, cpu_median, wall_min, wall_median;
};

inline double cpu_seconds() {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}
inline double wall_seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

inline Timing summary(std::vector<double> cpu, std::vector<double> wall) {
  std::sort(cpu.begin(), cpu.end());
  std::sort(wall.begin(), wall.end());
  return {cpu[0], cpu[cpu.size() / 2], wall[0], wall[wall.size() / 2]};
}

/// Seven samples after a warm-up, each of as many calls as fill 2 ms; three where one call takes longer than 0.2 s.
template <class Call>
Timing time_of(const Call& call) {
  call();
  const double start = wall_seconds();
  call();
  const double once = wall_seconds() - start;
  const int calls = std::max(1, int(2e-3 / std::max(once, 1e-9))), samples = once > 0.2 ? 3 : 7;
  std::vector<double> cpu, wall;
  for (int k = 0; k < samples; ++k) {
    const double c = cpu_seconds(), w = wall_seconds();
    for (int i = 0; i < calls; ++i) call();
    cpu.push_back((cpu_seconds() - c) / calls);
    wall.push_back((wall_seconds() - w) / calls);
  }
  return summary(cpu, wall);
}

}  // namespace rigor::studies
