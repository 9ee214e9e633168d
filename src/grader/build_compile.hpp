#pragma once
#include <filesystem>
#include <map>
#include <rigor/base/outcome.hpp>
#include <string>
#include <vector>

namespace rigor::grader {

/// The compiler of this machine, the kit unpacked in the cache with its precompiled header, and the flags.
struct Toolchain {
  std::filesystem::path compiler, eigen, kit, cache;
  std::vector<std::string> flags;
  std::string key;  ///< changes with compiler, flags or kit: everything made is named after it
};

/// Unpacks the kit and precompiles its headers where that has not been done (some 3 s). Faults: unsupported (no
/// g++, no Eigen, a kit that does not compile here), unwritable (cache).
Outcome<Toolchain> toolchain(const std::filesystem::path& cache, bool sanitize);

/// A directory of its own for one submission, gone with the value: src to read, out for the compiler to write.
class Workshop {
 public:
  Workshop();
  ~Workshop();
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;
  std::filesystem::path src() const { return root_ / "src"; }
  std::filesystem::path out() const { return root_ / "out"; }

 private:
  std::filesystem::path root_;
};

/// What a run of the compiler or linker gave.
struct Compilation {
  bool ok = false;
  std::string output;  ///< what it said, at most 256 KiB
  std::string stopped;  ///< not empty when it was stopped: "the compiler needed more than 30 s"
};

/// Runs the compiler confined, in workshop.src().
Compilation compile(const Toolchain& tools, const Workshop& workshop, const std::vector<std::string>& arguments);

/// What was said about one place.
struct Diagnostic {
  std::string file;     ///< "Cuboid.cpp"; empty when no file of the submission is named
  int line = 0;
  std::string message;  ///< "'x' was not declared in this scope"
  std::string missing;  ///< the header that is not there
};

/// The errors of a compilation, each at the place in the submission it comes from: an error inside a library's
/// template is put where it was asked for. `files` are the submission's.
std::vector<Diagnostic> diagnostics_of(const std::string& output, const std::map<std::string, std::string>& files);

/// A copy made whole or not at all.
bool copy_whole(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace rigor::grader
