#pragma once
#include <CLI/CLI.hpp>

namespace rigor::cli {

void add_check_table(CLI::App& app, int& exit_status);

}  // namespace rigor::cli
