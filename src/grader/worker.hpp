#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <rigor/grader/protocol.hpp>
#include <string>
#include <variant>
#include <vector>

namespace rigor::grader {

/// The values behind COEFF_RESITUTION, COEFF_STATIC_FRICTION, COEFF_DYNAMIC_FRICTION and DELTA_T (s), fixed for a
/// process before its static constructors run. Not seen by a submission with its own Constants.h.
struct Constants {
  double restitution = 0.5;
  double static_friction = 0.5;
  double dynamic_friction = 0.3;
  double delta_t = 1.0 / 240;
};

struct Limits {
  double call_s = 0.5;                           ///< processor time and sleep of one call; ten times that on the wall
  double total_s = 60;                           ///< processor time of one process; at half a new one takes its place
  std::uint64_t memory_bytes = 512u << 20;       ///< address space
  std::uint64_t output_bytes = 64u << 20;        ///< what it may print in one call; 64 KiB of it are kept
};

/// Why a call got no reply. The next call works all the same: in a new process where the old one is gone.
struct Death {
  enum class Kind {
    crash,    ///< a signal, or an exception that came out of the student's function
    timeout,
    memory,
    exited,   ///< exit() or the like inside the function
    flood,    ///< printed more than the limit
    absent,   ///< the submission has no such function
    unstarted,  ///< it ended before main; said again at once by every later call
  };
  Kind kind;
  std::string words;  ///< "stopped by a segmentation fault (memory that is not its own)"
};

/// `seconds`: what the call took of its own, processor time and sleep, whatever else the machine was doing.
struct Answer : std::variant<Reply, Death> {
  using variant::variant;
  double seconds = 0;
};

/// Runs a student's code in a process of its own, locked down as far as the machine allows. The process is
/// started by the first call and again by the first call after a death; everything is killed and reaped by then.
/// Use one from one thread: a process dies with the thread that started it, another thread gets a new one.
class Worker {
 public:
  Worker(std::filesystem::path executable, Constants constants, Limits limits = {});
  ~Worker();
  Worker(Worker&&) noexcept;
  Worker& operator=(Worker&&) noexcept;

  /// Fills in magic and serial. A reply has Status::done and the request's serial. `seconds` > 0 replaces
  /// Limits::call_s for this call (a whole scene takes longer than one impulse).
  Answer call(Request request, double seconds = 0);

  /// What the student's code printed since the last time, stdout and stderr together, at most 64 KiB.
  std::string take_output();

  /// Processes started so far.
  int starts() const;

  /// The layers in force, one line each: "bubblewrap: own user, process, network, mount ... namespaces",
  /// "system calls: allow-list", "limits: ...", or "process only: ..." and what is missing. Known after a call.
  std::vector<std::string> isolation() const;

 private:
  struct Process;
  std::unique_ptr<Process> process_;
};

}  // namespace rigor::grader
