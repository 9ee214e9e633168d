#include <fcntl.h>
#include <poll.h>
#include <linux/landlock.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <rigor/base/interrupt.hpp>
#include <rigor/base/promise.hpp>
#include <rigor/grader/sandbox.hpp>
#include <rigor/grader/seccomp.hpp>
#include <thread>

namespace rigor::grader {
namespace {

namespace fs = std::filesystem;

constexpr uid_t nobody = 65534;
constexpr int information_fd = 10, filter_fd = 11, first_free_fd = 12, parking_fd = 20;

std::vector<std::string> environment_of(const Confined& what) {
  return {"PATH=/usr/bin:/bin", "LC_ALL=C", "HOME=/tmp",
          "TMPDIR=" + (what.writable.empty() ? "/tmp" : what.writable.front().string())};
}

std::vector<char*> as_array(const std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

/// Becomes nobody for good; false where we are root in name only (a container without that user).
bool become_nobody() {
  return syscall(SYS_setgroups, 0, nullptr) == 0 && syscall(SYS_setresgid, nobody, nobody, nobody) == 0 &&
         syscall(SYS_setresuid, nobody, nobody, nobody) == 0;
}

/// Landlock: the kernel lets this process read below `readable` and write below `writable`, and nowhere else. The
/// fall-back where there are no mount namespaces; false where the kernel has none either. Allocates nothing.
bool keep_to(const std::vector<fs::path>& readable, const std::vector<fs::path>& writable) {
  constexpr std::uint64_t read_rights =
      LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
  constexpr std::uint64_t file_rights =
      LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_WRITE_FILE;
  constexpr std::uint64_t all_rights = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1) - 1;
  landlock_ruleset_attr handled{};
  handled.handled_access_fs = all_rights;
  const int rules = int(syscall(SYS_landlock_create_ruleset, &handled, sizeof handled, 0));
  if (rules < 0) return false;
  const auto allow = [rules](const char* path, std::uint64_t rights) {
    landlock_path_beneath_attr below{};
    below.parent_fd = open(path, O_PATH | O_CLOEXEC);
    if (below.parent_fd < 0) return;
    struct stat kind{};
    const bool directory = fstat(below.parent_fd, &kind) == 0 && S_ISDIR(kind.st_mode);
    below.allowed_access = directory ? rights : rights & file_rights;  // the kernel refuses a file the rights of a directory
    syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &below, 0);
    close(below.parent_fd);
  };
  for (const char* system : {"/usr", "/bin", "/lib", "/lib32", "/lib64"}) allow(system, read_rights);
  for (const fs::path& path : readable) allow(path.c_str(), read_rights);
  for (const fs::path& path : writable) allow(path.c_str(), all_rights);
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && syscall(SYS_landlock_restrict_self, rules, 0) == 0;
}

/// What happens in a child of ours, and whether it ended with status 0. Nothing it prints is seen.
template <class Action>
bool succeeds(Action action) {
  const pid_t pid = fork();
  if (pid < 0) return false;
  if (pid == 0) {
    const int null = open("/dev/null", O_RDWR | O_CLOEXEC);
    for (int fd = 0; fd < 3; ++fd) dup2(null, fd);
    _exit(action() ? 0 : 1);
  }
  int status = 0;
  while (waitpid(pid, &status, 0) < 0 && errno == EINTR) continue;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

const char* bubblewrap_path() {
  for (const char* path : {"/usr/bin/bwrap", "/bin/bwrap", "/usr/local/bin/bwrap"})
    if (access(path, X_OK) == 0) return path;
  return nullptr;
}

/// What this machine allows, found out by trying.
struct Layers {
  bool drops_user, namespaces, filter, landlock;
  const char* bubblewrap;
};

const Layers& layers() {
  static const Layers found = [] {
    Layers l{};
    l.drops_user = geteuid() == 0 && succeeds(become_nobody);
    l.filter = succeeds([] { return install(compiler_filter()); });
    l.landlock = succeeds([] { return keep_to({}, {}); });
    l.bubblewrap = bubblewrap_path();
    l.namespaces = l.bubblewrap != nullptr && succeeds([&l] {
      if (l.drops_user && !become_nobody()) return false;
      const char* argv[] = {l.bubblewrap, "--unshare-all", "--ro-bind", "/", "/", "/bin/true", nullptr};
      execv(l.bubblewrap, const_cast<char**>(argv));
      return false;
    });
    return l;
  }();
  return found;
}

std::vector<std::string> bubblewrap_arguments(const Confined& what) {
  std::vector<std::string> all{layers().bubblewrap, "--unshare-all", "--die-with-parent", "--new-session",
                               "--cap-drop", "ALL", "--clearenv",
                               "--info-fd", std::to_string(information_fd)};
  const auto add = [&all](std::initializer_list<std::string> words) { all.insert(all.end(), words); };
  for (const std::string& variable : environment_of(what))
    add({"--setenv", variable.substr(0, variable.find('=')), variable.substr(variable.find('=') + 1)});
  if (layers().filter) add({"--seccomp", std::to_string(filter_fd)});
  if (what.profile == Profile::sanitizer) add({"--proc", "/proc"});
  if (what.profile != Profile::worker) {
    add({"--ro-bind", "/usr", "/usr", "--tmpfs", "/tmp"});
    for (const char* dir : {"/bin", "/lib", "/lib32", "/lib64", "/libx32"}) {
      std::error_code ec;
      if (fs::is_symlink(dir, ec))
        add({"--symlink", fs::read_symlink(dir, ec).string(), dir});
      else if (fs::is_directory(dir, ec))
        add({"--ro-bind", dir, dir});
    }
  }
  for (const fs::path& path : what.readable) add({"--ro-bind", path.string(), path.string()});
  for (const fs::path& path : what.writable) add({"--bind", path.string(), path.string()});
  add({"--chdir", what.directory, "--"});
  all.insert(all.end(), what.argv.begin(), what.argv.end());
  return all;
}

void limit(int resource, std::uint64_t value) {
  const rlimit both{value, value};
  syscall(SYS_prlimit64, 0, resource, &both, nullptr);
}

SystemCallFilter filter_of(Profile profile, pid_t self) {
  if (profile == Profile::worker) return worker_filter(self);
  return profile == Profile::sanitizer ? sanitizer_filter() : compiler_filter();
}

/// Between fork and exec: nothing here allocates.
[[noreturn]] void become(const Confined& what, char* const* argv, char* const* environment, int information,
                         int filter) {
  setsid();
  // The descriptors asked for may be among 0, 1, 2 ... themselves: park them above, then place them.
  int parked[16];
  const int count = int(what.descriptors.size());
  for (int i = 0; i < count; ++i) parked[i] = fcntl(what.descriptors[std::size_t(i)], F_DUPFD, parking_fd);
  const int parked_information = information < 0 ? -1 : fcntl(information, F_DUPFD, parking_fd);
  const int parked_filter = filter < 0 ? -1 : fcntl(filter, F_DUPFD, parking_fd);
  for (int i = 0; i < count; ++i) dup2(parked[i], i);
  for (int fd = count; fd < information_fd; ++fd) close(fd);
  if (parked_information >= 0) dup2(parked_information, information_fd);
  if (parked_filter >= 0) dup2(parked_filter, filter_fd);
  if (syscall(SYS_close_range, first_free_fd, ~0u, 0) != 0)
    for (int fd = first_free_fd; fd < 4096; ++fd) close(fd);

  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  for (int number = 1; number < 32; ++number) signal(number, SIG_DFL);

  const bool worker = what.profile == Profile::worker;
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, what.limits.cpu_s);
  limit(RLIMIT_AS, what.limits.memory_bytes);
  limit(RLIMIT_FSIZE, what.limits.file_bytes);
  limit(RLIMIT_NOFILE, worker ? 32 : 256);
  limit(RLIMIT_STACK, 8u << 20);
  limit(RLIMIT_NPROC, 1024);
  if (layers().drops_user && !become_nobody()) _exit(127);
  umask(022);
  if (!layers().namespaces) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (chdir(what.directory.c_str()) != 0) _exit(127);
    // (a worker opens no file at all: its filter refuses)
    if (!worker && layers().landlock && !keep_to(what.readable, what.writable)) _exit(127);
    if (layers().filter && !install(filter_of(what.profile, getpid()))) _exit(127);
  }
  execve(argv[0], argv, environment);
  _exit(127);
}

