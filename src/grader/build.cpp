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
#include <rigor/grader/build_text.hpp>
#include <rigor/grader/sandbox.hpp>
#include <rigor/grader/texts.hpp>

namespace rigor::grader {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Kind = FunctionStatus::Kind;

constexpr std::size_t longest_error = 400;
constexpr int most_rounds = 40;
constexpr const char* classes[] = {"Cuboid", "CollisionPlane", "ParticleSystem", "MatrixUtils"};

std::string clipped(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 32) c = ' ';
  if (text.size() > longest_error) text = text.substr(0, longest_error) + " ...";
  return text;
}

/// What Visual C++ lets pass and the standard does not, said in the student's terms.
std::string with_hint(const std::string& message) {
  if (message.find("cannot bind non-const lvalue reference") != message.npos)
    return message + " (Visual C++ lets a temporary bind to a reference; standard C++ does not: give the value a name "
                     "first, P3D p = ...; and pass p)";
  return message;
}

std::string kit_text(const std::string& path) {
  for (const Text& text : texts())
    if (text.path == "src/kit/" + path) return std::string(text.content);
  promise(false, "the kit has every file the build asks for");
  return "";
}

std::string squeezed(std::string_view text) {
  std::string s;
  for (const Token& t : tokens_of(text)) (s += t.text) += ' ';
  return s;
}

bool is_source(const std::string& name) {
  const std::string ending = name.substr(std::min(name.size(), name.rfind('.')));
  return ending == ".cpp" || ending == ".cc" || ending == ".cxx" || ending == ".c" || ending == ".CPP" || ending == ".C";
}

/// A file as it is compiled.
struct Source {
  std::string path{};     // as the student knows it
  std::string text{};
  bool own = true;       // the student's, or the kit's
  bool expected = true;  // one of the list, or another the student brought
  std::set<std::string> replaced{};  // names of the functions whose bodies were
};

class Builder {
 public:
  Builder(const Submission& submission, const BuildOptions& options, Toolchain tools)
      : options_(options), tools_(std::move(tools)) {
    bring_in(submission);
  }

  BuildResult run() {
    look_at_functions();
    for (int round = 0; round < most_rounds && interrupted() == 0; ++round) {
      changed_ = false;
      if (compile_all() && link()) {
        result_.executable = program_;
        break;
      }
      if (!changed_) break;
    }
    if (result_.executable.empty())
      for (FunctionStatus& f : result_.functions)
        if (f.kind == Kind::compiled) f = {Kind::not_compiled, last_error_};
    return std::move(result_);
  }

 private:
  // ---- What is there

  void bring_in(const Submission& s) {
    for (const std::string c : classes)
      for (const std::string ending : {".h", ".cpp"}) {
        const SourceFile* file = s.find(c + ending);
        sources_[c + ending] = file ? Source{file->path, file->text} : from_kit(c + ending);
      }
    if (const SourceFile* file = s.find("Constants.h");
        file && squeezed(file->text) != squeezed(kit_text("handout/Constants.h"))) {
      std::string text = file->text;
      for (const char* name : {"COEFF_RESITUTION", "COEFF_STATIC_FRICTION", "COEFF_DYNAMIC_FRICTION", "DELTA_T"})
        if (text.find(name) == text.npos) text += std::string("extern const double ") + name + ";\n";
      sources_["Constants.h"] = {file->path, text};
      result_.own_constants = true;
    }
    for (const SourceFile& file : s.others) {
      if (sources_.contains(file.name)) {
        note(file.path + ": not used, another file has the same name");
        continue;
      }
      sources_[file.name] = {file.path, file.text};
      sources_[file.name].expected = false;
    }
    std::vector<std::string> known;
    for (const Text& text : texts())
      if (text.path.starts_with("src/kit/include/")) known.emplace_back(text.path.substr(16));
    for (const char* name : {"Core", "Dense", "Eigen", "Geometry", "LU", "QR", "SVD", "Cholesky", "Eigenvalues",
                             "StdVector", "Sparse"})
      known.push_back(std::string("Eigen/") + name);
    for (const auto& [name, source] : sources_) known.push_back(name);
    for (auto& [name, source] : sources_) source.text = with_plain_includes(source.text, known);
  }

  static Source from_kit(const std::string& name) { return {name, kit_text("handout/" + name), false}; }

  void note(std::string text) {
    text = clipped(std::move(text));
    if (std::find(result_.notes.begin(), result_.notes.end(), text) == result_.notes.end())
      result_.notes.push_back(std::move(text));
  }

  FunctionStatus& status(StudentFunction f) { return result_.functions[std::size_t(f)]; }

