#pragma once
#include <sys/types.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <rigor/base/outcome.hpp>
#include <string>
#include <vector>

namespace rigor::grader {

/// What a confined process is: a worker runs a student's code, a compiler only reads it, a sanitizer runs it with the
/// system's libraries and /proc in sight, which the sanitizers need; nothing it says is a grade.
enum class Profile { worker, compiler, sanitizer };

struct ProcessLimits {
  std::uint64_t cpu_s, memory_bytes, file_bytes;
};

/// A program to run locked down as far as this machine allows, in layers: a user of its own (nobody) when we are
/// root, bubblewrap namespaces with nothing in them but what is listed, resource limits, a system-call filter that
/// holds before the program's first instruction.
struct Confined {
  Profile profile;
  std::vector<std::string> argv;                 ///< argv[0] an absolute path
  std::string directory = "/";                   ///< to run in
  std::vector<std::filesystem::path> readable;   ///< files and directories it sees, at the same path
  std::vector<std::filesystem::path> writable;   ///< directories it may write to
  std::vector<int> descriptors;                  ///< become its descriptors 0, 1, 2 ...; nothing else is open
  ProcessLimits limits;
};

/// A running one. Not a value: end() before it is forgotten.
class Child {
 public:
  Child() = default;
  explicit operator bool() const { return pid_ > 0; }

  /// Processor seconds used by the program itself so far; negative when that cannot be known.
  double cpu_seconds() const;
  /// Whether it waits for something other than a processor just now (a sleep, a read without end).
  bool waits() const;
  /// True once it has ended by itself, for which it has `seconds`, and nothing it started is left; then status() is what
  /// waitpid said of it.
  bool ended(double seconds = 0);
  /// Kills it with all it started and reaps it. The status is the first of both: how it ended, or by our hand.
  int end();
  int status() const { return status_; }

 private:
  friend Outcome<Child> start(const Confined& what);
  pid_t first_inside() const;
  void await_inside();
  pid_t program() const;  // the program itself, as seen from here; 0 when that cannot be known
  pid_t pid_ = -1;           // bubblewrap, or the program itself
  mutable pid_t program_ = 0;  // once known
  mutable pid_t inside_ = 0; // the first process inside the namespaces, as seen from here
  mutable int inside_handle_ = -1;  // a descriptor of that process, which its number cannot outlive
  int information_ = -1;           // where bubblewrap tells it
  mutable bool asked_ = false;     // whether that has been read
  int status_ = 0;
  bool reaped_ = false;
};

/// How a confined process came to its end, and what it wrote until then.
struct Course {
  std::string output;     ///< the first 256 KiB
  bool late = false;      ///< it was still writing when its time was used up
  bool by_itself = false; ///< it ended; otherwise it was ended: late, interrupted, or silent and going on
  int status = 0;
};
/// Reads what `child` writes to the other end of `out` until that is closed, `seconds` are used up or the program is
/// interrupted; then the child is ended.
Course run_to_end(Child child, int out, double seconds);

/// Faults: unsupported (fork refused). A program that cannot be executed ends by itself with status 127. To be
/// called and ended from one thread: the process dies with the thread that started it.
Outcome<Child> start(const Confined& what);

/// The layers this machine allows, one line each, in plain words. Tried once, then remembered.
std::vector<std::string> isolation(Profile profile);

/// A signal in plain words: "a segmentation fault (it touched memory that is not its own)".
std::string signal_words(int number);

/// To be called by whoever makes files for a confined process: gives them to the user it runs as.
bool hand_over(const std::filesystem::path& path);

/// The first directory on the way to `path` that user may not pass through (a home directory of root's); empty
/// when there is none.
std::filesystem::path closed_to_confined(const std::filesystem::path& path);

}  // namespace rigor::grader