/// The filter as a file for bubblewrap to read; -1 when there is none to give.
int filter_file(const SystemCallFilter& filter) {
  const int fd = memfd_create("filter", MFD_CLOEXEC);
  promise(fd >= 0 && write(fd, filter.begin(), filter.bytes()) == ssize_t(filter.bytes()) &&
              lseek(fd, 0, SEEK_SET) == 0,
          "a filter can be written to memory");
  return fd;
}

}  // namespace

Outcome<Child> start(const Confined& what) {
  promise(what.descriptors.size() < std::size_t(information_fd), "a confined process gets few descriptors");
  const std::vector<std::string> words = layers().namespaces ? bubblewrap_arguments(what) : what.argv;
  const std::vector<std::string> variables = environment_of(what);
  const std::vector<char*> argv = as_array(words), environment = as_array(variables);

  int information[2] = {-1, -1}, filter = -1;
  if (layers().namespaces) {
    promise(pipe2(information, O_CLOEXEC) == 0, "a pipe can be had");
    if (layers().filter)
      filter = filter_file(filter_of(what.profile, 0));
  }
  const pid_t pid = fork();
  if (pid == 0) become(what, argv.data(), environment.data(), information[1], filter);
  const int why = errno;
  if (information[1] >= 0) close(information[1]);
  if (filter >= 0) close(filter);
  if (pid < 0) {
    if (information[0] >= 0) close(information[0]);
    return Fault{Fault::Kind::unsupported, "", std::string("no process can be started: ") + std::strerror(why)};
  }
  Child child;
  child.pid_ = pid;
  child.information_ = information[0];
  return child;
}

