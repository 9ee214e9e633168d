#include <archive.h>
#include <archive_entry.h>

#include <rigor/base/file.hpp>
#include <rigor/base/promise.hpp>
#include <rigor/grader/package.hpp>

namespace rigor::grader {
namespace {

la_ssize_t append(::archive*, void* to, const void* bytes, std::size_t n) {
  static_cast<std::string*>(to)->append(static_cast<const char*>(bytes), n);
  return la_ssize_t(n);
}

std::string packed(::archive* out, const Package& package) {
  std::string bytes;
  promise(archive_write_open(out, &bytes, nullptr, append, nullptr) == ARCHIVE_OK, "an archive can be written to memory");
  for (const PackagedFile& file : package) {
    archive_entry* entry = archive_entry_new();
    archive_entry_set_pathname(entry, file.path.c_str());
    archive_entry_set_filetype(entry, AE_IFREG);
    archive_entry_set_perm(entry, file.executable ? 0755 : 0644);
    archive_entry_set_mtime(entry, 1767225600, 0);  // 1 January 2026: a zip cannot say 1970
    archive_entry_set_size(entry, la_int64_t(file.bytes.size()));
    promise(archive_write_header(out, entry) == ARCHIVE_OK, "a header of an archive can be written");
    promise(archive_write_data(out, file.bytes.data(), file.bytes.size()) == la_ssize_t(file.bytes.size()), "a file fits its archive");
    archive_entry_free(entry);
  }
  promise(archive_write_close(out) == ARCHIVE_OK, "an archive can be finished");
  archive_write_free(out);
  return bytes;
}

}  // namespace

Outcome<bool> write_tree(const Package& package, const std::filesystem::path& directory) {
  for (const PackagedFile& file : package) {
    if (const auto written = write_file(directory / file.path, file.bytes); !written) return written;
    if (file.executable) std::filesystem::permissions(directory / file.path, std::filesystem::perms(0755));
  }
  return true;
}

std::string zipped(const Package& package) {
  ::archive* out = archive_write_new();
  archive_write_set_format_zip(out);
  return packed(out, package);
}

std::string tarred(const Package& package) {
  ::archive* out = archive_write_new();
  archive_write_set_format_ustar(out);
  archive_write_add_filter_gzip(out);
  archive_write_set_filter_option(out, "gzip", "timestamp", nullptr);
  return packed(out, package);
}

}  // namespace rigor::grader
