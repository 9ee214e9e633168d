#pragma once
#include <cstdio>
#include <cstdlib>
#include <source_location>

namespace rigor {

/// Our own promise, checked in every build: prints where and which, then aborts. Never for input from
/// outside.
inline void promise(bool held, const char* sentence,
                    std::source_location at = std::source_location::current()) {
  if (held) return;
  std::fprintf(stderr, "%s:%u: rigor broke its promise: %s\n", at.file_name(), unsigned(at.line()), sentence);
  std::abort();
}

}  // namespace rigor