/// What bubblewrap says before it lets the program run; later bytes, whoever wrote them, are never read. The pipe stays
/// open until the end: bubblewrap says more, and writing to nobody would kill it before it has let its half go on.
pid_t Child::first_inside() const {
  if (information_ < 0 || asked_) return inside_;
  asked_ = true;
  std::string text;
  char c;
  for (ssize_t n; text.size() < 200;) {
    n = read(information_, &c, 1);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0 || c == ',' || c == '}') break;
    text += c;
  }
  if (const std::size_t at = text.find("\"child-pid\":"); at != std::string::npos)
    inside_ = pid_t(std::strtol(text.c_str() + at + 12, nullptr, 10));
  if (inside_ > 0) inside_handle_ = int(syscall(SYS_pidfd_open, inside_, 0));  // -1 before Linux 5.3
  return inside_;
}

/// Bubblewrap ends when the program has ended or is killed; the namespace's first process, and all that is still in it
/// with it, may take a moment longer to be gone.
void Child::await_inside() {
  first_inside();
  if (information_ >= 0) close(information_);
  information_ = -1;
  if (inside_handle_ < 0) return;
  syscall(SYS_pidfd_send_signal, inside_handle_, SIGKILL, nullptr, 0);  // where bubblewrap itself was killed
  pollfd gone{inside_handle_, POLLIN, 0};
  while (poll(&gone, 1, 10000) < 0 && errno == EINTR) continue;
  close(inside_handle_);
  inside_handle_ = -1;
}

namespace {

/// The beginning of a small file of /proc; empty when it cannot be read.
std::string proc_text(const std::string& path) {
  char text[512];
  const int fd = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) return "";
  const ssize_t n = read(fd, text, sizeof text);
  close(fd);
  return n > 0 ? std::string(text, std::size_t(n)) : "";
}

}  // namespace

pid_t Child::program() const {
  if (program_ > 0) return program_;
  const pid_t reaper = first_inside();
  if (reaper <= 0) return pid_;
  // the namespace's first process waits for the program, its only child
  const std::string id = std::to_string(reaper);
  return program_ = pid_t(std::strtol(proc_text("/proc/" + id + "/task/" + id + "/children").c_str(), nullptr, 10));
}

bool Child::waits() const {
  const std::string stat = proc_text("/proc/" + std::to_string(program()) + "/stat");
  const std::size_t state = stat.rfind(") ");  // after the name, which may hold anything
  return state != stat.npos && state + 2 < stat.size() && stat[state + 2] == 'S';
}

double Child::cpu_seconds() const {
  const pid_t program = this->program();
  if (program <= 0) return -1;
  clockid_t clock;
  timespec used{};
  if (clock_getcpuclockid(program, &clock) != 0 || clock_gettime(clock, &used) != 0) return -1;
  return double(used.tv_sec) + 1e-9 * double(used.tv_nsec);
}

