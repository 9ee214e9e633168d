#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <rigor/base/file.hpp>
#include <rigor/grader/archive.hpp>
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

std::string without_archive_ending(std::string name) {
  static const std::regex ending(R"((\.zip|\.tar|\.tar\.gz|\.tgz)$)", std::regex::icase);
  return std::regex_replace(name, ending, "");
}

/// nullopt for what is no submission: a stray file.
std::optional<Entry> entry_of(const fs::directory_entry& item) {
  static const std::regex autolab(R"(^([^_@\s]+@[^_\s]+)_(\d+)_.*$)");
  static const std::regex canvas(R"(^([a-z0-9]+)(_LATE|_late)?_(\d+)_(\d+)_.*$)");
  static const std::regex moodle(R"(^(.+)_(\d+)_assignsubmission_file_?$)");
  const fs::path& path = item.path();
  const bool packed = item.is_regular_file() && archive_name(path);
  const std::string name = packed ? without_archive_ending(path.filename().string()) : path.filename().string();
  std::smatch match;
  if (std::regex_match(name, match, canvas)) return Entry{match[1].str() + "_" + match[3].str(), {path}, 0, 1, match[2].matched};
  if (std::regex_match(name, match, autolab)) return Entry{match[1], {path}, std::atoi(match[2].str().c_str()), 1, false};
  if (!packed && !item.is_directory()) return std::nullopt;  // a loose file has an owner only where its name says so
  if (std::regex_match(name, match, moodle)) return Entry{match[1].str() + "_" + match[2].str(), {path}, 0, 1, false};  // names occur twice
  if (name.rfind("submission_", 0) == 0) return Entry{gradescope_name(path.parent_path(), name), {path}, 0, 1, false};
  return Entry{name, {path}, 0, 1, false};
}

bool of_canvas(const fs::path& path) {
  static const std::regex canvas(R"(^[a-z0-9]+(_LATE|_late)?_\d+_\d+_.*$)");
  return std::regex_match(path.filename().string(), canvas);
}

}  // namespace

Outcome<std::vector<Entry>> read_roster(const fs::path& directory) {
  std::error_code ec;
  if (!fs::is_directory(directory, ec)) return Fault{Fault::Kind::unreadable, directory.string(), "is not a directory"};
  fs::path root = directory;
  for (const auto& item : fs::directory_iterator(directory, ec))  // Gradescope puts everything one level down
    if (item.is_directory() && item.path().filename().string().rfind("assignment_", 0) == 0) root = item.path();
  std::map<std::string, Entry> students;
  std::vector<fs::directory_entry> items;
  for (const auto& item : fs::directory_iterator(root, ec))
    if (!item.is_symlink() && item.path().filename().string().front() != '.') items.push_back(item);
  std::sort(items.begin(), items.end());
  for (const auto& item : items) {
    const auto found = entry_of(item);
    if (!found) continue;
    Entry entry = *found;
    const auto it = students.find(entry.student);
    if (it == students.end()) {
      students.emplace(entry.student, entry);
      continue;
    }
    Entry& known = it->second;
    if (of_canvas(item.path()) && of_canvas(known.uploads.front())) {  // one submission in several attachments
      known.uploads.push_back(item.path());
      known.late = known.late || entry.late;
      continue;
    }
    entry.versions = known.versions + 1;
    if (entry.version >= known.version) known = entry;
    else known.versions = entry.versions;
  }
  if (students.empty()) return Fault{Fault::Kind::missing, directory.string(), "holds no submission: neither directories nor .zip or .tar files"};
  std::vector<Entry> list;
  for (auto& [student, entry] : students) list.push_back(std::move(entry));
  return list;
}

Outcome<fs::path> unpack_class(const fs::path& archive, const fs::path& to) {
  const ArchiveLimits limits{.packed_bytes = 512u << 20, .unpacked_bytes = 512u << 20, .file_bytes = 64u << 20, .entries = 200000};
  const auto read = read_archive(archive, limits);
  if (!read) return read.fault();
  for (const ArchivedFile& file : read->files)
    if (const auto written = write_file(to / file.path, file.bytes); !written) return written.fault();
  std::error_code ec;
  const std::vector<fs::directory_entry> top(fs::directory_iterator(to, ec), {});
  if (top.size() != 1 || !top[0].is_directory()) return to;
  const auto students = std::count_if(fs::directory_iterator(top[0], ec), {}, [](const fs::directory_entry& e) {
    return e.is_directory() || archive_name(e.path());
  });
  return students > 1 ? top[0].path() : to;
}

}  // namespace rigor::grader
