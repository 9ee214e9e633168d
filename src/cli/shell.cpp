#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <rigor/base/suggest.hpp>
#include <rigor/cli/explain.hpp>
#include <rigor/cli/shell.hpp>
#include <rigor/cli/texts.hpp>
#include <rigor/grader/check.hpp>
#include <rigor/scene/method_names.hpp>
#include <rigor/scene/plan.hpp>
#include <rigor/scene/scene.hpp>
#include <rigor/studies/contact.hpp>
#include <rigor/studies/drift.hpp>
#include <rigor/studies/peer.hpp>
#include <rigor/studies/plan.hpp>
#include <rigor/studies/problem.hpp>
#include <rigor/studies/table.hpp>

namespace rigor::cli {
namespace {

using Words = std::vector<std::string>;

std::string joined(const Words& words, const std::string& between = " ") {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}
template <class Items, class Name>
Words names_of(const Items& items, const Name& name) {
  Words words;
  for (const auto& item : items) words.push_back(item.*name);
  return words;
}
std::string replaced(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size()) text.replace(at, what.size(), with);
  return text;
}

Words problems() {
  Words all = studies::problem_names();
  for (const auto& problem : studies::contact_problems()) all.push_back(problem.name);
  for (const auto& map : studies::maps()) all.push_back(map.name);
  return all;
}

// What an option or argument can be, where that is a list: what the help says in words.
Words values(const std::string& command, const std::string& option) {
  if (option == "SCENE") return builtin_scenes();
  if (option == "--method" || option == "--beside") return command == "run" ? scene_methods() : method_names();
  if (option == "--problem") return problems();
  if (option == "--peer") return names_of(studies::peers(), &studies::Peer::name);
  if (option == "--sums") return {"plain", "carried"};
  if (option == "--check") return names_of(grader::checks(), &grader::Check::id);
  if (option == "--table") return names_of(studies::frozen_tables(), &studies::FrozenTable::name);
  if (option == "--no-skip") {
    Words ids = names_of(plan({}, {}), &PlanLine::id);
    ids.push_back("all");
    return ids;
  }
  if (command == "study" && option == "KIND") return studies::study_kinds();
  if (command == "export" && option == "WHAT") return {"kit", "autolab", "gradescope"};
  if (command == "shell" && option == "KIND") return {"bash", "zsh", "man"};
  if (command == "grade" && option == "--format") return {"text", "json", "html", "junit", "gradescope", "autolab"};
  if (option == "--id" || (command == "explain" && option[0] != '-')) return formula_ids(texts());
  return {};
}

struct Entry {
  std::string name, description;
  std::string range, standard;  // "in [1, 24]"; what it is where it is not given; "" where the description says it
  bool takes_value, takes_list;  // a list: values with commas between them
};
// Options first, then what is given by place.
std::vector<Entry> entries(const CLI::App& command) {
  std::vector<Entry> all;
  for (const bool by_place : {false, true})
    for (const CLI::Option* option : command.get_options())
      if (option->get_positional() == by_place) {
        const std::string type = option->get_type_name();  // "INT:in [1, 24]"
        const std::size_t colon = type.find(':');
        all.push_back({option->get_name(false, false), option->get_description(), colon == std::string::npos ? "" : type.substr(colon + 1), option->get_default_str(),
                       option->get_items_expected_max() > 0, option->get_delimiter() != '\0'});
      }
  for (Entry& entry : all)  // "-h,--help" is --help
    if (const std::size_t comma = entry.name.rfind(','); comma != std::string::npos) entry.name = entry.name.substr(comma + 1);
  return all;
}
// The footer without the lists before it: they stand beside their options.
std::string example_of(const CLI::App& command) {
  const std::string footer = command.get_footer();
  const std::size_t at = footer.find("Example:");
  return at == std::string::npos ? footer : footer.substr(at);
}
bool is_option(const Entry& entry) { return entry.name[0] == '-'; }
std::vector<const CLI::App*> commands(const CLI::App& app) { return app.get_subcommands([](const CLI::App*) { return true; }); }

std::string quoted(const std::string& text) { return "'" + replaced(text, "'", "'\\''") + "'"; }
// Inside _arguments' '--name[description]:message:action'.
std::string zsh_text(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') safe += '\\';
    safe += c;
  }
  return safe;
}
std::string roff(const std::string& text) {
  const std::string safe = replaced(replaced(text, "\\", "\\e"), "-", "\\-");
  return safe.empty() || (safe[0] != '.' && safe[0] != '\'') ? safe : "\\&" + safe;
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
  Words names;
  std::string cases;
  for (const CLI::App* command : commands(app)) {
    Words options, by_place, files;
    std::string after;
    names.push_back(command->get_name());
    for (const Entry& entry : entries(*command)) {
      const Words of = values(command->get_name(), entry.name);
      if (!is_option(entry)) {
        by_place.insert(by_place.end(), of.begin(), of.end());
        continue;
      }
      options.push_back(entry.name);
      if (entry.takes_value && of.empty()) files.push_back(entry.name);
      else if (entry.takes_value) after += "        " + entry.name + ") words=" + quoted(joined(of)) + (entry.takes_list ? " list=yes" : "") + " ;;\n";
    }
    if (!files.empty()) after += "        " + joined(files, " | ") + ") words= ;;\n";
    cases += "    " + command->get_name() + ")\n      words=" + quoted(joined(by_place)) + "\n      [[ $word == -* ]] && words=" + quoted(joined(options)) + "\n";
    cases += after.empty() ? "" : "      case $before in\n" + after + "      esac\n";
    cases += "      ;;\n";
  }
  return "# bash completion for rigor: written by `rigor shell bash`, to source or to put into bash-completion's directory\n"
         "_rigor() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} words= list= given=\n"
         "  case ${COMP_WORDS[1]} in\n" + cases +
         "    help)\n      words=" + quoted(joined(names)) + "\n      ;;\n"
         "  esac\n"
         "  if ((COMP_CWORD == 1)); then words=" + quoted(joined(names) + " help --help --version") + "; fi\n"
         "  if [[ $list && $word == *,* ]]; then given=${word%,*},; fi\n"
         "  mapfile -t COMPREPLY < <(compgen -P \"$given\" -W \"$words\" -- \"${word#\"$given\"}\")\n"
         "}\n"
         "complete -o default -F _rigor rigor ./rigor\n";
}

