#pragma once

namespace CLI {
class App;
}

namespace rigor::cli {

/// `rigor demo [--out DIR]`: the main jobs on bundled input, one page at the end.
void add_demo(CLI::App& app, int& exit_status);

}  // namespace rigor::cli
