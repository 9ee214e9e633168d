#include <linux/audit.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <rigor/base/promise.hpp>
#include <rigor/grader/seccomp.hpp>

namespace rigor::grader {
namespace {

#if defined(__x86_64__)
constexpr unsigned architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr unsigned architecture = AUDIT_ARCH_AARCH64;
#else
#error "the system-call filter knows x86-64 and arm64"
#endif

constexpr unsigned allowed = SECCOMP_RET_ALLOW;
constexpr unsigned refused = SECCOMP_RET_ERRNO | EPERM;
constexpr unsigned unknown = SECCOMP_RET_ERRNO | ENOSYS;  // glibc then falls back to an older call

void add(SystemCallFilter& f, sock_filter instruction) {
  promise(f.length < f.code.size(), "a system-call filter fits its array");
  f.code[f.length++] = instruction;
}
void load(SystemCallFilter& f, std::size_t offset) {
  add(f, BPF_STMT(BPF_LD | BPF_W | BPF_ABS, unsigned(offset)));
}
void give(SystemCallFilter& f, unsigned verdict) { add(f, BPF_STMT(BPF_RET | BPF_K, verdict)); }

/// Calls of another architecture, or of the x32 table, would carry other numbers: refused.
void begin(SystemCallFilter& f) {
  load(f, offsetof(seccomp_data, arch));
  add(f, BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, architecture, 1, 0));
  give(f, refused);
  load(f, offsetof(seccomp_data, nr));
  add(f, BPF_JUMP(BPF_JMP | BPF_JGE | BPF_K, 0x40000000u, 0, 1));
  give(f, refused);
}

void when(SystemCallFilter& f, long number, unsigned verdict) {
  add(f, BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, unsigned(number), 0, 1));
  give(f, verdict);
}

struct Argument {
  unsigned index, value;  // all 64 bits of the argument equal value
};

/// Allowed with exactly these arguments, else refused.
template <std::size_t N>
void when_with(SystemCallFilter& f, long number, const Argument (&arguments)[N]) {
  add(f, BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, unsigned(number), 0, static_cast<unsigned char>(6 * N + 1)));
  for (const Argument& a : arguments) {
    const std::size_t at = offsetof(seccomp_data, args) + 8 * a.index;  // little endian
    load(f, at);
    add(f, BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, a.value, 1, 0));
    give(f, refused);
    load(f, at + 4);
    add(f, BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, 0, 1, 0));
    give(f, refused);
  }
  give(f, allowed);
}

}  // namespace

namespace {

/// What any program needs that has its descriptors already.
constexpr long worker_calls[] = {
    SYS_read, SYS_write, SYS_readv, SYS_writev, SYS_close, SYS_fstat, SYS_newfstatat, SYS_lseek,  // what it has
    SYS_brk, SYS_mmap, SYS_munmap, SYS_mremap, SYS_mprotect, SYS_madvise,                         // memory
    SYS_clock_gettime, SYS_clock_getres, SYS_clock_nanosleep, SYS_nanosleep, SYS_gettimeofday,    // time
    SYS_rt_sigaction, SYS_rt_sigprocmask, SYS_rt_sigreturn, SYS_sigaltstack,                      // its own signals
    SYS_getpid, SYS_gettid, SYS_getuid, SYS_getrandom, SYS_futex, SYS_sched_yield,
    SYS_uname,  // a static program of an older C library asks for the kernel before anything else
    SYS_wait4,   // bubblewrap waits for the program under the same filter
    SYS_execve,  // once, by whoever starts it; there is nothing else to execute
    SYS_set_tid_address, SYS_set_robust_list, SYS_rseq, SYS_exit, SYS_exit_group,
#if defined(__x86_64__)
    SYS_arch_prctl, SYS_time,
#endif
};

}  // namespace

SystemCallFilter worker_filter(pid_t self) {
  SystemCallFilter f;
  begin(f);
  for (const long call : worker_calls) when(f, call, allowed);
  when_with(f, SYS_prlimit64, {{0, 0}, {2, 0}});  // its own limits, to read
  if (self == 0)
    when_with(f, SYS_tgkill, {{2, SIGABRT}});
  else
    when_with(f, SYS_tgkill, {{0, unsigned(self)}, {2, SIGABRT}});
  give(f, refused);
  return f;
}

SystemCallFilter sanitizer_filter() {
  SystemCallFilter f;
  begin(f);
  for (const long call : worker_calls) when(f, call, allowed);
  constexpr long more[] = {
      SYS_openat, SYS_pread64, SYS_readlinkat, SYS_faccessat, SYS_faccessat2, SYS_getdents64, SYS_fcntl, SYS_getcwd, SYS_ioctl,  // files
      SYS_getppid, SYS_geteuid, SYS_getgid, SYS_getegid, SYS_sched_getaffinity, SYS_sysinfo, SYS_getrusage, SYS_dup,            // itself
#if defined(__x86_64__)
      SYS_open, SYS_access, SYS_readlink, SYS_stat, SYS_lstat, SYS_getrlimit,
#endif
  };
  for (const long call : more) when(f, call, allowed);
  when_with(f, SYS_prlimit64, {{0, 0}, {2, 0}});
  give(f, refused);
  return f;
}

SystemCallFilter compiler_filter() {
  SystemCallFilter f;
  begin(f);
  constexpr long calls[] = {
      SYS_socket, SYS_socketpair, SYS_connect, SYS_bind, SYS_listen, SYS_accept4, SYS_sendto, SYS_sendmsg,
      SYS_ptrace, SYS_process_vm_readv, SYS_process_vm_writev, SYS_kcmp, SYS_pidfd_getfd,
      SYS_mount, SYS_umount2, SYS_pivot_root, SYS_chroot, SYS_unshare, SYS_setns, SYS_open_by_handle_at,
      SYS_bpf, SYS_perf_event_open, SYS_userfaultfd, SYS_keyctl, SYS_add_key, SYS_request_key,
      SYS_io_uring_setup, SYS_init_module, SYS_finit_module, SYS_kexec_load, SYS_reboot, SYS_swapon,
      SYS_personality, SYS_setuid, SYS_setgid, SYS_setresuid, SYS_setresgid, SYS_setgroups,
  };
  for (const long call : calls) when(f, call, refused);
  when(f, SYS_clone3, unknown);
  give(f, allowed);
  return f;
}

bool install(const SystemCallFilter& filter) {
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return false;
  sock_fprog program{filter.length, const_cast<sock_filter*>(filter.begin())};
  return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

}  // namespace rigor::grader
