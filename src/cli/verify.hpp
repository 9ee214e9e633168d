#pragma once

namespace CLI {
class App;
}

namespace rigor::cli {

/// `rigor verify [--id ID] [--cases N] [--time S] [--seed N] [--json]`
void add_verify(CLI::App& app, int& exit_status);

}  // namespace rigor::cli
