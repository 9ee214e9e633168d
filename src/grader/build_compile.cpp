#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <rigor/base/file.hpp>
#include <rigor/base/interrupt.hpp>
#include <rigor/base/promise.hpp>
#include <rigor/grader/build_compile.hpp>
#include <rigor/grader/build_hash.hpp>
#include <rigor/grader/sandbox.hpp>
#include <rigor/grader/texts.hpp>

namespace rigor::grader {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t compiler_cpu_s = 30, compiler_memory = 3ull << 30, compiler_file = 256u << 20;
constexpr double compiler_wall_s = 300;  // a machine busy with others gives less than it asks for

Compilation run(std::vector<std::string> argv, const fs::path& directory, std::vector<fs::path> readable,
                std::vector<fs::path> writable) {
  int out[2];
  promise(pipe2(out, O_CLOEXEC) == 0, "a pipe can be had");
  const int null = open("/dev/null", O_RDONLY | O_CLOEXEC);
  const Confined what{Profile::compiler, std::move(argv), directory.string(), std::move(readable),
                      std::move(writable), {null, out[1], out[1]},
                      {compiler_cpu_s, compiler_memory, compiler_file}};
  Outcome<Child> started = start(what);
  close(null);
  close(out[1]);
  Compilation c;
  if (!started) {
    close(out[0]);
    c.stopped = started.fault().what;
    return c;
  }
  const Course course = run_to_end(*started, out[0], compiler_wall_s);
  close(out[0]);
  c.output = course.output;
  c.ok = WIFEXITED(course.status) && WEXITSTATUS(course.status) == 0;
  if (interrupted() != 0)
    c.stopped = "interrupted";
  else if (course.late || c.output.find("CPU time limit") != c.output.npos || c.output.find("Killed") != c.output.npos)
    c.stopped = "the compiler needed more than " + std::to_string(compiler_cpu_s) + " s";
  else if (c.output.find("File size limit") != c.output.npos)
    c.stopped = "the program is larger than " + std::to_string(compiler_file >> 20) + " MiB";
  else if (c.output.find("virtual memory exhausted") != c.output.npos || c.output.find("out of memory") != c.output.npos)
    c.stopped = "the compiler needed more than " + std::to_string(compiler_memory >> 30) + " GiB";
  return c;
}

/// The empty path when none does.
fs::path first_that_exists(const std::vector<fs::path>& paths) {
  for (const fs::path& path : paths)
    if (std::error_code ec; fs::exists(path, ec)) return path;
  return {};
}

bool in_kit(const Text& text) {
  return text.path.starts_with("src/kit/") || text.path == "src/grader/protocol.hpp";
}

/// Ours to write, everybody's to read and to pass through.
Outcome<bool> open_directory(const fs::path& path) {
  const Fault fault{Fault::Kind::unwritable, path.string(), "cannot be used as a cache: "};
  std::error_code ec;
  fs::create_directories(path, ec);
  struct stat info {};
  if (ec || stat(path.c_str(), &info) != 0) return Fault{fault.kind, fault.where, fault.what + ec.message()};
  if (info.st_uid != geteuid()) return Fault{fault.kind, fault.where, fault.what + "it belongs to somebody else"};
  if (access(path.c_str(), W_OK) != 0) return Fault{fault.kind, fault.where, fault.what + "it cannot be written to"};
  fs::permissions(path, fs::perms(0755), ec);
  if (const fs::path closed = closed_to_confined(path); !closed.empty())
    return Fault{fault.kind, fault.where, fault.what + "the compiler runs as nobody, who may not pass through " +
                                              closed.string() + " (set RIGOR_CACHE to another place)"};
  return true;
}

}  // namespace

bool copy_whole(const fs::path& from, const fs::path& to) {
  // The source may have been written by a confined compiler: an ordinary file or nothing.
  std::error_code ec;
  if (fs::symlink_status(from, ec).type() != fs::file_type::regular) return false;
  fs::create_directories(to.parent_path(), ec);
  std::string part = to.string() + ".part-XXXXXX";
  const int fd = mkstemp(part.data());
  if (fd < 0) return false;
  close(fd);
  fs::copy_file(from, part, fs::copy_options::overwrite_existing, ec);
  if (!ec) fs::permissions(part, fs::perms(0755), ec);
  if (!ec) fs::rename(part, to, ec);
  if (!ec) return true;
  std::error_code ignored;
  fs::remove(part, ignored);
  return false;
}

Workshop::Workshop() {
  fs::path place = fs::temp_directory_path();
  if (!closed_to_confined(place).empty()) place = "/tmp";  // a TMPDIR inside root's home
  std::string pattern = (place / "rigor-build-XXXXXX").string();
  promise(mkdtemp(pattern.data()) != nullptr, "a temporary directory can be made");
  root_ = pattern;
  fs::permissions(root_, fs::perms(0755));
  fs::create_directory(src());
  fs::create_directory(out());
  promise(hand_over(out()), "a directory can be handed over to the compiler's user");
}

Workshop::~Workshop() {
  std::error_code ec;
  fs::remove_all(root_, ec);
}

Compilation compile(const Toolchain& tools, const Workshop& workshop, const std::vector<std::string>& arguments) {
  std::vector<std::string> argv{tools.compiler.string()};
  argv.insert(argv.end(), tools.flags.begin(), tools.flags.end());
  argv.insert(argv.end(), arguments.begin(), arguments.end());
  return run(std::move(argv), workshop.src(), {tools.kit, tools.eigen, workshop.src()}, {workshop.out()});
}

