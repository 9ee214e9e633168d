#pragma once
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace rigor::layout {

inline const std::filesystem::path source = RIGOR_SOURCE_DIR;
inline const std::filesystem::path binary = RIGOR_BINARY_DIR;

inline std::string read(const std::filesystem::path& path) {
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// All files below a directory with one of the endings, sorted, relative to the source tree.
inline std::vector<std::string> files_below(const std::string& directory,
                                            const std::vector<std::string>& endings) {
  std::vector<std::string> found;
  if (!std::filesystem::exists(source / directory)) return found;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(source / directory)) {
    const std::string ending = entry.path().extension().string();
    if (entry.is_regular_file() && std::find(endings.begin(), endings.end(), ending) != endings.end())
      found.push_back(std::filesystem::relative(entry.path(), source).string());
  }
  std::sort(found.begin(), found.end());
  return found;
}

inline bool starts(const std::string& text, const std::string& with) {
  return text.compare(0, with.size(), with) == 0;
}

}  // namespace rigor::layout
