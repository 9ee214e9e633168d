// Checks and misconceptions of your own go into this one file; docs/examples/own.cpp has one of each.
#include <rigor/grader/check.hpp>
#include <rigor/grader/misconceptions.hpp>

namespace rigor::grader {

std::vector<Misconception> own_misconceptions() { return {}; }
std::vector<Check> own_checks() { return {}; }

}  // namespace rigor::grader
