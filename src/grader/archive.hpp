#pragma once
#include <cstdint>
#include <filesystem>
#include <rigor/base/outcome.hpp>
#include <string>
#include <vector>

namespace rigor::grader {

/// A regular file of an archive, in memory. Nothing is ever unpacked to a place an archive names.
struct ArchivedFile {
  std::string path;   ///< as the archive has it, "/" between parts; relative, without ".." (others are left aside)
  std::string bytes;
};

struct Archive {
  std::vector<ArchivedFile> files;
  std::vector<std::string> notes;   ///< what was left aside and why, one line each
};

struct ArchiveLimits {
  std::uint64_t packed_bytes = 64u << 20;    ///< of the archive itself
  std::uint64_t unpacked_bytes = 64u << 20;  ///< of everything kept
  std::uint64_t file_bytes = 1u << 20;       ///< of one file; larger ones are left aside
  std::size_t entries = 20000;
};

/// Whether the name ends like an archive that read_archive reads: .zip, .tar, .tar.gz, .tgz.
bool archive_name(const std::filesystem::path& path);

/// Reads a zip or tar file. Symbolic and hard links, special files, absolute paths, paths with ".." and encrypted files
/// are left aside with a note.
/// Faults: unreadable; malformed (no archive, damaged); out_of_range (over a limit, or from 4 MiB
/// on to more than 200 times its size: a bomb is not read to its end).
Outcome<Archive> read_archive(const std::filesystem::path& path, const ArchiveLimits& limits = {});

}  // namespace rigor::grader
