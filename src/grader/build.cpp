#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <future>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <rigor/base/file.hpp>
#include <rigor/base/interrupt.hpp>
#include <rigor/base/promise.hpp>
#include <rigor/grader/build_compile.hpp>
#include <rigor/grader/build_hash.hpp>
#include <rigor/grader/build_sources.hpp>
#include <rigor/grader/sandbox.hpp>
#include <rigor/grader/texts.hpp>

namespace rigor::grader {
namespace {

namespace fs = std::filesystem;
using UnorderedJson = nlohmann::json;
using Kind = FunctionStatus::Kind;

constexpr int most_rounds = 40;

class Builder {
 public:
  Builder(const Submission& submission, const BuildOptions& options, Toolchain tools)
      : options_(options), tools_(std::move(tools)), sources_(submission, options.replaced) {}

  BuildResult run() {
    for (int round = 0; round < most_rounds && interrupted() == 0; ++round) {
      changed_ = false;
      if (compile_all() && link()) {
        result_.executable = program_;
        break;
      }
      if (!changed_) break;
    }
    sources_.report_to(result_, !result_.executable.empty());
    return std::move(result_);
  }

 private:
  // ---- Compiling

  /// Every file of the list, and the driver, as objects; false when something was replaced and it must go on.
  bool compile_all() {
    stage();
    std::vector<std::string> names;
    for (const auto& [name, source] : sources_.files())
      if (is_source(name) && source.expected) names.push_back(name);
    names.push_back("driver.cpp");
    names.push_back("constants.cpp");
    std::vector<std::future<Compilation>> running;
    std::vector<Compilation> done;
    while (done.size() < names.size()) {
      while (running.size() < names.size() && running.size() - done.size() < std::size_t(std::max(1, options_.jobs)))
        running.push_back(std::async(std::launch::async, [this, name = names[running.size()]] { return object(name); }));
      done.push_back(running[done.size()].get());
    }
    bool clean = true;
    for (std::size_t i = 0; i < names.size(); ++i) {  // all have ended: no compiler reads what is repaired here
      // errors under a header that is about to be replaced say nothing about the files
      if (!done[i].ok && sources_.headers_key() == headers_) changed_ |= sources_.repair(names[i], done[i]);
      clean &= done[i].ok;
    }
    return clean;
  }

  void stage() {
    for (const auto& file : fs::directory_iterator(workshop_.src()))
      if (!sources_.files().contains(file.path().filename().string())) fs::remove(file);  // given up since
    for (const auto& [name, source] : sources_.files()) {
      const auto written = write_file(workshop_.src() / name, source.text);
      promise(bool(written), "a temporary directory can be written to");
    }
    headers_ = sources_.headers_key();
  }

  std::string source_of(const std::string& name) const {
    return sources_.files().contains(name) ? name : (tools_.kit / "driver" / name).string();
  }

  /// One object, from the cache when the same text under the same headers was compiled before.
  Compilation object(const std::string& name) {
    const auto at = sources_.files().find(name);
    const std::string key =
        key_of(tools_.key, headers_, name, at != sources_.files().end() ? at->second.text : std::string());
    const fs::path cached = tools_.cache / "objects" / key.substr(0, 2) / (key + ".o");
    {
      const std::lock_guard hold(lock_);
      objects_[name] = cached;
    }
    std::error_code ec;
    if (fs::exists(cached, ec)) {
      count(result_.reused);
      return {true, "", ""};
    }
    const std::string made = (workshop_.out() / (name + ".o")).string();
    std::vector<std::string> arguments{"-include", (tools_.kit / "include" / "kit.hpp").string(), "-iquote", "."};
    if (at == sources_.files().end()) arguments.push_back("-fno-access-control");
    if (at != sources_.files().end()) arguments.push_back("-Dmain=main_of_the_submission");
    arguments.insert(arguments.end(), {"-x", "c++", "-c", source_of(name), "-o", made});
    Compilation c = compile(tools_, workshop_, arguments);
    if (c.ok && !copy_whole(made, cached)) c = {false, "", "the cache cannot be written to"};
    count(result_.compiled);
    return c;
  }

  void count(int& what) {
    const std::lock_guard hold(lock_);
    ++what;
  }

  // ---- Linking

  bool link() {
    std::string all = tools_.key;
    std::vector<std::string> arguments;
    for (const auto& [name, path] : objects_) {
      if (sources_.files().contains(name) && !sources_.files().at(name).expected) continue;
      all += key_of(path.string());
    }
    arguments = {"-Wl,--allow-multiple-definition"};
    if (!options_.sanitize) arguments.insert(arguments.end(), {"-static", "-s"});  // the address sanitizer cannot be static
    for (const char* first : {"driver.cpp", "constants.cpp"}) arguments.push_back(staged_object(first));
    for (const auto& [name, source] : sources_.files())
      if (is_source(name) && (source.expected || linked_others_)) {
        if (!source.expected && !others_.contains(name)) continue;
        arguments.push_back(staged_object(name));
        if (!source.expected) all += key_of(name, source.text);
      }
    program_ = tools_.cache / "programs" / sha256(all);
    std::error_code ec;
    if (fs::exists(program_, ec)) return true;
    const fs::path made = workshop_.out() / "program";
    arguments.insert(arguments.end(), {"-o", made.string()});
    const Compilation c = compile(tools_, workshop_, arguments);
    if (c.ok && copy_whole(made, program_)) return true;
    if (!linked_others_) {
      changed_ = linked_others_ = true;
      compile_others();
    } else {
      changed_ = sources_.repair_linking(c);
    }
    return false;
  }

