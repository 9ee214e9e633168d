#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <optional>
#include <rigor/base/promise.hpp>
#include <rigor/grader/sandbox.hpp>
#include <rigor/grader/worker.hpp>
#include <thread>

namespace rigor::grader {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kept_output = 64u << 10;
constexpr double wall_per_cpu = 10;  // a machine busy with others may give a call this much less than it asks for

std::string hex_bits(double x) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(std::bit_cast<std::uint64_t>(x)));
  return text;
}

std::string seconds_words(double s) {
  char text[32];
  std::snprintf(text, sizeof text, "%g s", s);
  return text;
}

}  // namespace

struct Worker::Process {
  std::filesystem::path executable;
  Constants constants;
  Limits limits;
  Child child;
  std::thread::id owner;          // the process dies with the thread that started it
  int channel = -1, printed = -1;  // ours: requests and replies; what it prints
  std::uint64_t serial = 0, printed_now = 0;
  double spent = 0;  // of the call in hand: processor time and sleep, s
  std::string output;
  int starts = 0;
  std::optional<Death> never_starts;

  bool running() const { return channel >= 0; }

  ~Process() { stop(); }

  void stop() {
    if (!running()) return;
    child.end();
    drain();
    close(channel);
    close(printed);
    channel = printed = -1;
    child = Child();
  }

  void drain() {
    char buffer[16 << 10];
    for (ssize_t n; (n = read(printed, buffer, sizeof buffer)) > 0 || (n < 0 && errno == EINTR);) {
      if (n < 0) continue;
      printed_now += std::uint64_t(n);
      output.append(buffer, std::min(std::size_t(n), kept_output - std::min(kept_output, output.size())));
    }
  }