  /// Where the student wrote it: in its own file or another.
  std::pair<Source*, Definition> find(const std::string& function) {
    for (auto& [name, source] : sources_)
      for (const Definition& d : definitions_of(source.text))
        if (d.name == function) return {&source, d};
    return {nullptr, {}};
  }

  void look_at_functions() {
    std::map<std::string, std::string> cut;  // by class: where a comment begins that never ends
    for (auto& [name, source] : sources_)
      if (const std::size_t at = unclosed_comment(source.text); at != source.text.npos) {
        const auto line = 1 + std::count(source.text.begin(), source.text.begin() + std::ptrdiff_t(at), '\n');
        const std::string where = source.path + ":" + std::to_string(line) + ": the comment that begins here never ends";
        cut[name.substr(0, name.rfind('.'))] = where;
        note(where);
        source.text.erase(at);
      }
    for (std::size_t i = 0; i < student_functions; ++i) {
      const StudentFunction f = StudentFunction(i);
      const std::string full = student_function_name(f);
      const auto [source, definition] = find(full);
      if (const auto begun = cut.find(full.substr(0, full.find(':'))); source == nullptr && begun != cut.end()) {
        status(f) = {Kind::not_compiled, begun->second};
      } else if (source == nullptr) {
        status(f) = {Kind::not_implemented, ""};
        note(full + " is not there");
      } else if (is_handed_out(f, std::string_view(source->text).substr(definition.body,
                                                                        definition.end - definition.body))) {
        status(f) = {Kind::not_implemented, ""};
      } else if (options_.replaced.contains(f)) {
        status(f) = {Kind::not_compiled, "replaced by the handed-out one on request"};
        source->text = with_body(source->text, definition, handed_out_body(f));
      }
    }
    for (const std::string c : classes) complete(c);
  }

  /// What a file left out of the handed-out one, at its end: functions its header declares, static members.
  void complete(const std::string& c) {
    Source& source = sources_[c + ".cpp"];
    if (!source.own) return;
    std::set<std::string> there, declared;
    for (const auto& [name, other] : sources_)
      for (const Definition& d : definitions_of(other.text)) there.insert(d.name);
    for (const Token& t : tokens_of(sources_[c + ".h"].text)) declared.insert(std::string(t.text));
    const std::string kit = kit_text("handout/" + c + ".cpp");
    std::string members, helpers, includes;
    std::vector<std::string> called;
    for (const Definition& d : definitions_of(kit)) {
      const std::string text = kit.substr(d.begin, d.end - d.begin) + "\n";
      const std::size_t scope = d.name.rfind("::");
      if (there.contains(d.name)) continue;
      if (scope == d.name.npos) called.push_back(text);
      else if (declared.contains(d.name.substr(d.name.find_first_not_of("~", scope + 2)))) members += text;
    }
    for (std::size_t at = 0, end; at < kit.size(); at = end + 1) {
      end = std::min(kit.find('\n', at), kit.size());
      const std::string line = kit.substr(at, end - at);
      if (line.starts_with("#include")) includes += line + "\n";
      // "bool ParticleSystem::drawParticles = true;"
      const std::size_t scope = line.find(c + "::"), equals = line.find(" = ");
      if (equals != line.npos && scope < equals && line.find('(') > equals && !line.starts_with(' ') &&
          source.text.find(line.substr(scope, equals - scope)) == std::string::npos)
        members += line + "\n";
    }
    if (members.empty()) return;
    for (const std::string& helper : called) helpers += helper;
    source.text += includes + helpers + members;
  }

  // ---- Compiling

  std::string headers_key() const {
    std::string all;
    for (const auto& [name, source] : sources_)
      if (!is_source(name)) all += key_of(name, source.text);
    return sha256(all);
  }

  /// Every file of the list, and the driver, as objects; false when something was replaced and it must go on.
  bool compile_all() {
    stage();
    std::vector<std::string> names;
    for (const auto& [name, source] : sources_)
      if (is_source(name) && source.expected) names.push_back(name);
    names.push_back("driver.cpp");
    names.push_back("constants.cpp");
    bool clean = true;
    std::vector<std::future<Compilation>> running;
    std::size_t next = 0;
    for (std::size_t done = 0; done < names.size(); ++done) {
      while (next < names.size() && next - done < std::size_t(std::max(1, options_.jobs)))
        running.push_back(std::async(std::launch::async, [this, name = names[next++]] { return object(name); }));
      const Compilation c = running[done].get();
      // errors under a header that is about to be replaced say nothing about the files
      if (!c.ok && headers_key() == headers_) repair(names[done], c);
      clean &= c.ok;
    }
    return clean;
  }

  void stage() {
    for (const auto& [name, source] : sources_) {
      const auto written = write_file(workshop_.src() / name, source.text);
      promise(bool(written), "a temporary directory can be written to");
    }
    headers_ = headers_key();
  }

