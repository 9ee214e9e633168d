#include <fmt/format.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <rigor/base/suggest.hpp>
#include <rigor/studies/cell.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/studies/peer.hpp>

namespace rigor::studies {
namespace {

using Json = nlohmann::json;
using V = Vec3<double>;

Fault fault(Fault::Kind kind, const std::string& name, const std::string& what) { return {kind, "peer " + name, what}; }

// The peer's program beside ours.
Outcome<std::string> program(const std::string& name) {
  std::vector<std::string> names;
  const Peer* peer = nullptr;
  for (const Peer& p : peers()) {
    names.push_back(p.name);
    if (p.name == name) peer = &p;
  }
  if (peer == nullptr) return fault(Fault::Kind::unknown_key, name, fmt::format("is none of the peers{}; known: {}", did_you_mean(name, names), fmt::join(names, ", ")));
  std::error_code ec;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", ec);
  const std::filesystem::path path = self.parent_path() / ("rigor-peer-" + name);
  const std::string build = "cmake --build build/release --target rigor_peers";
  if (ec || !std::filesystem::exists(path))
    return fault(Fault::Kind::unsupported, name, peer->installed ? "is not built: " + build : "is not installed: install " + peer->package + ", then cmake --preset release && " + build);
  return path.string();
}

Outcome<Json> ask(const std::string& name, const std::string& arguments) {
  const auto path = program(name);
  if (!path) return path.fault();
  // our own file name and numbers, nothing a user typed
  std::FILE* pipe = popen(("'" + *path + "' " + arguments + " 2>/dev/null").c_str(), "r");
  if (pipe == nullptr) return fault(Fault::Kind::unreadable, name, "cannot be started");
  std::string text;
  std::array<char, 4096> buffer;
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe)) text.append(buffer.data(), n);
  const int status = pclose(pipe);
  // an engine may print of its own: the answer is the last line
  const std::size_t end = text.find_last_not_of('\n'), begin = end == std::string::npos ? 0 : text.rfind('\n', end);
  const Json json = Json::parse(begin == std::string::npos ? text : text.substr(begin), nullptr, false);
  if (!json.is_object()) return fault(Fault::Kind::unreadable, name, "ended without an answer" + (WIFSIGNALED(status) ? ", by signal " + std::to_string(WTERMSIG(status)) : ""));
  if (json.contains("fault")) return fault(Fault::Kind::unsupported, name, json["fault"].get<std::string>());
  return json;
}

}  // namespace

const std::vector<Peer>& peers() {
  const auto found = [](const std::string& name) { return std::string(RIGOR_PEERS).find("," + name + ",") != std::string::npos; };  // by peers.cmake
  static const std::vector<Peer> all{{"bullet", "libbullet-dev", found("bullet")},    {"ode", "libode-dev", found("ode")},    {"mujoco", "libmujoco-dev", found("mujoco")},
                                     {"simbody", "libsimbody-dev", found("simbody")}, {"dart", "libdart-dev", found("dart")}};
  return all;
}

Outcome<std::vector<PeerVariant>> peer_variants(const std::string& name) {
  const auto json = ask(name, "list");
  if (!json) return json.fault();
  std::vector<PeerVariant> variants;
  for (const Json& v : (*json)["variants"]) variants.push_back({name + "/" + v["name"].get<std::string>(), v["settings"], v["adaptive"], v["ns"]});
  return variants;
}

Outcome<PeerRun> run_peer(const std::string& variant, const Problem& problem, long steps, double tolerance) {
  const std::size_t slash = variant.find('/');
  const std::string name = variant.substr(0, slash);
  if (!problem.falls) return fault(Fault::Kind::unsupported, name, "is only asked for flights without torque");
  std::string arguments = "run " + variant.substr(slash + 1) + " " + std::to_string(steps) + " " + digits(tolerance);
  const auto put = [&](const auto& v) {
    for (int i = 0; i < int(v.size()); ++i) arguments += " " + digits(v[i]);
  };
  const State<double>& s = problem.start;
  arguments += " " + digits(problem.until) + " " + digits(problem.body.mass());
  put(problem.body.size());
  put(quaternion_of<double>(s.R_WB));
  put(s.w_WB);
  put(s.p_WB);
  put(s.v_WB);
  put(*problem.falls);
  const auto json = ask(name, arguments);
  if (!json) return json.fault();
  const auto vector = [](const Json& j) { return V(j[0].get<double>(), j[1].get<double>(), j[2].get<double>()); };
  PeerRun run;
  for (const char* key : {"R", "p", "v", "w"})
    for (const Json& x : (*json)[key])
      if (!x.is_number()) return fault(Fault::Kind::not_finite, name, "left the numbers");
  for (int i = 0; i < 9; ++i) run.end.R_WB(i / 3, i % 3) = (*json)["R"][std::size_t(i)].get<double>();
  run.end.p_WB = vector((*json)["p"]);
  run.end.v_WB = vector((*json)["v"]);
  run.end.w_WB = vector((*json)["w"]);
  run.timing = {(*json)["cpu_min"], (*json)["cpu_median"], (*json)["wall_min"], (*json)["wall_median"]};
  run.evaluations = (*json)["evaluations"];
  run.settings = (*json)["settings"];
  return run;
}

}  // namespace rigor::studies
