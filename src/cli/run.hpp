#pragma once

namespace CLI {
class App;
}

namespace rigor::cli {

/// `rigor run SCENE [--method M] [--dt S] [--until S] [--every S] [--seed N] [--out DIR] [--beside M,...]`
void add_run(CLI::App& app, int& exit_status);

}  // namespace rigor::cli
