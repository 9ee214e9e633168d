#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <memory>
#include <new>
#include <regex>
#include <rigor/base/float_environment.hpp>
#include <rigor/base/interrupt.hpp>
#include <rigor/base/suggest.hpp>
#include <rigor/cli/commands.hpp>
#include <rigor/cli/terminal_width.hpp>
#include <rigor/report/wrap.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

// The help, as wide as the terminal.
class Filled : public CLI::Formatter {
  std::size_t width_ = rigor::cli::terminal_width();
  std::string beside_names(const std::string& text) const {
    std::string lines = rigor::report::filled(text, width_ - column_width_, 0);
    while (!lines.empty() && lines.back() == '\n') lines.pop_back();
    return lines;
  }
  std::string make_option_desc(const CLI::Option* option) const override { return beside_names(option->get_description()); }
  std::string make_subcommand(const CLI::App* command) const override {
    std::ostringstream out;
    CLI::detail::format_help(out, command->get_name(), beside_names(command->get_description()), column_width_);
    return out.str();
  }
  std::string make_description(const CLI::App* app) const override { return rigor::report::filled(app->get_description(), width_, 0); }
  std::string make_footer(const CLI::App* app) const override {
    std::istringstream lines(app->get_footer());
    std::string text;
    for (std::string line; std::getline(lines, line);) text += line.size() > width_ ? rigor::report::filled(line, width_, 0) : line + "\n";
    return text;
  }
};

// A wrong word after `rigor` is the commonest mistake: name the nearest command.
int unknown_command(const CLI::App& app, const std::string& word) {
  std::vector<std::string> known{"test", "help"};
  for (const CLI::App* command : app.get_subcommands({})) known.push_back(command->get_name());
  std::fprintf(stderr, "rigor: there is no command '%s'%s; 'rigor --help' lists them\n", word.c_str(),
               rigor::did_you_mean(word, known).c_str());
  return 2;
}

// One line: the command, what is wrong with which word, and where to look.
int usage_error(const CLI::App& app, const CLI::ParseError& error, const std::vector<std::string>& words) {
  const auto parsed = app.get_subcommands();
  const CLI::App& command = parsed.empty() ? app : *parsed.front();
  std::string what = error.what();
  if (const std::size_t end = what.find('\n'); end != std::string::npos) what.resize(end);
  static const std::regex out_of_range("^([^ :]+): is "), no_number("^Could not convert: ([^ ]+) = "), no_value("^([^ :]+): [0-9]+ required .* missing");
  if (dynamic_cast<const CLI::ValidationError*>(&error) != nullptr) what = std::regex_replace(what, out_of_range, "$1 is ");
  if (dynamic_cast<const CLI::ConversionError*>(&error) != nullptr) what = std::regex_replace(what, no_number, "$1 is ") + ", must be a number";
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) what = std::regex_replace(what, no_value, "$1 needs a value");
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    std::vector<std::string> known;
    for (const CLI::Option* option : command.get_options()) known.push_back("--" + option->get_single_name());
    for (const std::string& word : words) {
      const std::string flag = word.substr(0, word.find('='));
      if (flag.size() < 2 || flag[0] != '-' || command.get_option_no_throw(flag) != nullptr) continue;
      what = "there is no option '" + flag + "'" + rigor::did_you_mean(flag, known);
      break;
    }
  }
  const std::string name = parsed.empty() ? "rigor" : "rigor " + command.get_name();
  std::fprintf(stderr, "%s: %s; '%s --help' shows what it takes\n", name.c_str(), what.c_str(), name.c_str());
  return 2;
}

// Output that did not arrive is no success.
int flushed(int exit_status) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return exit_status;
  std::fprintf(stderr, "rigor: standard output cannot be written: %s\n", std::strerror(errno));
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  if (const auto fault = rigor::float_environment_fault()) {
    std::fprintf(stderr, "rigor: %s\n", fault->text().c_str());
    return 3;
  }
  CLI::App app{"rigor: rigid-body dynamics for cuboids, verified; grading, studies, simulation", "rigor"};
  app.formatter(std::make_shared<Filled>());
  app.require_subcommand(1);
  app.set_version_flag("--version", "rigor " RIGOR_VERSION);
  app.footer("Start with:  ./rigor demo      Every command: rigor help COMMAND");
  int exit_status = 0;
  rigor::cli::add_commands(app, exit_status);
  std::vector<std::string> words(argv + 1, argv + argc);
  if (!words.empty() && words[0] == "help") words = words.size() == 1 ? std::vector<std::string>{"--help"} : std::vector<std::string>{words[1], "--help"};
  if (!words.empty() && words[0][0] != '-') {
    const auto named = [&](const CLI::App* command) { return command->get_name() == words[0]; };
    if (std::as_const(app).get_subcommands(named).empty()) return unknown_command(app, words[0]);
  }
  try {
    rigor::catch_interrupts();
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // CLI11 takes the last word first
    return flushed(exit_status);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return flushed(app.exit(error));  // --help, --version
    return usage_error(app, error, words);
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "rigor: out of memory; a shorter run, fewer bodies or a larger output interval needs less\n");
    return 3;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "rigor: internal error: %s\n", error.what());
    return 3;
  }
}
