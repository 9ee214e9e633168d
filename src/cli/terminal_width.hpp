#pragma once
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

namespace rigor::cli {

/// Columns of the terminal, as $COLUMNS or the terminal itself says: from 50 to 80; 80 where nobody says.
inline std::size_t terminal_width() {
  winsize size{};
  long columns = 0;
  if (const char* said = std::getenv("COLUMNS")) columns = std::atol(said);
  else if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0) columns = size.ws_col;
  return columns > 0 ? std::size_t(std::clamp(columns, 50L, 80L)) : 80;
}

}  // namespace rigor::cli
