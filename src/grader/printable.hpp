#pragma once
#include <string>

namespace rigor::grader {

/// A name for a message: no line of a report is broken or coloured by what a file is called.
inline std::string printable(const std::string& name) {
  std::string shown = name.substr(0, 200);
  for (char& c : shown)
    if (static_cast<unsigned char>(c) < 32 || c == 127) c = '?';
  return shown;
}

}  // namespace rigor::grader
