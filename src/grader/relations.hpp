#pragma once
#include <rigor/grader/diagnose.hpp>

namespace rigor::grader {

/// A simple relation between what the student's code gave and what is right that holds on every case of a check, in
/// words; "" when there is none. Looked for where no known mistake fits: nothing happens, a constant factor (with its
/// value) or sign, a transposed matrix, exchanged components, a constant difference, one axis wrong and the others right, one
/// quantity of several by a factor, a change of one step that goes with another power of dt. Nothing where another reading
/// of the same numbers is as good: answers that are the same whatever is given, or too large to show a change.
std::string relation(const Check& check, const std::vector<Record>& records);

}  // namespace rigor::grader
