#include <algorithm>
#include <array>
#include <cctype>
#include <rigor/base/file.hpp>
#include <rigor/grader/build_hash.hpp>
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

/// A name for a message: no line of a report is broken or coloured by what a file is called.
std::string printable(const std::string& name) {
  std::string shown = name.substr(0, 200);
  for (char& c : shown)
    if (static_cast<unsigned char>(c) < 32 || c == 127) c = '?';
  return shown;
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

struct Found {
  fs::path path;
  std::string relative;
  int depth;
};

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
      const std::string plain = lower(name);
      if (name.starts_with('.') || plain == "__macosx" || plain == "debug" || plain == "release") continue;
      if (depth < deepest) collect(root, entry.path(), depth + 1, files, notes, entries);
    } else if (entry.is_regular_file(ec) && !name.starts_with('.')) {
      files.push_back({entry.path(), relative, depth});
    }
  }
}

}  // namespace

const SourceFile* Submission::find(const std::string& file_name) const {
  for (const SourceFile& file : files)
    if (file.name == file_name) return &file;
  return nullptr;
}

Outcome<Submission> open_submission(const fs::path& path) {
  using Kind = Fault::Kind;
  std::error_code ec;
  const auto status = fs::status(path, ec);
  if (!fs::exists(status)) return Fault{Kind::unreadable, printable(path.string()), "does not exist"};
  if (!fs::is_directory(status))
    return Fault{Kind::unreadable, printable(path.string()), "is not a directory; a submission is a directory"};
  if (fs::directory_iterator(path, ec); ec)
    return Fault{Kind::unreadable, printable(path.string()), "cannot be read: " + ec.message()};

  Submission s;
  s.name = printable(fs::weakly_canonical(path, ec).filename().string());
  std::vector<Found> found;
  std::size_t entries = 0;
  collect(path, path, 0, found, s.notes, entries);
  if (entries > most_entries)
    s.notes.push_back("more than " + std::to_string(most_entries) + " entries: the rest was not looked at");
  if (found.empty()) return Fault{Kind::missing, printable(path.string()), "is empty, must hold a submission's files"};
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
    const auto bytes = read_file(file.path, largest_file);
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
    return Fault{Kind::missing, printable(path.string()),
                 "holds none of Cuboid, CollisionPlane, ParticleSystem, MatrixUtils (.h or .cpp)"};

  std::string all;
  for (const auto* list : {&s.files, &s.others})
    for (const SourceFile& f : *list) all += key_of(f.name, f.path, f.text);
  s.hash = sha256(all);
  return s;
}

}  // namespace rigor::grader