  /// The linker sees objects beside the sources, under their own names: its messages name them.
  std::string staged_object(const std::string& name) {
    const fs::path to = workshop_.src() / (name + ".o");
    std::error_code ec;
    fs::copy_file(objects_[name], to, fs::copy_options::overwrite_existing, ec);
    promise(!ec, "an object can be copied");
    return to.filename().string();
  }

  void compile_others() {
    for (const auto& [name, source] : sources_.files()) {
      if (!is_source(name) || source.expected) continue;
      const Compilation c = object(name);
      if (c.ok) {
        others_.insert(name);
        sources_.note(source.path + " is linked as well");
      } else {
        sources_.note(source.path + " does not compile and is left out: " + clipped(c.output));
      }
    }
  }

  const BuildOptions& options_;
  Toolchain tools_;
  Workshop workshop_;
  Sources sources_;
  std::map<std::string, fs::path> objects_;
  std::set<std::string> others_;
  bool linked_others_ = false, changed_ = false;
  std::string headers_;
  fs::path program_;
  std::mutex lock_;
  BuildResult result_;
};

// ---- A result kept: the same submission is not looked at twice

UnorderedJson json_of(const BuildResult& r) {
  UnorderedJson functions = UnorderedJson::array();
  for (const FunctionStatus& f : r.functions) functions.push_back({int(f.kind), f.error});
  return {{"executable", r.executable.string()}, {"functions", functions}, {"own_constants", r.own_constants},
          {"notes", r.notes}};
}

bool read_kept(const fs::path& path, BuildResult& r) {
  const auto text = read_file(path);
  if (!text) return false;
  const UnorderedJson kept = UnorderedJson::parse(*text, nullptr, false);
  if (kept.is_discarded()) return false;
  r.executable = kept["executable"].get<std::string>();
  std::error_code ec;
  if (!r.executable.empty() && !fs::exists(r.executable, ec)) return false;
  for (std::size_t i = 0; i < student_functions; ++i)
    r.functions[i] = {Kind(kept["functions"][i][0].get<int>()), kept["functions"][i][1].get<std::string>()};
  r.own_constants = kept["own_constants"];
  r.notes = kept["notes"].get<std::vector<std::string>>();
  return true;
}

}  // namespace

const char* student_function_name(StudentFunction f) {
  switch (f) {
    case StudentFunction::body_inertia: return "Cuboid::computeBodyCoordsMOI";
    case StudentFunction::world_inertia: return "Cuboid::computeWorldCoordsMOI";
    case StudentFunction::world_inverse_inertia: return "Cuboid::computeWorldCoordsInverseMOI";
    case StudentFunction::apply_force: return "Cuboid::applyForce";
    case StudentFunction::update: return "Cuboid::update";
    case StudentFunction::friction_tangent: return "CollisionPlane::frictionTangent";
    case StudentFunction::plane_response: return "CollisionPlane::applyCollisionResponse";
    case StudentFunction::pair_response: return "ParticleSystem::applyCollisionImpulse";
  }
  return "";
}

fs::path default_cache() {
  if (const char* own = std::getenv("RIGOR_CACHE"); own && *own) return own;
  if (geteuid() == 0) return "/var/cache/rigor";
  if (const char* xdg = std::getenv("XDG_CACHE_HOME"); xdg && *xdg == '/') return fs::path(xdg) / "rigor";
  if (const char* home = std::getenv("HOME"); home && *home == '/') return fs::path(home) / ".cache" / "rigor";
  return fs::temp_directory_path() / ("rigor-cache-" + std::to_string(geteuid()));
}

std::string kit_hash() {
  static const std::string hash = [] {
    std::string all;
    for (const Text& text : texts())
      if (text.path.starts_with("src/kit/")) all += key_of(text.path, text.content);
    return sha256(all);
  }();
  return hash;
}

std::string tool_hash() {
  static const std::string hash = [] {
    const auto program = read_file("/proc/self/exe", 1u << 30);
    return program ? sha256(*program) : std::string("unknown");
  }();
  return hash;
}

Outcome<BuildResult> build(const Submission& submission, const BuildOptions& options) {
  const auto begun = std::chrono::steady_clock::now();
  std::error_code none;
  const fs::path room = fs::temp_directory_path(none);
  if (none || access(room.c_str(), W_OK | X_OK) != 0) {
    const char* asked = std::getenv("TMPDIR");
    return Fault{Fault::Kind::unwritable, "TMPDIR", "is " + std::string(asked != nullptr ? asked : room.string()) + ", must be a directory that can be written to"};
  }
  const auto tools = toolchain(options.cache.empty() ? default_cache() : options.cache, options.sanitize);
  if (!tools) return tools.fault();
  std::string asked;
  for (const StudentFunction f : options.replaced) asked += student_function_name(f);
  for (const Text& text : texts()) asked += key_of(text.path, text.content);  // the rules below are among them
  const std::string key = key_of(tools->key, submission.hash, asked);
  const fs::path kept = tools->cache / "builds" / (key + ".json");
  BuildResult result;
  if (!read_kept(kept, result)) {
    result = Builder(submission, options, *tools).run();
    if (interrupted() != 0) return Fault{Fault::Kind::unsupported, submission.name, "interrupted while it was compiled"};  // kept as no result
    if (const auto written = write_file(kept, json_of(result).dump()); !written) return written.fault();
  } else {
    result.reused = 6;
  }
  result.isolation = isolation(Profile::compiler);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  return result;
}

}  // namespace rigor::grader