std::string zsh_completion(const CLI::App& app) {
  std::string names, cases;
  for (const CLI::App* command : commands(app)) {
    names += "    " + quoted(command->get_name() + ":" + zsh_text(command->get_description())) + "\n";
    cases += "    " + command->get_name() + ") _arguments";
    for (const Entry& entry : entries(*command)) {
      const Words of = values(command->get_name(), entry.name);
      const std::string what = of.empty() ? "_files" : entry.takes_list ? "_values -s , value " + joined(of) : "(" + joined(of) + ")", message = zsh_text(entry.description);
      if (!is_option(entry)) cases += " \\\n      " + quoted("*:" + message + ":" + what);
      else if (entry.takes_value) cases += " \\\n      " + quoted("*" + entry.name + "[" + message + "]:value:" + what);
      else cases += " \\\n      " + quoted(entry.name + "[" + message + "]");
    }
    cases += " ;;\n";
  }
  cases += "    help) _describe -t commands command commands ;;\n";
  return "#compdef rigor\n# zsh completion for rigor: written by `rigor shell zsh`, to put as _rigor into a directory of fpath\n"
         "_rigor() {\n  local -a commands\n  commands=(\n" + names + "  )\n"
         "  if ((CURRENT == 2)); then\n    _describe -t commands command commands\n    return\n  fi\n"
         "  local command=$words[2]\n  shift words\n  ((CURRENT--))\n  case $command in\n" + cases + "  esac\n}\n"
         "if [[ $zsh_eval_context[-1] == loadautofunc ]]; then _rigor \"$@\"; else compdef _rigor rigor; fi\n";
}

std::string man_page(const CLI::App& app) {
  std::string page = ".TH RIGOR 1 \"\" \"rigor " RIGOR_VERSION "\" \"User Commands\"\n.SH NAME\nrigor \\- " + roff("rigid-body dynamics for cuboids, verified") +
                     "\n.SH SYNOPSIS\n.B rigor\n.I COMMAND\n.RI [ OPTIONS ]\n.SH DESCRIPTION\n" + roff(app.get_description()) + ".\n.SH COMMANDS\n";
  for (const CLI::App* command : commands(app)) {
    page += ".SS " + command->get_name() + "\n" + roff(command->get_description()) + "\n";
    for (const Entry& entry : entries(*command)) {
      page += ".TP\n" + std::string(is_option(entry) ? ".B " : ".I ") + roff(entry.name) + "\n" + roff(entry.description) + "\n";
      if (const Words of = values(command->get_name(), entry.name); !of.empty() && of.size() < 30 && entry.description.find(of[0]) == std::string::npos) page += ".br\n" + roff(joined(of, ", ")) + "\n";
      Words limits;
      if (!entry.range.empty()) limits.push_back(entry.range);
      if (!entry.standard.empty()) limits.push_back(entry.standard + " by default");
      if (!limits.empty()) page += ".br\n" + roff(joined(limits, "; ")) + "\n";
    }
    page += ".PP\n" + roff(example_of(*command)) + "\n";
  }
  return page + ".SH EXIT STATUS\n.TP\n0\ndone\n.TP\n1\na check of rigor itself did not hold, or a run stopped early\n.TP\n2\nbad input; one line says what and what to do\n"
                ".TP\n3\nthe machine or rigor failed\n.TP\n128 + N\nstopped by signal N\n";
}

void add_shell(CLI::App& app, int& exit_status) {
  auto kind = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("shell", "completion for bash and zsh, and the man page, on stdout");
  command->add_option("KIND", *kind, "bash, zsh or man")->required();
  command->footer("Example:  rigor shell bash > ~/.local/share/bash-completion/completions/rigor");
  command->callback([kind, &app, &exit_status] {
    const bool bash = *kind == "bash", zsh = *kind == "zsh";
    if (!bash && !zsh && *kind != "man") {
      std::fprintf(stderr, "rigor shell: there is no '%s'%s; there are bash, zsh, man\n", kind->c_str(), did_you_mean(*kind, {"bash", "zsh", "man"}).c_str());
      exit_status = 2;
      return;
    }
    std::fputs((bash ? bash_completion(app) : zsh ? zsh_completion(app) : man_page(app)).c_str(), stdout);
  });
}

}  // namespace rigor::cli
