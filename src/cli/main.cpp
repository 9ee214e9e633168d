#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>
#include <rigor/base/float_environment.hpp>
#include <rigor/base/interrupt.hpp>
#include <rigor/base/suggest.hpp>
#include <rigor/cli/commands.hpp>
#include <string>
#include <utility>
#include <vector>

namespace {

// A wrong word after `rigor` is the commonest mistake: name the nearest command.
int unknown_command(const CLI::App& app, const std::string& word) {
  std::vector<std::string> known{"test"};
  for (const CLI::App* command : app.get_subcommands({})) known.push_back(command->get_name());
  std::fprintf(stderr, "rigor: there is no command '%s'%s; 'rigor --help' lists them\n", word.c_str(),
               rigor::did_you_mean(word, known).c_str());
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  if (const auto fault = rigor::float_environment_fault()) {
    std::fprintf(stderr, "rigor: %s\n", fault->text().c_str());
    return 3;
  }
  CLI::App app{"rigor: rigid-body dynamics for cuboids, verified; grading, studies, simulation", "rigor"};
  app.require_subcommand(1);
  app.set_version_flag("--version", "rigor " RIGOR_VERSION);
  app.footer("Start with:  ./rigor demo      Every command: rigor COMMAND --help");
  int exit_status = 0;
  rigor::cli::add_commands(app, exit_status);
  if (argc > 1 && argv[1][0] != '-') {
    const std::string word = argv[1];
    const auto named = [&](const CLI::App* command) { return command->get_name() == word; };
    if (std::as_const(app).get_subcommands(named).empty()) return unknown_command(app, word);
  }
  try {
    rigor::catch_interrupts();
    app.parse(argc, argv);
    return exit_status;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "rigor: out of memory; a shorter run, fewer bodies or a larger output interval needs less\n");
    return 3;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "rigor: internal error: %s\n", error.what());
    return 3;
  }
}
