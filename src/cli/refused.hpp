#pragma once
#include <cstdio>
#include <rigor/report/wrap.hpp>
#include <string>

namespace rigor::cli {

/// What a command does not take, on stderr, behind its name; the names known instead, which may be dozens, in lines
/// of their own of 80 columns. The exit status of bad input.
inline int refused(const std::string& command, const std::string& text) {
  const std::size_t list = text.find("; known: ");
  std::fprintf(stderr, "rigor %s: %s\n", command.c_str(), text.substr(0, list).c_str());
  if (list != text.npos) std::fputs(report::filled(text.substr(list + 2), 78, 2).c_str(), stderr);
  return 2;
}

}  // namespace rigor::cli
