#pragma once
#include <filesystem>
#include <rigor/base/outcome.hpp>
#include <string>
#include <vector>

namespace rigor::grader {

/// One text file of a submission.
struct SourceFile {
  std::string name;  ///< "Cuboid.cpp" whatever the letter case in the submission
  std::string path;  ///< as the student knows it, relative to the submission
  std::string text;  ///< no byte-order mark, line ends "\n"
};

/// What a student handed in, read once; nothing of it has been compiled or run.
struct Submission {
  std::string name;                ///< of the directory
  std::vector<SourceFile> files;   ///< of Cuboid, CollisionPlane, ParticleSystem, MatrixUtils (.h, .cpp) and
                                   ///< Constants.h those that are there, one of each
  std::vector<SourceFile> others;  ///< further headers and sources, used when a file of the list asks for them
  std::vector<std::string> notes;  ///< what was left aside and why, one line each
  std::string hash;                ///< of everything above: same hash, same grade

  /// nullptr when the submission does not bring it.
  const SourceFile* find(const std::string& file_name) const;
};

/// What a submission is called in reports, and below --out: the last part of the path, without what a terminal interprets.
std::string submission_name(const std::filesystem::path& path);

/// Reads a directory, or a zip or tar file (in memory, docs/grading.md has the limits). Expected files are found by base name at any depth and in any letter case; the window
/// program (PBFApp.cpp, main.cpp) is left aside, and so are symbolic links, special files and files over 1 MiB.
/// Of several with one name the one least deep counts, then the first in alphabetical order; a note says so.
/// Faults: unreadable (missing, neither directory nor archive), malformed or out_of_range (the archive), missing (empty,
/// or none of the expected files).
Outcome<Submission> open_submission(const std::filesystem::path& path);
/// One submission in several uploads: single files whose names a platform has lengthened, archives, directories.
Outcome<Submission> open_submission(const std::vector<std::filesystem::path>& uploads);

}  // namespace rigor::grader
