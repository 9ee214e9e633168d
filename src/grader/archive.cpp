#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <memory>
#include <rigor/grader/archive.hpp>
#include <rigor/grader/printable.hpp>

namespace rigor::grader {
namespace {

namespace fs = std::filesystem;

constexpr double most_times = 200;  // text packs 5 to 20 times, a bomb a thousand

struct Close {
  void operator()(::archive* a) const { archive_read_free(a); }
};

// Relative, every part a plain name: what may be shown and matched without meaning another place.
bool stays_inside(const std::string& path) {
  if (path.empty() || path.front() == '/' || path.find(':') == 1) return false;
  const fs::path parts(path);
  return std::none_of(parts.begin(), parts.end(), [](const fs::path& part) { return part == ".."; });
}

Fault too_large(const fs::path& path, const std::string& what) {
  return {Fault::Kind::out_of_range, printable(path.string()), what + "; it was not read to its end"};
}

}  // namespace

bool archive_name(const fs::path& path) {
  std::string name = path.filename().string();
  for (char& c : name) c = char(std::tolower(static_cast<unsigned char>(c)));
  for (const char* ending : {".zip", ".tar", ".tar.gz", ".tgz"})
    if (name.ends_with(ending)) return true;
  return false;
}

Outcome<Archive> read_archive(const fs::path& path, const ArchiveLimits& limits) {
  using Kind = Fault::Kind;
  std::error_code ec;
  const std::uint64_t packed = fs::file_size(path, ec);
  if (ec) return Fault{Kind::unreadable, printable(path.string()), "cannot be read: " + ec.message()};
  if (packed > limits.packed_bytes)
    return too_large(path, "is " + std::to_string(packed >> 20) + " MiB large, at most " + std::to_string(limits.packed_bytes >> 20) + " MiB are read");

  const std::unique_ptr<::archive, Close> in(archive_read_new());
  archive_read_support_format_zip(in.get());
  archive_read_support_format_tar(in.get());
  archive_read_support_filter_gzip(in.get());
  const auto malformed = [&] {
    const char* why = archive_error_string(in.get());
    return Fault{Kind::malformed, printable(path.string()), std::string("is no zip or tar file that can be read") + (why != nullptr ? ": " + printable(why) : "")};
  };
  if (archive_read_open_filename(in.get(), path.c_str(), 1 << 16) != ARCHIVE_OK) return malformed();

  Archive archive;
  std::uint64_t kept = 0, declared_all = 0;
  std::size_t entries = 0;
  for (;;) {
    archive_entry* entry = nullptr;
    const int status = archive_read_next_header(in.get(), &entry);
    if (status == ARCHIVE_EOF) break;
    if (status < ARCHIVE_WARN) return malformed();
    if (++entries > limits.entries) return too_large(path, "has more than " + std::to_string(limits.entries) + " entries");
    // what lies between headers is unpacked too where the whole file is compressed as one stream
    if (archive_filter_bytes(in.get(), 0) > std::int64_t(4 * limits.unpacked_bytes)) return too_large(path, "unpacks to too much");
    const char* raw = archive_entry_pathname(entry);
    std::string name = raw != nullptr ? raw : "";
    std::replace(name.begin(), name.end(), '\\', '/');  // packed on Windows
    const std::string shown = printable(name);
    if (archive_entry_filetype(entry) == AE_IFDIR) continue;
    // passing by a member of a tar.gz unpacks it all the same
    const std::int64_t declared = archive_entry_size_is_set(entry) != 0 ? archive_entry_size(entry) : 0;
    if (declared > std::int64_t(4 * limits.unpacked_bytes)) return too_large(path, "unpacks to too much");
    declared_all += std::uint64_t(std::max<std::int64_t>(0, declared));
    if (declared_all > 4u << 20 && double(declared_all) > most_times * double(packed))
      return too_large(path, "unpacks to more than " + std::to_string(int(most_times)) + " times its size");
    if (archive_entry_filetype(entry) != AE_IFREG || archive_entry_hardlink(entry) != nullptr) {
      archive.notes.push_back(shown + ": a link or special file, not used");
    } else if (!stays_inside(name)) {
      archive.notes.push_back(shown + ": not used, its path leads out of the archive");
    } else if (archive_entry_is_encrypted(entry) != 0) {
      archive.notes.push_back(shown + ": not used, it is encrypted");
    } else {
      std::string bytes;
      char buffer[1 << 16];
      bool whole = true;
      for (;;) {
        const la_ssize_t n = archive_read_data(in.get(), buffer, sizeof buffer);
        if (n < 0) return malformed();
        if (n == 0) break;
        if (bytes.size() + std::size_t(n) > limits.file_bytes) {
          whole = false;
          break;
        }
        bytes.append(buffer, std::size_t(n));
      }
      if (!whole) {
        archive.notes.push_back(shown + ": not used, it is larger than " + std::to_string(limits.file_bytes >> 10) + " KiB");
        continue;
      }
      kept += bytes.size();
      if (kept > limits.unpacked_bytes) return too_large(path, "unpacks to more than " + std::to_string(limits.unpacked_bytes >> 20) + " MiB");
      archive.files.push_back({name, std::move(bytes)});
    }
  }
  std::stable_sort(archive.files.begin(), archive.files.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
  return archive;
}

}  // namespace rigor::grader
