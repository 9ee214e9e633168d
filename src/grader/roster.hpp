#pragma once
#include <filesystem>
#include <rigor/base/outcome.hpp>
#include <string>
#include <vector>

namespace rigor::grader {

/// Somebody who handed in, in the words of the platform; "" where it does not say.
struct Person {
  std::string name{};       ///< full name; of a plain folder or archive, its name
  std::string email{};      ///< Autolab, Gradescope
  std::string school_id{};  ///< Gradescope's "sid"
  std::string canvas_id{};  ///< the number in Canvas' file names
  std::string participant{};  ///< the number in Moodle's folder names
};

/// One submission of a class directory: which one counts, and what its name says.
struct Entry {
  std::string student;           ///< e-mail, name or folder; two of a group, or the first and how many others; no two are alike
  std::vector<std::filesystem::path> uploads;  ///< of the submission that counts: a directory, an archive, or several files
  int version = 0;               ///< from the name, where it has one
  int versions = 1;              ///< how many were there
  bool late = false;             ///< the platform marked it late; shown, never applied
  std::vector<Person> people{};  ///< who gets the points; empty where only the name of folder or archive is known
  std::string trouble{};         ///< why it cannot be said which submission counts; it is not graded then
};

/// Reads the layouts of Autolab (`<email>_<version>_<file>`, highest version wins), Canvas
/// (`<name>[_LATE]_<id>_<attachment>_<file>`, all files of one id together), Gradescope
/// (`assignment_<n>_export/submission_<id>`, everybody submission_metadata.yml lists), Moodle
/// (`<name>_<id>_assignsubmission_file_`, with or without a folder; text typed online is passed by where there are files) and
/// one folder or archive per student (GitHub), by the names in the directory.
/// Symbolic links are passed by. Two uploads of one student where no version decides are that student's trouble.
/// Sorted by student. Faults: unreadable (no directory), missing (no student in it), malformed (several exports of Gradescope).
Outcome<std::vector<Entry>> read_roster(const std::filesystem::path& directory);

/// A whole class in one zip or tar file, as platforms hand it out: its files below `to`, in place of what is there. Gives the
/// directory to read: `to`, or the only one in it where that holds several directories or archives.
/// Faults: those of read_archive, unwritable.
Outcome<std::filesystem::path> unpack_class(const std::filesystem::path& archive, const std::filesystem::path& to);

}  // namespace rigor::grader
