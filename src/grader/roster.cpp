#include <algorithm>
#include <fstream>
#include <map>
#include <regex>
#include <rigor/grader/roster.hpp>

namespace rigor::grader {
namespace {

namespace fs = std::filesystem;

// submission_metadata.yml of Gradescope: the first ":name:" or "name:" below its entry.
std::string gradescope_name(const fs::path& export_dir, const std::string& submission) {
  std::ifstream in(export_dir / "submission_metadata.yml");
  static const std::regex name_line(R"re(^\s*-?\s*:?name:\s*"?([^"]*?)"?\s*$)re");
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    if (line.rfind(submission + ":", 0) == 0) inside = true;
    std::smatch match;
    if (inside && std::regex_match(line, match, name_line)) return match[1];
  }
  return submission;
}

Entry entry_of(const fs::path& path) {
  static const std::regex autolab(R"(^([^_@\s]+@[^_\s]+)_(\d+)_.*$)");
  static const std::regex canvas(R"(^([a-z]+)(_LATE|_late)?_(\d+)_(\d+)_.*$)");
  const std::string name = path.filename().string();
  std::smatch match;
  if (std::regex_match(name, match, autolab)) return {match[1], path, std::atoi(match[2].str().c_str()), 1, false};
  if (std::regex_match(name, match, canvas)) return {match[1].str() + "_" + match[3].str(), path, std::atoi(match[4].str().c_str()), 1, match[2].matched};
  if (name.rfind("submission_", 0) == 0) return {gradescope_name(path.parent_path(), name), path, 0, 1, false};
  return {name, path, 0, 1, false};
}

}  // namespace

Outcome<std::vector<Entry>> read_roster(const fs::path& directory) {
  std::error_code ec;
  if (!fs::is_directory(directory, ec)) return Fault{Fault::Kind::unreadable, directory.string(), "is not a directory"};
  fs::path root = directory;
  for (const auto& item : fs::directory_iterator(directory, ec))  // Gradescope puts everything one level down
    if (item.is_directory() && item.path().filename().string().rfind("assignment_", 0) == 0) root = item.path();
  std::map<std::string, Entry> students;
  for (const auto& item : fs::directory_iterator(root, ec)) {
    if (item.is_symlink() || !item.is_directory() || item.path().filename().string().front() == '.') continue;
    Entry entry = entry_of(item.path());
    const auto it = students.find(entry.student);
    if (it == students.end()) {
      students.emplace(entry.student, entry);
      continue;
    }
    entry.versions = it->second.versions + 1;
    if (entry.version > it->second.version || (entry.version == it->second.version && entry.path > it->second.path)) it->second = entry;
    else it->second.versions = entry.versions;
  }
  if (students.empty()) return Fault{Fault::Kind::missing, directory.string(), "holds no directory of a submission"};
  std::vector<Entry> list;
  for (auto& [student, entry] : students) list.push_back(std::move(entry));
  return list;
}

}  // namespace rigor::grader
