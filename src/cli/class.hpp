#pragma once

namespace CLI {
class App;
}

namespace rigor::cli {

/// `rigor class DIR [--rubric FILE] [--jobs N] [--fresh] [--out DIR]`
void add_class(CLI::App& app, int& exit_status);

}  // namespace rigor::cli
