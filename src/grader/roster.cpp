#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <rigor/base/file.hpp>
#include <rigor/grader/archive.hpp>
#include <rigor/grader/printable.hpp>
#include <rigor/grader/roster.hpp>
#include <set>

namespace rigor::grader {
namespace {

namespace fs = std::filesystem;

std::string yaml_text(std::string text) {
  const std::size_t end = text.find_last_not_of(" \t\r");
  text.resize(end == std::string::npos ? 0 : end + 1);
  if (text == "null" || text == "~") return "";
  if (text.size() < 2 || text.front() != text.back() || (text.front() != '"' && text.front() != '\'')) return text;
  std::string inside;
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {  // a quote inside is '' or \"
    if (i + 2 < text.size() && ((text[i] == '\'' && text.front() == '\'') || (text[i] == '\\' && text.front() == '"'))) ++i;
    inside += text[i];
  }
  return inside;
}

// submission_metadata.yml of Gradescope: the list ":submitters:" below the submission's own line.
std::vector<Person> submitters(const fs::path& export_dir, const std::string& submission) {
  std::ifstream in(export_dir / "submission_metadata.yml");
  static const std::regex field(R"re(^(\s*)(- +)?:?(\w+): *(.*)$)re");
  std::vector<Person> people;
  bool inside = false;
  std::size_t list_indent = std::string::npos;
  for (std::string line; std::getline(in, line);) {
    std::smatch match;
    if (!std::regex_match(line, match, field)) continue;
    const std::size_t indent = std::size_t(match[1].length());
    const std::string key = match[3], value = yaml_text(match[4]);
    if (indent == 0 && !match[2].matched) {
      inside = key == submission;
      list_indent = std::string::npos;
    } else if (inside && key == "submitters") {
      list_indent = indent;
    } else if (inside && list_indent != std::string::npos) {
      if (indent < list_indent || (indent == list_indent && !match[2].matched)) {
        list_indent = std::string::npos;
        continue;
      }
      if (match[2].matched) people.emplace_back();
      if (people.empty()) continue;
      if (key == "name") people.back().name = value;
      if (key == "email") people.back().email = value;
      if (key == "sid") people.back().school_id = value;
    }
  }
  return people;
}

std::string label_of(const Person& person) { return !person.name.empty() ? person.name : !person.email.empty() ? person.email : person.school_id; }

Entry gradescope_entry(const fs::path& path, const std::string& submission) {
  Entry entry{submission, {path}};
  entry.people = submitters(path.parent_path(), submission);
  if (entry.people.empty()) return entry;
  const std::size_t n = entry.people.size();
  if (const std::string first = label_of(entry.people.front()); !first.empty()) entry.student = first;
  if (n == 2) entry.student += " and " + label_of(entry.people.back());
  if (n > 2) entry.student += " and " + std::to_string(n - 1) + " others";
  return entry;
}

std::string without_archive_ending(std::string name) {
  static const std::regex ending(R"((\.zip|\.tar|\.tar\.gz|\.tgz)$)", std::regex::icase);
  return std::regex_replace(name, ending, "");
}

/// A submission as one name in the directory says it. Names with one `key` are one student's.
struct Named {
  Entry entry;
  std::string key;
  bool attachment = false;  ///< of Canvas or Moodle: several files are one submission
  bool typed = false;       ///< what was typed into Moodle's text field; counts where there are no files
};

/// nullopt for what is no submission: a stray file.
std::optional<Named> named(const fs::directory_entry& item) {
  static const std::regex autolab(R"(^([^@\s]+@[^@_\s]+)_(\d+)_.*$)");
  static const std::regex canvas(R"(^([a-z0-9]+)(_LATE|_late)?_(\d+)_(\d+)_.*$)");
  static const std::regex moodle(R"(^(.+)_(\d+)_assignsubmission_(file|onlinetext)(_.*)?$)");
  const fs::path& path = item.path();
  const bool packed = item.is_regular_file() && archive_name(path);
  const std::string name = packed ? without_archive_ending(path.filename().string()) : path.filename().string();
  std::smatch match;
  if (std::regex_match(name, match, canvas)) {
    Entry entry{match[1].str() + "_" + match[3].str(), {path}, 0, 1, match[2].matched};
    entry.people = {Person{.canvas_id = match[3]}};
    return Named{entry, entry.student, true};
  }
  if (std::regex_match(name, match, autolab)) {
    Entry entry{match[1], {path}, std::atoi(match[2].str().c_str())};
    entry.people = {Person{.email = match[1]}};
    return Named{entry, entry.student};
  }
  if (std::regex_match(name, match, moodle)) {
    Entry entry{match[1].str() + "_" + match[2].str(), {path}};  // names occur twice
    entry.people = {Person{.name = match[1], .participant = match[2]}};
    return Named{entry, entry.student, !item.is_directory(), match[3] == "onlinetext"};
  }
  if (!packed && !item.is_directory()) return std::nullopt;  // a loose file has an owner only where its name says so
  if (name.rfind("submission_", 0) == 0) return Named{gradescope_entry(path, name), name};
  return Named{Entry{name, {path}}, name};
}

/// What tells two of one name apart: e-mail, school's number, or the upload's own name.
std::string distinction(const Entry& entry, int attempt) {
  if (attempt == 2 || entry.people.empty()) return entry.uploads.front().filename().string();
  return attempt == 0 ? entry.people.front().email : entry.people.front().school_id;
}

void tell_apart(std::vector<Entry>& list) {
  for (int attempt = 0; attempt < 3; ++attempt) {
    std::map<std::string, std::vector<Entry*>> by_name;
    for (Entry& entry : list) by_name[entry.student].push_back(&entry);
    for (const auto& [student, alike] : by_name) {
      std::set<std::string> different;
      for (const Entry* entry : alike) different.insert(distinction(*entry, attempt));
      if (alike.size() == 1 || different.size() != alike.size() || different.count("") != 0) continue;
      for (Entry* entry : alike) entry->student += " (" + distinction(*entry, attempt) + ")";
    }
  }
}

/// `entry` is another upload of the student of `known`.
void add_upload(Named& known, const Named& other) {
  Entry& entry = known.entry;
  const Entry& more = other.entry;
  if (known.typed != other.typed) {
    if (known.typed) known = other;
    return;
  }
  if (known.attachment && other.attachment) {
    entry.uploads.insert(entry.uploads.end(), more.uploads.begin(), more.uploads.end());
    entry.late = entry.late || more.late;
    return;
  }
  const int versions = entry.versions + 1;
  if (more.version > entry.version) known = other;
  else if (more.version == entry.version) entry.uploads.insert(entry.uploads.end(), more.uploads.begin(), more.uploads.end()), known.attachment = false;
  known.entry.versions = versions;
}

}  // namespace

Outcome<std::vector<Entry>> read_roster(const fs::path& directory) {
  using Kind = Fault::Kind;
  std::error_code ec;
  if (!fs::is_directory(directory, ec)) return Fault{Kind::unreadable, directory.string(), "is not a directory"};
  static const std::regex gradescope(R"(^assignment_\d+_export$)");
  std::vector<fs::path> exports;
  for (const auto& item : fs::directory_iterator(directory, ec))  // Gradescope puts everything one level down
    if (item.is_directory() && std::regex_match(item.path().filename().string(), gradescope)) exports.push_back(item.path());
  std::sort(exports.begin(), exports.end());
  if (exports.size() > 1)
    return Fault{Kind::malformed, directory.string(), "holds " + exports[0].filename().string() + " and " + exports[1].filename().string() + ": give one of them"};
  std::map<std::string, Named> students;
  std::vector<fs::directory_entry> items;
  for (const auto& item : fs::directory_iterator(exports.empty() ? directory : exports.front(), ec))
    if (!item.is_symlink() && item.path().filename().string().front() != '.') items.push_back(item);
  std::sort(items.begin(), items.end());
  for (const auto& item : items)
    if (const auto found = named(item))
      if (const auto [at, first] = students.emplace(found->key, *found); !first) add_upload(at->second, *found);
  if (students.empty()) return Fault{Kind::missing, directory.string(), "holds no submission: neither directories nor .zip or .tar files"};
  std::vector<Entry> list;
  for (auto& [key, student] : students) {
    Entry& entry = student.entry;
    if (!student.attachment && entry.uploads.size() > 1) {
      for (const fs::path& upload : entry.uploads) entry.trouble += (entry.trouble.empty() ? "" : " and ") + printable(upload.filename().string());
      entry.trouble += " are there; nothing says which of them counts: leave one";
    }
    list.push_back(std::move(entry));
  }
  tell_apart(list);
  std::sort(list.begin(), list.end(), [](const Entry& a, const Entry& b) { return a.student < b.student; });
  return list;
}

Outcome<fs::path> unpack_class(const fs::path& archive, const fs::path& to) {
  const ArchiveLimits limits{.packed_bytes = 512u << 20, .unpacked_bytes = 512u << 20, .file_bytes = 64u << 20, .entries = 200000};
  const auto read = read_archive(archive, limits);
  if (!read) return read.fault();
  std::error_code ec;
  fs::remove_all(to, ec);
  for (const ArchivedFile& file : read->files)
    if (const auto written = write_file(to / file.path, file.bytes); !written) return fs::remove_all(to, ec), written.fault();
  const std::vector<fs::directory_entry> top(fs::directory_iterator(to, ec), {});
  if (top.size() != 1 || !top[0].is_directory()) return to;
  const auto students = std::count_if(fs::directory_iterator(top[0], ec), {}, [](const fs::directory_entry& e) {
    return e.is_directory() || archive_name(e.path());
  });
  return students > 1 ? top[0].path() : to;
}

}  // namespace rigor::grader
