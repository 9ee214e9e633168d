#pragma once

namespace CLI {
class App;
}

namespace rigor::cli {

/// `rigor study convergence|work-precision [--problem P] [--method M,...] [--rungs N] [--out DIR]`
void add_study(CLI::App& app, int& exit_status);

}  // namespace rigor::cli
