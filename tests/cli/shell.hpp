// A shell's command run to its end, with all that it printed.
#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

namespace rigor {

struct Ran {
  int status;
  std::string text;  // stdout and stderr
};

inline Ran sh(const std::string& command) {
  std::FILE* pipe = popen(("( " + command + "\n) 2>&1 </dev/null").c_str(), "r");
  Ran ran{0, ""};
  std::array<char, 4096> buffer;
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe)) ran.text.append(buffer.data(), n);
  const int status = pclose(pipe);
  ran.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return ran;
}

}  // namespace rigor
