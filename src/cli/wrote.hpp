#pragma once
#include <cstdio>
#include <filesystem>
#include <rigor/report/wrap.hpp>
#include <string>
#include <vector>

namespace rigor::cli {

/// "wrote runs/a/replay.html; beside it trajectory.csv, summary.json": the last line of a command that wrote files. The
/// first is the one to open. Where that is too long for 80 columns, the others stand in lines of their own.
inline std::string wrote_text(const std::filesystem::path& dir, const std::vector<std::string>& names) {
  const std::string first = "wrote " + (dir / names.front()).string();
  std::string others;
  for (std::size_t i = 1; i < names.size(); ++i) others += (i == 1 ? "beside it " : ", ") + names[i];
  if (others.empty()) return first + "\n";
  return first.size() + others.size() + 2 <= 80 ? first + "; " + others + "\n" : first + "\n" + report::filled(others, 80, 2);
}
inline void say_wrote(const std::filesystem::path& dir, const std::vector<std::string>& names) { std::fputs(wrote_text(dir, names).c_str(), stdout); }

}  // namespace rigor::cli
