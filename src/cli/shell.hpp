#pragma once
#include <string>

namespace CLI {
class App;
}

namespace rigor::cli {

/// Written from the help, so that they know every command and option: completion to source in bash or to put into zsh's
/// fpath, and a man page in roff.
std::string bash_completion(const CLI::App& app);
std::string zsh_completion(const CLI::App& app);
std::string man_page(const CLI::App& app);

/// `rigor shell bash|zsh|man`
void add_shell(CLI::App& app, int& exit_status);

}  // namespace rigor::cli