Outcome<Toolchain> toolchain(const fs::path& cache, bool sanitize) {
  using Kind = Fault::Kind;
  Toolchain tools;
  tools.compiler = first_that_exists({"/usr/bin/g++", "/usr/local/bin/g++"});
  if (tools.compiler.empty())
    return Fault{Kind::unsupported, "", "submissions need g++, which is not installed (package g++)"};
  const char* bundled = std::getenv("RIGOR_EIGEN");  // an exported grader brings it
  tools.eigen = first_that_exists({bundled != nullptr ? bundled : "", "/usr/include/eigen3", "/usr/local/include/eigen3"});
  if (tools.eigen.empty())
    return Fault{Kind::unsupported, "", "submissions need Eigen, which is not installed (package libeigen3-dev)"};
  if (const fs::path closed = closed_to_confined(tools.eigen); !closed.empty())
    return Fault{Kind::unreadable, tools.eigen.string(), "the compiler runs as nobody, who may not pass through " + closed.string()};
  if (const auto usable = open_directory(cache); !usable) return usable.fault();
  tools.cache = cache;

  const Compilation version = run({tools.compiler.string(), "-dumpfullversion", "-dumpmachine"}, "/", {}, {});
  if (!version.ok) return Fault{Kind::unsupported, tools.compiler.string(), "does not run: " + version.output};
  tools.flags = {"-std=gnu++14", "-O1", "-w", "-fpermissive", "-ffp-contract=off", "-pipe", "-fmax-errors=60",
                 "-fno-diagnostics-show-caret", "-fdiagnostics-color=never", "-ftemplate-backtrace-limit=4",
                 "-DEIGEN_DONT_VECTORIZE"};
  // What a student left uninitialised is the same nonsense in every run: a grade that stands.
  if (std::atoi(version.output.c_str()) >= 12) tools.flags.push_back("-ftrivial-auto-var-init=pattern");
  if (sanitize)
    // (the check of virtual calls asks for a pipe, which the filter refuses, and then takes every object for a wrong one)
    for (const char* flag : {"-g", "-fsanitize=address,undefined", "-fno-sanitize=vptr", "-fno-sanitize-recover=undefined"})
      tools.flags.push_back(flag);

  std::string all = key_of(version.output, tools.eigen.string());
  for (const std::string& flag : tools.flags) all += key_of(flag);
  for (const Text& text : texts())
    if (in_kit(text)) all += key_of(text.path, text.content);
  tools.key = sha256(all).substr(0, 24);
  tools.kit = cache / ("kit-" + tools.key);
  for (const fs::path& dir : {tools.kit / "include", tools.kit, tools.eigen})
    tools.flags.insert(tools.flags.end(), {"-isystem", dir.string()});
  std::error_code ec;
  if (fs::exists(tools.kit / "include" / "kit.hpp.gch", ec)) return tools;

  for (const Text& text : texts()) {
    if (!in_kit(text)) continue;
    const fs::path path = text.path;
    const fs::path to = text.path.starts_with("src/kit/") ? path.lexically_relative("src/kit") : path.filename();
    if (const auto written = write_file(tools.kit / to, std::string(text.content)); !written) return written.fault();
  }
  const Workshop workshop;
  const fs::path made = workshop.out() / "kit.hpp.gch";
  const Compilation header = compile(tools, workshop, {"-x", "c++-header", (tools.kit / "include/kit.hpp").string(),
                                                       "-o", made.string()});
  if (!header.ok)
    return Fault{Kind::unsupported, "", "the kit does not compile here: " + header.stopped + header.output.substr(0, 1000)};
  if (!copy_whole(made, tools.kit / "include" / "kit.hpp.gch"))
    return Fault{Kind::unwritable, tools.kit.string(), "cannot be written"};
  return tools;
}

std::vector<Diagnostic> diagnostics_of(const std::string& output, const std::map<std::string, std::string>& files) {
  std::vector<Diagnostic> all;
  Diagnostic asked;  // the last place in the submission that asked for a template
  for (std::size_t at = 0; at < output.size();) {
    const std::size_t end = std::min(output.find('\n', at), output.size());
    const std::string line = output.substr(at, end - at);
    at = end + 1;
    // file:line:column: error: message
    const std::size_t colon = line.find(':');
    if (colon == line.npos) continue;
    char* rest = nullptr;
    const long number = std::strtol(line.c_str() + colon + 1, &rest, 10);
    Diagnostic here;
    if (const std::string name = line.substr(0, colon); files.contains(name) && number > 0)
      here = {name, int(number), "", ""};
    if (line.find("required from") != line.npos) {
      if (!here.file.empty()) asked = here;
      continue;
    }
    std::size_t message = line.find(": error: ");
    std::size_t skip = 9;
    if (message == line.npos) message = line.find(": fatal error: "), skip = 15;
    if (message == line.npos) continue;
    if (here.file.empty()) here = asked;
    asked = {};
    here.message = line.substr(message + skip);
    if (const std::size_t none = here.message.find(": No such file or directory"); none != line.npos)
      here.missing = here.message.substr(0, none);
    all.push_back(here);
  }
  return all;
}

}  // namespace rigor::grader
