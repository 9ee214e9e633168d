#pragma once

namespace CLI {
class App;
}

namespace rigor::cli {

/// `rigor view SCENE [--port N] [--seed N] [--method M]`
void add_view(CLI::App& app, int& exit_status);

}  // namespace rigor::cli