  std::string source_of(const std::string& name) const {
    return sources_.contains(name) ? name : (tools_.kit / "driver" / name).string();
  }

  /// One object, from the cache when the same text under the same headers was compiled before.
  Compilation object(const std::string& name) {
    const auto at = sources_.find(name);
    const std::string key =
        key_of(tools_.key, headers_, name, at != sources_.end() ? at->second.text : std::string());
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
    if (at == sources_.end()) arguments.push_back("-fno-access-control");
    if (at != sources_.end()) arguments.push_back("-Dmain=main_of_the_submission");
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

  // ---- Repairing: what does not compile is replaced, and nothing else

  void repair(const std::string& name, const Compilation& c) {
    std::map<std::string, std::string> files;
    for (const auto& [file, source] : sources_) files[file];
    const std::vector<Diagnostic> errors = diagnostics_of(c.output, files);
    last_error_ = !c.stopped.empty() ? c.stopped : errors.empty() ? clipped(c.output) : shown(errors.front());
    changed_ |= repair_at(name, errors) || repair_headers(c.output);
  }

  bool repair_at(const std::string& name, const std::vector<Diagnostic>& errors) {
    if (!sources_.contains(name)) return false;
    for (const Diagnostic& e : errors)
      if (!e.missing.empty() && !e.file.empty() && leave_out_include(e)) return true;
    // Braces that do not match, and a broken header, make errors everywhere else: these first.
    bool replaced = false;
    for (const Diagnostic& e : errors)
      if (!e.file.empty()) replaced |= replace_unsound(sources_[e.file], e);
    if (replaced) return true;
    for (const Diagnostic& e : errors)
      if (!e.file.empty() && !is_source(e.file) && (replace_function_at(e) || give_up(e.file, e))) return true;
    for (const Diagnostic& e : errors)
      if (!e.file.empty()) replaced |= replace_function_at(e);
    if (replaced) return true;
    if (errors.empty() || errors.front().file.empty()) return give_up(name, {name, 0, last_error_, ""});
    return give_up(name, errors.front());
  }

  std::string shown(const Diagnostic& e) const {
    const auto at = sources_.find(e.file);
    const std::string where =
        at == sources_.end() ? "" : at->second.path + (e.line > 0 ? ":" + std::to_string(e.line) : "") + ": ";
    return clipped(where + with_hint(e.message));
  }

  bool leave_out_include(const Diagnostic& e) {
    std::string& text = sources_[e.file].text;
    std::size_t at = 0;
    for (int line = 1; line < e.line && at != text.npos; ++line) at = text.find('\n', at) + 1;
    const std::size_t end = std::min(text.find('\n', at), text.size());
    if (text.substr(at, end - at).find("include") == text.npos) return false;
    text.erase(at, end - at);
    note(sources_[e.file].path + ":" + std::to_string(e.line) + ": left out an include of " + e.missing +
         ", which is neither in the submission nor in the kit");
    return true;
  }

  /// The body that holds the error; false when there is none, or it has been replaced before.
  bool replace_function_at(const Diagnostic& e) {
    Source& source = sources_[e.file];
    for (const Definition& d : definitions_of(source.text))
      if (e.line >= d.first_line && e.line <= d.last_line) return replace(source, d, e);
    return false;
  }

  bool replace_unsound(Source& source, const Diagnostic& e) {
    bool replaced = false;
    const std::vector<Definition> all = definitions_of(source.text);
    for (auto d = all.rbegin(); d != all.rend(); ++d)  // from the end: the offsets before stay as they are
      if (!d->sound) replaced |= replace(source, *d, e);
    return replaced;
  }

  bool replace(Source& source, const Definition& d, const Diagnostic& e) {
    if (!source.replaced.insert(d.name).second) return false;
    std::string body = "{ throw \"" + d.name + " does not compile\"; }";
    bool graded = false;
    for (std::size_t i = 0; i < student_functions; ++i)
      if (student_function_name(StudentFunction(i)) == d.name) {
        status(StudentFunction(i)) = {Kind::not_compiled, shown(e)};
        body = handed_out_body(StudentFunction(i));
        graded = true;
      }
    if (!graded) {
      const std::string kit = kit_body(d.name);
      note(d.name + " does not compile, " + (kit.empty() ? "what calls it fails" : "the handed-out one is used") + ": " +
           shown(e));
      if (!kit.empty()) body = kit;
    }
    source.text = with_body(source.text, d, body);
    return true;
  }

  static std::string kit_body(const std::string& function) {
    for (const std::string c : classes) {
      const std::string text = kit_text("handout/" + c + ".cpp");
      for (const Definition& d : definitions_of(text))
        if (d.name == function) return text.substr(d.body, d.end - d.body);
    }
    return "";
  }

  /// The kit's file instead of the student's; false when it is that already, or there is none.
  bool give_up(const std::string& name, const Diagnostic& e) {
    Source& source = sources_[name];
    if (!source.own || (!source.expected && !is_source(name))) return false;
    if (name == "Constants.h") {
      sources_.erase(name);
      fs::remove(workshop_.src() / name);
      result_.own_constants = false;
      note("Constants.h does not compile, the grader's is used: " + shown(e));
      return true;
    }
    for (const Definition& d : definitions_of(source.text))
      for (std::size_t i = 0; i < student_functions; ++i)
        if (d.name == student_function_name(StudentFunction(i)) && status(StudentFunction(i)).kind == Kind::compiled)
          status(StudentFunction(i)) = {Kind::not_compiled, shown(e)};
    note(source.path + " does not compile, the handed-out file is used: " + shown(e));
    if (source.expected)
      source = from_kit(name);
    else
      sources_.erase(name);
    for (const std::string c : classes)
      if (name == c + ".h") complete(c);
    return true;
  }

  /// The driver, or the kit's file, does not fit the student's headers: the kit's headers for the classes it
  /// complains about, or for all.
  bool repair_headers(const std::string& output) {
    for (const bool all : {false, true}) {
      bool changed = false;
      for (const std::string c : classes) {
        const bool named = output.find("class " + c + "'") != output.npos || output.find(c + "::") != output.npos ||
                           output.find(c + ".h") != output.npos;
        if (named || all) changed |= give_up(c + ".h", {c + ".h", 0, last_error_, ""});
      }
      if (changed) return true;
    }
    return false;
  }

  // ---- Linking

  bool link() {
    std::string all = tools_.key;
    std::vector<std::string> arguments;
    for (const auto& [name, path] : objects_) {
      if (sources_.contains(name) && !sources_[name].expected) continue;
      all += key_of(path.string());
    }
    arguments = {"-Wl,--allow-multiple-definition"};
    if (!options_.sanitize) arguments.insert(arguments.end(), {"-static", "-s"});  // the address sanitizer cannot be static
    for (const char* first : {"driver.cpp", "constants.cpp"}) arguments.push_back(staged_object(first));
    for (const auto& [name, source] : sources_)
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
    last_error_ = clipped(c.stopped.empty() ? first_link_error(c.output) : c.stopped);
    if (!linked_others_) {
      changed_ = linked_others_ = true;
      compile_others();
    } else {
      replace_unlinked(c.output);
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
    for (auto& [name, source] : sources_) {
      if (!is_source(name) || source.expected) continue;
      const Compilation c = object(name);
      if (c.ok) {
        others_.insert(name);
        note(source.path + " is linked as well");
      } else {
        note(source.path + " does not compile and is left out: " + clipped(c.output));
      }
    }
  }

  static std::string first_link_error(const std::string& output) {
    for (const char* sign : {"undefined reference", "multiple definition"})
      if (const std::size_t at = output.find(sign); at != output.npos)
        return "the linker: " + output.substr(at, output.find('\n', at) - at);
    return "the linker: " + output.substr(0, longest_error);
  }

  /// "Cuboid.cpp.o: in function `Cuboid::update(double)':" then what it misses: that function is replaced.
  void replace_unlinked(const std::string& output) {
    for (std::size_t at = 0; (at = output.find("in function `", at)) != output.npos;) {
      at += 13;
      const std::string function = output.substr(at, output.find_first_of("('\n", at) - at);
      const std::size_t missing = output.find("undefined reference to", at);
      const std::string what = missing == output.npos
                                   ? last_error_ : output.substr(missing, output.find('\n', missing) - missing);
      const auto [source, definition] = find(function);
      if (source == nullptr) continue;
      for (auto& [name, candidate] : sources_)
        if (&candidate == source) changed_ |= replace(*source, definition, {name, definition.first_line, what, ""});
    }
  }

  const BuildOptions& options_;
  Toolchain tools_;
  Workshop workshop_;
  std::map<std::string, Source> sources_;
  std::map<std::string, fs::path> objects_;
  std::set<std::string> others_;
  bool linked_others_ = false, changed_ = false;
  std::string headers_, last_error_;
  fs::path program_;
  std::mutex lock_;
  BuildResult result_;
};

// ---- A result kept: the same submission is not looked at twice

Json json_of(const BuildResult& r) {
  Json functions = Json::array();
  for (const FunctionStatus& f : r.functions) functions.push_back({int(f.kind), f.error});
  return {{"executable", r.executable.string()}, {"functions", functions}, {"own_constants", r.own_constants},
          {"notes", r.notes}};
}

bool read_kept(const fs::path& path, BuildResult& r) {
  const auto text = read_file(path);
  if (!text) return false;
  const Json kept = Json::parse(*text, nullptr, false);
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