  Outcome<bool> launch() {
    int both[2], out[2];
    promise(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, both) == 0 && pipe2(out, O_CLOEXEC) == 0,
            "descriptors for a worker can be had");
    const int null = open("/dev/null", O_RDONLY | O_CLOEXEC);
    Confined what{Profile::worker, {executable.string(), hex_bits(constants.restitution),
                                    hex_bits(constants.static_friction), hex_bits(constants.dynamic_friction),
                                    hex_bits(constants.delta_t)},
                  "/", {executable}, {}, {null, out[1], out[1], both[1], both[1]},
                  {std::uint64_t(limits.total_s) + 1, limits.memory_bytes, 0}};
    const Outcome<Child> started = start(what);
    close(null);
    close(out[1]);
    close(both[1]);
    if (!started) {
      close(out[0]);
      close(both[0]);
      return started.fault();
    }
    child = *started;
    owner = std::this_thread::get_id();
    channel = both[0];
    printed = out[0];
    fcntl(printed, F_SETFL, O_NONBLOCK);
    ++starts;
    return true;
  }

  /// How it went, seen from outside: only when it left without last words.
  Death how_it_ended() {
    if (!child.ended(1)) return {Death::Kind::exited, "closed the descriptors it answers on"};
    const int status = child.status();
    drain();
    int number = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    if (code > 128 && code < 160) number = code - 128;  // bubblewrap's way of passing a signal on
    if (number == SIGXCPU || number == SIGKILL)
      return {Death::Kind::timeout, "used more than " + seconds_words(limits.total_s) + " of processor time in all"};
    if (number != 0) return {Death::Kind::crash, "stopped by " + signal_words(number)};
    return {Death::Kind::exited, "ended the program itself (exit status " + std::to_string(code) + ")"};
  }

  double cpu_now() const { return std::max(child.cpu_seconds(), 0.0); }

  /// Waits for one reply; the process may take `seconds` of its own for it: processor time after `begun_at`, and sleep.
  /// Sleep is what is seen asleep while no reply has come: a process that waits for a busy machine does not sleep.
  /// `starting`: sleep is not its own but the sandbox's, which waits for the system while it is set up.
  Answer await(double seconds, double begun_at, bool starting = false) {
    Reply reply;
    std::size_t have = 0;
    const auto begun = Clock::now();
    const double look = std::max(0.01, seconds / 50);
    double slept = 0, cpu_before = begun_at, looked = 0;
    for (spent = 0;;) {
      const double wall = std::chrono::duration<double>(Clock::now() - begun).count();
      if (wall - looked >= look) {
        const double cpu = cpu_now();
        if (!starting && cpu == cpu_before && child.waits()) slept += look;
        cpu_before = cpu;
        looked = wall;
        spent = std::max(0.0, cpu - begun_at) + slept;
        if (wall >= wall_per_cpu * seconds || spent >= seconds)
          return Death{Death::Kind::timeout, "took longer than " + seconds_words(spent >= seconds || !starting ? seconds : wall_per_cpu * seconds) +
                                                 (starting ? " to start" : " for one call")};
      }
      pollfd fds[] = {{channel, POLLIN, 0}, {printed, POLLIN, 0}};
      const int events = poll(fds, printed_now > limits.output_bytes ? 1 : 2, int(1000 * look) + 1);
      if (events < 0 && errno != EINTR) promise(false, "poll on a worker's descriptors works");
      if (events <= 0) continue;
      if (fds[1].revents & POLLIN) {
        drain();
        if (printed_now > limits.output_bytes)
          return Death{Death::Kind::flood,
                       "flooded its output: printed more than " + std::to_string(limits.output_bytes >> 20) + " MiB in one call"};
      }
      if (fds[0].revents & (POLLIN | POLLHUP)) {
        const ssize_t n = read(channel, reinterpret_cast<char*>(&reply) + have, sizeof reply - have);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return how_it_ended();
        have += std::size_t(n);
        if (have == sizeof reply) break;
      } else if (fds[1].revents & POLLHUP) {
        // it closed what it prints to: look at the channel alone, without spinning
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    }
    drain();
    spent = std::max(0.0, cpu_now() - begun_at) + slept;
    if (reply.magic != reply_magic || reply.serial != serial)
      return Death{Death::Kind::crash, "sent something that is no reply (it wrote to a descriptor not its own)"};
    return reply;
  }

  Answer ask(Request request, double seconds) {
    request.magic = request_magic;
    request.serial = ++serial;
    printed_now = 0;
    const double begun_at = cpu_now();
    const char* at = reinterpret_cast<const char*>(&request);
    for (std::size_t left = sizeof request; left > 0;) {
      const ssize_t n = send(channel, at, left, MSG_NOSIGNAL);
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) break;  // it has ended; await() says how
      at += n;
      left -= std::size_t(n);
    }
    const Answer answer = await(seconds, begun_at);
    const Reply* reply = std::get_if<Reply>(&answer);
    if (reply == nullptr) return stop(), answer;
    switch (Status(reply->status)) {
      case Status::done: return answer;
      case Status::unknown_function: return Death{Death::Kind::absent, "the submission has no such function"};
      case Status::threw: {
        std::string what(reply->text, strnlen(reply->text, sizeof reply->text));
        for (char& c : what)
          if (static_cast<unsigned char>(c) < 32) c = ' ';
        return Death{Death::Kind::crash, "threw an exception" + (what.empty() ? "" : ": " + what)};
      }
      case Status::out_of_memory:
        return Death{Death::Kind::memory, "asked for more than " + std::to_string(limits.memory_bytes >> 20) +
                                              " MiB of memory"};
      case Status::crashed: {
        const int number = int(reply->signal);
        const bool deep = reply->stack_overflow != 0;
        stop();
        if (deep) return Death{Death::Kind::memory, "ran out of stack (recursion without end, or huge local arrays)"};
        return Death{Death::Kind::crash, "stopped by " + signal_words(number)};
      }
    }
    stop();
    return Death{Death::Kind::crash, "sent something that is no reply (it wrote to a descriptor not its own)"};
  }

  Answer call(const Request& request, double seconds) {
    if (running() && owner != std::this_thread::get_id()) stop();
    if (never_starts) return *never_starts;
    if (running() && cpu_now() >= limits.total_s / 2) stop();  // no call pays for those before it
    if (!running()) {
      if (const auto launched = launch(); !launched)
        return *(never_starts = Death{Death::Kind::unstarted, launched.fault().what});
      // The first words a driver says, serial 0, before any call: from here on a fault is the function's own.
      serial = 0;
      printed_now = 0;
      const auto hello = await(std::max(limits.call_s, 2.0), 0, true);
      if (const Death* death = std::get_if<Death>(&hello)) {
        never_starts = Death{Death::Kind::unstarted, "before main (in a static constructor): " + death->words};
        stop();
        return *never_starts;
      }
    }
    Answer answer = ask(request, seconds > 0 ? seconds : limits.call_s);
    answer.seconds = spent;
    return answer;
  }
};

Worker::Worker(std::filesystem::path executable, Constants constants, Limits limits)
    : process_(std::make_unique<Process>()) {
  process_->executable = std::move(executable);
  process_->constants = constants;
  process_->limits = limits;
}
Worker::~Worker() = default;
Worker::Worker(Worker&&) noexcept = default;
Worker& Worker::operator=(Worker&&) noexcept = default;

Answer Worker::call(Request request, double seconds) { return process_->call(request, seconds); }
std::string Worker::take_output() { return std::exchange(process_->output, {}); }
int Worker::starts() const { return process_->starts; }
std::vector<std::string> Worker::isolation() const { return grader::isolation(Profile::worker); }

}  // namespace rigor::grader
