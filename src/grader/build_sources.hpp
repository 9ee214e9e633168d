#pragma once
#include <map>
#include <rigor/grader/build.hpp>
#include <rigor/grader/build_compile.hpp>
#include <rigor/grader/build_text.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace rigor::grader {

/// A file as it is compiled.
struct Source {
  std::string path{};    // as the student knows it
  std::string text{};
  bool own = true;       // the student's, or the kit's
  bool expected = true;  // one of the list, or another the student brought
  std::set<std::string> replaced{};  // names of the functions whose bodies were
};

/// Compiled as a source, not a header.
bool is_source(const std::string& name);

/// One line, at most 400 characters.
std::string clipped(std::string text);

/// What is compiled of a submission: the student's files, completed from the kit; and the rules of what is replaced
/// when the compiler refuses: the smallest piece that holds the error, and nothing else.
class Sources {
 public:
  /// Looks at every function: as handed out, not there, or in `replaced` and so taken from the kit.
  Sources(const Submission& submission, const std::set<StudentFunction>& replaced);

  const std::map<std::string, Source>& files() const { return sources_; }
  std::string headers_key() const;  ///< changes with any header

  /// Replaces what `c`, a failed compilation of `name`, complains about; false when nothing is left to replace.
  bool repair(const std::string& name, const Compilation& c);
  /// The same for a failed linking. "Cuboid.cpp.o: in function `Cuboid::update(double)':" then what it misses: that
  /// function is replaced.
  bool repair_linking(const Compilation& c);
  void note(std::string text);

  /// After the last repair; `complete` when a program was linked, else no function counts as compiled.
  void report_to(BuildResult& result, bool complete) const;

 private:
  void bring_in(const Submission& s);
  void look_at_functions(const std::set<StudentFunction>& replaced);
  /// Where the student wrote it: in its own file or another.
  std::pair<Source*, Definition> find(const std::string& function);
  /// What a file left out of the handed-out one, at its end: functions its header declares, static members.
  void complete(const std::string& c);

  bool repair_at(const std::string& name, const std::vector<Diagnostic>& errors);
  bool leave_out_include(const Diagnostic& e);
  /// The body that holds the error; false when there is none, or it has been replaced before.
  bool replace_function_at(const Diagnostic& e);
  bool replace_unsound(Source& source, const Diagnostic& e);
  bool replace(Source& source, const Definition& d, const Diagnostic& e);
  /// The kit's file instead of the student's; false when it is that already, or there is none.
  bool give_up(const std::string& name, const Diagnostic& e);
  /// The driver, or the kit's file, does not fit the student's headers: the kit's headers for the classes it
  /// complains about, or for all.
  bool repair_headers(const std::string& output);

  FunctionStatus& status(StudentFunction f) { return functions_[std::size_t(f)]; }
  std::string shown(const Diagnostic& e) const;

  std::map<std::string, Source> sources_;
  std::array<FunctionStatus, student_functions> functions_;
  std::set<StudentFunction> absent_;  // in no file of the submission
  bool own_constants_ = false;
  std::vector<std::string> notes_;
  std::string last_error_;
};

}  // namespace rigor::grader
