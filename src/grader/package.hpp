#pragma once
#include <filesystem>
#include <rigor/base/outcome.hpp>
#include <string>
#include <vector>

namespace rigor::grader {

/// A file of a package that is made in memory: relative path, bytes, and whether it is a program.
struct PackagedFile {
  std::string path;
  std::string bytes;
  bool executable = false;
};
using Package = std::vector<PackagedFile>;

/// As files below a directory. Faults: unwritable.
Outcome<bool> write_tree(const Package& package, const std::filesystem::path& directory);

/// The bytes of a zip or tar.gz file; the same package gives the same bytes.
std::string zipped(const Package& package);
std::string tarred(const Package& package);

}  // namespace rigor::grader
