#pragma once

namespace CLI {
class App;
}

namespace rigor::cli {

/// `rigor grade PATH... [--rubric FILE] [--seed N] [--cases N] [--check ID] [--case N] [--format LIST] [--out DIR]`
void add_grade(CLI::App& app, int& exit_status);

}  // namespace rigor::cli
