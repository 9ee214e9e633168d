// rigor-peer-NAME list | run VARIANT STEPS TOLERANCE and the numbers of a flight: prints one line of JSON. Started by
// `rigor study --peers`; the engine's set-up is not timed, only the flight.
#include <charconv>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <rigor/studies/peers/peer.hpp>
#include <rigor/studies/timing.hpp>

namespace rigor::peers {

std::array<double, 9> rows_of(const std::array<double, 4>& q) {
  const auto& [w, x, y, z] = q;
  const double s = 2 / (w * w + x * x + y * y + z * z);
  return {1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y), s * (x * y + w * z), 1 - s * (x * x + z * z),
          s * (y * z - w * x),     s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y)};
}
std::array<double, 3> Flight::spin_B() const {
  const auto R = rows_of(q);
  std::array<double, 3> out;
  for (std::size_t i = 0; i < 3; ++i) out[i] = R[i] * w[0] + R[3 + i] * w[1] + R[6 + i] * w[2];
  return out;
}

namespace {

using Json = nlohmann::ordered_json;

Json answer(int count, char** words) {
  const std::string what = count > 1 ? words[1] : "";
  if (what == "list") {
    Json all = Json::array();
    for (const Variant& v : variants()) all.push_back({{"name", v.name}, {"settings", v.settings}, {"adaptive", v.adaptive}, {"ns", v.ns}});
    return {{"variants", all}};
  }
  if (what != "run" || count != 26) return {{"fault", "usage: list, or run VARIANT STEPS TOLERANCE and 21 numbers"}};
  double x[23];
  for (int i = 0; i < 23; ++i) {
    const std::string text = words[3 + i];
    const auto end = std::from_chars(text.data(), text.data() + text.size(), x[i]);
    if (end.ec != std::errc() || end.ptr != text.data() + text.size()) return {{"fault", "'" + text + "' is not a number"}};
  }
  const double* y = x + 4;
  const Flight flight{x[2], x[3], {y[0], y[1], y[2]}, {y[3], y[4], y[5], y[6]}, {y[7], y[8], y[9]}, {y[10], y[11], y[12]}, {y[13], y[14], y[15]}, {y[16], y[17], y[18]}};
  for (const Variant& v : variants()) {
    if (v.name != words[2]) continue;
    std::vector<double> cpu, wall;
    End end{};
    long evaluations = 0;
    double spent = 0;
    for (int k = 0; k < 8 && (k < 3 || spent < 0.5); ++k) {  // the first warms up
      const auto world = v.make(flight, long(x[0]), x[1]);
      const double c = studies::cpu_seconds(), w = studies::wall_seconds();
      world->run();
      const double took = studies::cpu_seconds() - c;
      spent += took;
      if (k > 0) cpu.push_back(took), wall.push_back(studies::wall_seconds() - w);
      end = world->end();
      evaluations = world->evaluations();
    }
    const studies::Timing t = studies::summary(cpu, wall);
    return {{"R", end.R}, {"p", end.p}, {"v", end.v}, {"w", end.w}, {"evaluations", evaluations}, {"cpu_min", t.cpu_min}, {"cpu_median", t.cpu_median},
            {"wall_min", t.wall_min}, {"wall_median", t.wall_median}, {"settings", v.settings}};
  }
  return {{"fault", std::string("has no variant '") + words[2] + "'"}};
}

}  // namespace
}  // namespace rigor::peers

int main(int count, char** words) {
  nlohmann::ordered_json json;
  try {  // the engines throw
    json = rigor::peers::answer(count, words);
  } catch (const std::exception& e) {
    json = {{"fault", std::string("stopped: ") + e.what()}};
  }
  std::printf("\n%s\n", json.dump().c_str());
  return json.contains("fault") ? 1 : 0;
}
