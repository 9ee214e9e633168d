#pragma once
#include <linux/filter.h>
#include <sys/types.h>

#include <array>

namespace rigor::grader {

/// A program for the kernel that decides on every system call of a process. Built without allocation, so that a
/// child may build and install it between fork and exec. What it refuses fails with EPERM: nobody is killed for
/// asking, so a student who prints or calls abort() is named for what happened.
struct SystemCallFilter {
  std::array<sock_filter, 256> code;
  unsigned short length = 0;

  const sock_filter* begin() const { return code.data(); }
  unsigned bytes() const { return length * unsigned(sizeof(sock_filter)); }
};

/// For a worker: memory, the descriptors it has, clocks, its own signals, and the one exec that starts it. No
/// open, no socket, no new process or thread, no signal to anybody but SIGABRT to `self` (0: to anybody it sees,
/// where a process namespace shows it only itself).
SystemCallFilter worker_filter(pid_t self);

/// For a compiler, which needs files and processes: everything but what reaches beyond (network, tracing,
/// mounts, namespaces, kernel interfaces).
SystemCallFilter compiler_filter();

/// For a student's code under sanitizers: a worker's, and what the loader and the sanitizers ask for (files to read, facts
/// about itself). No socket, no new process or thread.
SystemCallFilter sanitizer_filter();

/// Installs it for the calling process and all it becomes; false when the kernel will not.
bool install(const SystemCallFilter& filter);

}  // namespace rigor::grader
