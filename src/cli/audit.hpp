#pragma once

namespace CLI {
class App;
}

namespace rigor::cli {

/// `rigor audit [--seeds N] [--cases N] [--json]`
void add_audit(CLI::App& app, int& exit_status);

}  // namespace rigor::cli
