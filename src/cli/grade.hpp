#pragma once

namespace CLI {
class App;
}

namespace rigor::grader {
enum class Reader;
}

namespace rigor::cli {

/// `rigor grade PATH... [--rubric FILE] [--seed N] [--cases N] [--check ID] [--case N] [--format LIST] [--out DIR]`.
/// `reader` says who reads what it writes: for students (the grader that `rigor export` packs) neither the graded seed nor
/// hidden checks are in it, and in the kit there is one seed only.
void add_grade(CLI::App& app, int& exit_status, grader::Reader reader);

}  // namespace rigor::cli
