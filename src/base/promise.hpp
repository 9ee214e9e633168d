#pragma once
#include <cstdio>
#include <cstdlib>

namespace rigor {

/// Our own promise, checked in every build: prints where and which, then aborts. Never for input from outside.
/// (The builtins stand in for std::source_location, which clang 14 lacks.)
inline void promise(bool held, const char* sentence, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
  if (held) return;
  std::fprintf(stderr, "%s:%d: rigor broke its promise: %s\n", file, line, sentence);
  std::abort();
}

}  // namespace rigor
