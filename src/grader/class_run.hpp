#pragma once
#include <functional>
#include <map>
#include <rigor/grader/judge.hpp>
#include <rigor/grader/roster.hpp>

namespace rigor::grader {

inline constexpr const char* stopped = "interrupted";

/// One line of a class: read back from the student's report.json, so that a resumed run shows what a fresh one would.
struct ClassRow {
  Entry entry;
  std::string trouble;                           ///< why it could not be graded, `stopped` by Ctrl-C; "" when it was
  double score = 0, max_score = 0;
  std::map<std::string, double> points;          ///< by check id
  std::vector<std::pair<std::string, double>> groups;  ///< the report's headings and the points under them
  std::map<std::string, std::string> verdicts;   ///< by check id
  std::vector<std::string> diagnoses;            ///< misconception ids
  std::string fingerprint;                       ///< the worst ratios of the failed checks, to all digits; "" with none
  std::string tool, rubric_hash, submission_hash;
  bool reused = false;                           ///< taken from an earlier run
};

struct ClassOptions {
  std::filesystem::path out;
  int jobs = 1;
  bool fresh = false;                            ///< grade again what has a report already
  std::string tool;
  int asked_cases = 0;                           ///< where the command line asked for more than the rubric; else 0
  std::function<void(int done, int all)> progress = [](int, int) {};
};

/// Grades every entry into `out`/STUDENT/ (report.json, report.html, report.txt). A submission whose report was made by
/// the same tool with the same rubric from the same files is not graded again. One bad submission never stops the
/// others; an interrupt leaves whole files, and the next run goes on.
std::vector<ClassRow> grade_class(const std::vector<Entry>& entries, const Rubric& rubric, const ClassOptions& options);

/// Takes the reports (report.html, report.txt, report.json) of those away who have no grade in `rows`, or are not among them:
/// nobody shall find an old mark. Those the interrupt left ungraded keep theirs. Gives the students' names.
/// Call with every row graded or in trouble.
std::vector<std::string> remove_stale_reports(const std::filesystem::path& out, const std::vector<ClassRow>& rows);

/// Everybody with a report below the --out of an earlier run; of the entry only the name is known.
/// Faults: unreadable (no directory), malformed (no scores.csv of a run in it).
Outcome<std::vector<ClassRow>> read_class(const std::filesystem::path& out);

/// What a regrade changed: student, points before and after, and why (files, tool or rubric differ; checks whose verdict
/// changed; new; gone). Left out are students whose points and verdicts are the same, and those without a grade before and after.
struct Change {
  std::string student;
  double before, after;         ///< NaN where there is no grade
  std::string why;              ///< "other rubric; force.sum fail -> pass"
};
std::vector<Change> changes(const std::vector<ClassRow>& before, const std::vector<ClassRow>& after);
std::string changes_csv(const std::vector<Change>& list);

/// A gradebook with the points filled in, every other cell as it was. The points go to the column `column` ("Grade" when
/// empty); without a header, in Autolab's form (e-mail first), to the second. A row is a student's where what the platform
/// said of him stands in it, letter case aside: e-mail (columns Email, Email address, SIS Login ID, Username), the school's
/// number (SIS User ID, Student ID, SID, ID number), Canvas' number (ID), Moodle's participant number (Identifier), failing
/// that Moodle's full name (Full name) if it is there once; the name of a plain folder or archive in any of these or in
/// Student. Where two rows fit one student, or two students one row, none is filled in.
/// Faults: unreadable, malformed (no column that names students), missing (no column `column`; the message lists them).
struct Filled {
  std::string csv;
  int filled = 0, rows = 0;             ///< rows of students, without Canvas' "Points Possible"
  std::vector<std::string> remarks;     ///< overwritten values, rows left as they were, students without a row, other points possible: a line each
};
Outcome<Filled> fill_gradebook(const std::filesystem::path& gradebook, const std::string& column, const std::vector<ClassRow>& rows);

std::string scores_csv(const std::vector<ClassRow>& rows);
std::string matrix_csv(const std::vector<ClassRow>& rows);
std::string class_html(const std::vector<ClassRow>& rows, const Rubric& rubric, const std::vector<Change>& changed = {});
/// The three beside the reports: scores.csv, matrix.csv, class.html. Faults: unwritable.
Outcome<bool> write_class(const std::filesystem::path& out, const std::vector<ClassRow>& rows, const Rubric& rubric, const std::vector<Change>& changed = {});

/// Pairs (a, b): a failed everything b failed and more, yet has more points. Empty when grading is fair.
std::vector<std::pair<std::string, std::string>> unfair(const std::vector<ClassRow>& rows);

/// A student's name as a directory name: letters, digits, . _ - @ stay, the rest becomes %XX; a long one ends with its hash.
std::string safe_name(const std::string& student);

}  // namespace rigor::grader