bool Child::ended(double seconds) {
  if (reaped_ || pid_ <= 0) return true;
  const auto begun = std::chrono::steady_clock::now();
  pid_t got;
  while ((got = waitpid(pid_, &status_, WNOHANG)) != pid_) {
    if (std::chrono::steady_clock::now() - begun >= std::chrono::duration<double>(seconds)) break;
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  reaped_ = got == pid_;
  if (reaped_) await_inside();
  return reaped_;
}

int Child::end() {
  if (ended()) return status_;
  const pid_t inside = first_inside();
  // Killing the namespace's first process kills everything in it before bubblewrap sees it end.
  // Before there is one, bubblewrap may have a half of itself that waits to be told to go on: of its group.
  if (inside <= 0 || kill(inside, SIGKILL) != 0 || !layers().namespaces) kill(pid_, SIGKILL), kill(-pid_, SIGKILL);
  while (!ended(2)) kill(pid_, SIGKILL);
  return status_;
}

Course run_to_end(Child child, int out, double seconds) {
  constexpr std::size_t kept_output = 256u << 10;
  const auto begun = std::chrono::steady_clock::now();
  const auto left_ms = [&] { return int(1000 * (seconds - std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count())); };
  Course course;
  char buffer[16 << 10];
  pollfd fd{out, POLLIN, 0};
  for (bool open = true; open && left_ms() > 0 && interrupted() == 0;) {
    if (poll(&fd, 1, std::min(left_ms(), 200)) <= 0) continue;
    const ssize_t n = read(out, buffer, sizeof buffer);
    if (n > 0) course.output.append(buffer, std::min(std::size_t(n), kept_output - course.output.size()));
    open = n > 0 || (n < 0 && errno == EINTR);
  }
  course.late = left_ms() <= 0;
  course.by_itself = !course.late && interrupted() == 0 && child.ended(1);
  course.status = child.end();
  return course;
}

std::vector<std::string> isolation(Profile profile) {
  const Layers& l = layers();
  const bool worker = profile == Profile::worker;
  std::vector<std::string> lines;
  lines.push_back(l.drops_user ? "user: nobody"
                               : "user: the one who runs rigor (only root can hand a process to nobody)");
  if (l.namespaces)
    lines.push_back(std::string("bubblewrap: user, process, network, mount, IPC, host-name and cgroup namespaces of "
                                "its own; sees ") +
                    (worker ? "no file but its own program" : "/usr, the kit and the submission"));
  else {
    lines.push_back(std::string("process only: ") +
                    (l.bubblewrap ? "bubblewrap is here but this machine refuses it namespaces"
                                  : "bubblewrap is not installed"));
    if (!worker)
      lines.push_back(l.landlock ? "landlock: sees /usr, the kit and the submission"
                                 : "files: all that this user may read (no landlock either)");
  }
  if (l.filter)
    lines.push_back(worker ? "system calls: an allow-list (no file, network, process, thread or signal to others)"
                           : "system calls: network, tracing, mounts and kernel interfaces refused");
  else
    lines.push_back("system calls: not filtered (this kernel refuses a filter)");
  lines.push_back(worker ? "limits: processor, memory, output; no files written"
                         : "limits: processor, memory, file size");
  return lines;
}

std::string signal_words(int number) {
  switch (number) {
    case SIGSEGV: return "a segmentation fault (it touched memory that is not its own)";
    case SIGABRT: return "abort() (a failed assertion, or an exception nobody caught)";
    case SIGFPE: return "an arithmetic error (an integer divided by zero)";
    case SIGILL: return "an illegal instruction (often a function without a return)";
    case SIGBUS: return "a bus error (memory that is not there)";
    case SIGKILL: return "the kernel (killed)";
    case SIGXCPU: return "the limit on processor time";
    case SIGXFSZ: return "the limit on file size";
    default: return "signal " + std::to_string(number);
  }
}

bool hand_over(const fs::path& path) {
  return !layers().drops_user || lchown(path.c_str(), nobody, nobody) == 0;
}

fs::path closed_to_confined(const fs::path& path) {
  if (!layers().drops_user) return {};
  fs::path way;
  for (const fs::path& part : fs::absolute(path)) {
    way /= part;
    std::error_code ec;
    const auto status = fs::status(way, ec);
    if (!fs::is_directory(status)) break;
    if ((status.permissions() & fs::perms::others_exec) == fs::perms::none) return way;
  }
  return {};
}

}  // namespace rigor::grader
