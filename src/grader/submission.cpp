#include <algorithm>
#include <array>
#include <cctype>
#include <regex>
#include <rigor/base/file.hpp>
#include <rigor/grader/archive.hpp>
#include <rigor/grader/build_hash.hpp>
#include <rigor/grader/printable.hpp>
#include <rigor/grader/submission.hpp>

namespace rigor::grader {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t largest_file = 1u << 20;
constexpr std::size_t most_entries = 20000;
constexpr int deepest = 24;

constexpr std::array expected{"Cuboid.h",         "Cuboid.cpp",         "CollisionPlane.h", "CollisionPlane.cpp",
                              "ParticleSystem.h", "ParticleSystem.cpp", "MatrixUtils.h",    "MatrixUtils.cpp",
                              "Constants.h"};
constexpr std::array window_program{"pbfapp.cpp", "pbfapp.h", "main.cpp"};
constexpr std::array source_endings{".h", ".hpp", ".hh", ".hxx", ".inl", ".cpp", ".cc", ".cxx", ".c"};

std::string lower(std::string text) {
  for (char& c : text) c = char(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// Line ends of every system to "\n", without a byte-order mark.
std::string plain_text(std::string_view bytes) {
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
  std::string text;
  text.reserve(bytes.size() + 1);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (bytes[i] != '\r')
      text += bytes[i];
    else if (i + 1 == bytes.size() || bytes[i + 1] != '\n')
      text += '\n';
  }
  if (!text.empty() && text.back() != '\n') text += '\n';
  return text;
}

bool plain_name(const std::string& name) {
  return std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isalnum(c) || c == '_' || c == '-' || c == '+' || c == '.';
  });
}

/// A file as it was handed in: on disk, or in memory out of an archive.
struct Found {
  fs::path path;         // its base name and ending count
  std::string relative;
  int depth;
  bool unpacked = false;
  std::string bytes;

  Outcome<std::string> read() const { return unpacked ? Outcome<std::string>(bytes) : read_file(path, largest_file); }
};

/// A name that is passed by, with all below it.
bool passed_by(const std::string& name) {
  const std::string plain = lower(name);
  return name.starts_with('.') || plain == "__macosx" || plain == "debug" || plain == "release";
}

/// Every regular file below `root` in one order on every machine; directories no student writes in are passed by.
void collect(const fs::path& root, const fs::path& dir, int depth, std::vector<Found>& files,
             std::vector<std::string>& notes, std::size_t& entries) {
  std::error_code ec;
  std::vector<fs::directory_entry> inside;
  for (fs::directory_iterator at(dir, fs::directory_options::skip_permission_denied, ec), end; !ec && at != end;
       at.increment(ec)) {
    if (++entries > most_entries) return;
    inside.push_back(*at);
  }
  std::sort(inside.begin(), inside.end());
  for (const fs::directory_entry& entry : inside) {
    const std::string name = entry.path().filename().string();
    const std::string relative = entry.path().lexically_relative(root).string();
    if (entry.is_symlink(ec)) {
      notes.push_back(printable(relative) + ": a symbolic link, not followed");
    } else if (entry.is_directory(ec)) {
      if (!passed_by(name) && depth < deepest) collect(root, entry.path(), depth + 1, files, notes, entries);
    } else if (!entry.is_regular_file(ec)) {
      notes.push_back(printable(relative) + ": no file that can be read");
    } else if (!name.starts_with('.')) {
      files.push_back({entry.path(), relative, depth, false, {}});
    }
  }
}

}  // namespace

const SourceFile* Submission::find(const std::string& file_name) const {
  for (const SourceFile& file : files)
    if (file.name == file_name) return &file;
  return nullptr;
}

