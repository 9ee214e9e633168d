#pragma once
#include <rigor/grader/build.hpp>
#include <rigor/grader/model.hpp>
#include <string>
#include <vector>

namespace rigor::grader {

/// One way to write the assignment that gives other numbers than the right one.
struct Misconception {
  std::string id;            ///< "update.no-gyroscopic"
  StudentFunction function;  ///< whose results it changes first
  std::string formula;       ///< id for `rigor explain`
  std::string text;          ///< one sentence for the student
  void (*set)(Habits&);
  std::string same_as{};     ///< the one it cannot be told from, being the same function of every input; that one is named
};

/// Wrong: must fail a check, and is named to the student.
const std::vector<Misconception>& misconceptions();
/// An instructor's, in own.cpp; they are among the above.
std::vector<Misconception> own_misconceptions();
/// Legitimate readings of the assignment: must pass everything, and are named in the report.
const std::vector<Misconception>& variants();

/// The readings whose text (Misconception::text) a judge gives as its note: a rubric can refuse these.
const std::vector<std::string>& refusable_readings();

const Misconception* find_misconception(const std::string& id);
/// The model student with the given misconceptions (ids separated by '+'; "" is right).
Habits habits_with(const std::string& ids);

}  // namespace rigor::grader
