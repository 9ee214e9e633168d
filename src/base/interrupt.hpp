#pragma once
#include <csignal>

namespace rigor {

namespace detail {
inline volatile std::sig_atomic_t interrupt_seen = 0;
}

/// From here on SIGINT and SIGTERM only raise a flag; a second one ends the program at once.
inline void catch_interrupts() {
  const auto handler = [](int signal) {
    detail::interrupt_seen = signal;
    std::signal(signal, SIG_DFL);
  };
  std::signal(SIGINT, handler);
  std::signal(SIGTERM, handler);
}

/// The signal that asked to stop, or 0. Long loops look here, leave whole files and end with status 128 +
/// signal.
inline int interrupted() { return detail::interrupt_seen; }

}  // namespace rigor
