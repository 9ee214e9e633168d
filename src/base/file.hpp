#pragma once
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <rigor/base/outcome.hpp>
#include <sstream>
#include <string>

namespace rigor {

/// The whole file as bytes. Faults: unreadable (missing, a directory, no permission, more than `limit`
/// bytes).
inline Outcome<std::string> read_file(const std::filesystem::path& path, std::uintmax_t limit = 64u << 20) {
  std::error_code ec;
  const auto status = std::filesystem::status(path, ec);
  if (!std::filesystem::exists(status))
    return Fault{Fault::Kind::unreadable, path.string(), "does not exist"};
  if (!std::filesystem::is_regular_file(status))
    return Fault{Fault::Kind::unreadable, path.string(), "is not a regular file"};
  const std::uintmax_t size = std::filesystem::file_size(path, ec);
  if (ec || size > limit)
    return Fault{Fault::Kind::unreadable, path.string(),
                 "has " + std::to_string(size) + " bytes, at most " + std::to_string(limit) + " are read"};
  std::ifstream in(path, std::ios::binary);
  std::ostringstream out;
  if (size > 0) out << in.rdbuf();  // of nothing, << would set the failure flag
  if (!in || !out) return Fault{Fault::Kind::unreadable, path.string(), "cannot be read"};
  return out.str();
}

/// Writes a file whole or not at all: a temporary beside it, then a rename. Missing directories are made.
/// Faults: unwritable, with the system's reason; then `path` is as it was.
inline Outcome<bool> write_file(const std::filesystem::path& path, const std::string& bytes) {
  const auto fault = [&](const std::string& why) {
    return Fault{Fault::Kind::unwritable, path.string(), "cannot be written: " + why};
  };
  std::error_code ec;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), ec);
  if (ec) return fault(ec.message());
  static std::atomic<unsigned> written_so_far{0};  // several threads may write one file at a time
  const std::filesystem::path temporary = path.string() + ".part-" + std::to_string(::getpid()) + "-" + std::to_string(written_so_far++);
  std::FILE* file = std::fopen(temporary.c_str(), "wb");
  if (file == nullptr) return fault(std::strerror(errno));
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  const int why = errno;
  const bool closed = std::fclose(file) == 0;
  if (written && closed) std::filesystem::rename(temporary, path, ec);
  if (!written || !closed || ec) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    return fault(ec ? ec.message() : std::strerror(why));
  }
  return true;
}

}  // namespace rigor
