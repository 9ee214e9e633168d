#pragma once
#include <filesystem>
#include <rigor/base/outcome.hpp>
#include <string>
#include <vector>

namespace rigor::grader {

/// One student of a class directory: which submission counts, and what its name says.
struct Entry {
  std::string student;           ///< e-mail, name or folder
  std::filesystem::path path;    ///< of the submission that counts
  int version = 0;               ///< from the name, where it has one
  int versions = 1;              ///< how many were there
  bool late = false;             ///< the platform marked it late; shown, never applied
};

/// Reads the directory layouts of Autolab (`<email>_<version>_<file>`, highest version wins), Canvas
/// (`<name>[_LATE]_<id>_<attachment>_<file>`), Gradescope (`assignment_<n>_export/submission_<id>`) and one folder per
/// student (GitHub, Moodle), by the names of the directories in it. Sorted by student.
/// Faults: unreadable (no directory), missing (no student in it).
Outcome<std::vector<Entry>> read_roster(const std::filesystem::path& directory);

}  // namespace rigor::grader
