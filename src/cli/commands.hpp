#pragma once

namespace CLI {
class App;
}

namespace rigor::cli {

/// Adds every command of the program. A command runs in its CLI11 callback and leaves its exit status
/// (0 done, 1 a check of rigor itself did not hold, 2 bad input) in `exit_status`.
void add_commands(CLI::App& app, int& exit_status);

}  // namespace rigor::cli
