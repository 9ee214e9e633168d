#pragma once
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <future>
#include <rigor/base/interrupt.hpp>
#include <string>

namespace rigor::cli {

/// What `make` gives. It runs beside, since it does not look for interrupts: at one this ends the program at once, with `sentence`
/// on stderr and status 128 + signal, so nothing may be half written when it is called. Where `shown`, `doing` stands on stderr
/// with the time spent: on a terminal from the second second on, gone when the work is done; elsewhere in a line every half minute.
template <class Make>
auto unless_interrupted(const Make& make, const std::string& sentence, const std::string& doing, bool shown = true) {
  const auto start = std::chrono::steady_clock::now();
  const bool terminal = isatty(STDERR_FILENO) != 0;
  long said = 0;  // seconds
  const auto clear = [&] {
    if (terminal && said > 0) std::fputs("\r\033[K", stderr);
  };
  auto made = std::async(std::launch::async, make);
  while (made.wait_for(std::chrono::milliseconds(100)) != std::future_status::ready) {
    if (interrupted() != 0) {
      clear();
      std::fprintf(stderr, "%s\n", sentence.c_str());
      std::_Exit(128 + interrupted());
    }
    const long spent = std::chrono::duration_cast<std::chrono::seconds>(std::chrono::steady_clock::now() - start).count();
    if (!shown || spent < said + (terminal ? 1 : 30) || spent < 2) continue;
    said = spent;
    std::fprintf(stderr, terminal ? "\r\033[K%s, %ld s" : "%s, %ld s\n", doing.c_str(), spent);
  }
  clear();
  return made.get();
}

}  // namespace rigor::cli