namespace {

Outcome<std::vector<Found>> files_of_directory(const fs::path& path, std::vector<std::string>& notes) {
  std::error_code ec;
  if (fs::directory_iterator(path, ec); ec)
    return Fault{Fault::Kind::unreadable, printable(path.string()), "cannot be read: " + ec.message()};
  std::vector<Found> found;
  std::size_t entries = 0;
  collect(path, path, 0, found, notes, entries);
  if (entries > most_entries)
    notes.push_back("more than " + std::to_string(most_entries) + " entries: the rest was not looked at");
  return found;
}

Outcome<std::vector<Found>> files_of_archive(const fs::path& path, std::vector<std::string>& notes) {
  auto archive = read_archive(path);
  if (!archive) return archive.fault();
  Archive read = std::move(archive).value();
  notes.insert(notes.end(), read.notes.begin(), read.notes.end());
  std::vector<Found> found;
  for (ArchivedFile& file : read.files) {
    const fs::path inside(file.path);
    if (std::any_of(inside.begin(), inside.end(), [](const fs::path& part) { return part != "." && passed_by(part.string()); })) continue;
    const int depth = int(std::distance(inside.begin(), inside.end())) - 1;
    if (depth <= deepest) found.push_back({inside.filename(), file.path, depth, true, std::move(file.bytes)});
  }
  return found;
}

/// The submission in these files: expected ones by name, the rest beside them.
Outcome<Submission> pick_files(std::vector<Found> found, Submission s, const std::string& where) {
  using Kind = Fault::Kind;
  const auto first_note = [&s] { return s.notes.empty() ? std::string() : " (" + s.notes.front() + (s.notes.size() > 1 ? "; and " + std::to_string(s.notes.size() - 1) + " more" : "") + ")"; };
  if (found.empty()) return Fault{Kind::missing, where, s.notes.empty() ? "is empty, must hold a submission's files" : "holds no file to grade" + first_note()};
  std::stable_sort(found.begin(), found.end(), [](const Found& a, const Found& b) { return a.depth < b.depth; });

  std::uintmax_t total = 0;
  for (const Found& file : found) {
    const std::string base = lower(file.path.filename().string());
    const std::string ending = lower(file.path.extension().string());
    if (std::find(source_endings.begin(), source_endings.end(), ending) == source_endings.end()) continue;
    if (std::find(window_program.begin(), window_program.end(), base) != window_program.end()) continue;
    const auto name = std::find_if(expected.begin(), expected.end(),
                                   [&base](const char* e) { return lower(e) == base; });
    const std::string shown = printable(file.relative);
    if (name != expected.end() && s.find(*name) != nullptr) {
      s.notes.push_back(shown + ": not used, " + printable(s.find(*name)->path) + " is");
      continue;
    }
    if (name == expected.end() && !plain_name(file.path.filename().string())) {
      s.notes.push_back(shown + ": not used, its name is no name for a source file");
      continue;
    }
    const auto bytes = file.read();
    if (!bytes) {
      s.notes.push_back(shown + ": not used, it " + bytes.fault().what);
      continue;
    }
    if (bytes->find('\0') != std::string::npos) {
      s.notes.push_back(shown + ": not used, it is no text (save it as UTF-8)");
      continue;
    }
    if ((total += bytes->size()) > 16 * largest_file) {
      s.notes.push_back(shown + ": not used, the submission has more than 16 MiB of sources");
      continue;
    }
    SourceFile source{name != expected.end() ? *name : file.path.filename().string(), shown, plain_text(*bytes)};
    (name != expected.end() ? s.files : s.others).push_back(std::move(source));
  }
  const auto by_name = [](const SourceFile& a, const SourceFile& b) { return a.name < b.name; };
  std::stable_sort(s.files.begin(), s.files.end(), by_name);
  std::stable_sort(s.others.begin(), s.others.end(), by_name);
  const bool any = std::any_of(s.files.begin(), s.files.end(), [](const auto& f) { return f.name != "Constants.h"; });
  if (!any)
    return Fault{Kind::missing, where,
                 "holds none of Cuboid, CollisionPlane, ParticleSystem, MatrixUtils (.h or .cpp)" + first_note()};

  std::string all;
  for (const auto* list : {&s.files, &s.others})
    for (const SourceFile& f : *list) all += key_of(f.name, f.path, f.text);
  s.hash = sha256(all);
  return s;
}

bool is_expected(const Found& file) {
  const std::string base = lower(file.path.filename().string());
  return base != "constants.h" && std::any_of(expected.begin(), expected.end(), [&](const char* e) { return lower(e) == base; });
}

/// "Cuboid-1.cpp" of a second upload, "lovelaceada_LATE_12_34_Cuboid.cpp" of Canvas, "Ada_987_assignsubmission_file_Cuboid.cpp" of
/// Moodle: the file's own name.
std::string uploaded_name(const std::string& name) {
  static const std::regex canvas(R"(^[a-z0-9]+(?:_LATE|_late)?_\d+_\d+_(.+)$)"), again(R"(^(.*\w)-\d+(\.\w+)$)"),
      autolab(R"(^[^@\s]+@[^@_\s]+_\d+_(.+)$)"), moodle(R"(^.+_\d+_assignsubmission_file_(.+)$)");
  std::smatch match;
  std::string own = name;
  for (const std::regex* platform : {&moodle, &canvas, &autolab})
    if (own == name && std::regex_match(name, match, *platform)) own = match[1].str();
  return std::regex_match(own, match, again) ? match[1].str() + match[2].str() : own;
}

}  // namespace

std::string submission_name(const fs::path& path) {
  std::error_code ec;
  return printable(fs::weakly_canonical(fs::absolute(path, ec), ec).filename().string());
}

Outcome<Submission> open_submission(const fs::path& path) { return open_submission(std::vector<fs::path>{path}); }

Outcome<Submission> open_submission(const std::vector<fs::path>& paths) {
  using Kind = Fault::Kind;
  Submission s;
  std::vector<Found> found;
  for (const fs::path& path : paths) {
    const std::string where = printable(path.string());
    std::error_code ec;
    const auto status = fs::status(path, ec);
    if (!fs::exists(status)) return Fault{Kind::unreadable, where, "does not exist"};
    if (paths.size() > 1 && fs::is_symlink(path)) return Fault{Kind::unreadable, where, "is a symbolic link"};
    if (s.name.empty()) s.name = submission_name(path);
    const bool packed = fs::is_regular_file(status) && archive_name(path);
    if (fs::is_regular_file(status) && !packed && paths.size() == 1 && uploaded_name(path.filename().string()) == path.filename().string())
      return Fault{Kind::unreadable, where, "is neither a directory nor a .zip, .tar or .tar.gz file"};
    if (!packed && fs::is_regular_file(status)) {
      const std::string own = uploaded_name(path.filename().string());
      const auto bytes = read_file(path, largest_file);
      if (!bytes) s.notes.push_back(own + ": not used, it " + bytes.fault().what);
      else found.push_back({own, own, 0, true, *bytes});
      continue;
    }
    if (!packed && !fs::is_directory(status)) return Fault{Kind::unreadable, where, "is neither a directory nor an archive"};
    auto files = packed ? files_of_archive(path, s.notes) : files_of_directory(path, s.notes);
    if (!files) return files.fault();
    if (!packed && std::none_of(files->begin(), files->end(), is_expected))  // a folder around the archive that counts
      for (const Found& file : *files)
        if (archive_name(file.path)) {
          s.notes.push_back("unpacked from " + printable(file.relative));
          if (files = files_of_archive(file.path, s.notes); !files) return files.fault();
          break;
        }
    for (Found& file : std::move(files).value()) found.push_back(std::move(file));
  }
  return pick_files(std::move(found), std::move(s), printable(paths.front().string()));
}

}  // namespace rigor::grader
