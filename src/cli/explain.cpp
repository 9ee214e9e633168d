#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <regex>
#include <rigor/base/suggest.hpp>
#include <rigor/cli/explain.hpp>
#include <rigor/cli/terminal_width.hpp>
#include <rigor/grader/check.hpp>
#include <rigor/report/wrap.hpp>
#include <rigor/verify/verify.hpp>
#include <set>
#include <sstream>

namespace rigor::cli {
namespace {

bool starts(std::string_view text, std::string_view with) { return text.substr(0, with.size()) == with; }

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  std::istringstream in{std::string(text)};
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// "/// id        impulse.normal" -> "impulse.normal"
std::string id_in(const std::string& line) {
  static const std::regex pattern(R"(^\s*/// id\s+([a-z][a-z0-9_]*(\.[a-z0-9_]+)+)\s*$)");
  std::smatch match;
  return std::regex_match(line, match, pattern) ? match[1].str() : "";
}

// The block of /// lines around line `at`, without the marks, and the signature that follows it.
std::string docstring_around(const std::vector<std::string>& lines, std::size_t at) {
  const auto doc = [&](std::size_t i) { return starts(lines[i], "///"); };
  std::size_t first = at, last = at;
  while (first > 0 && doc(first - 1)) --first;
  while (last + 1 < lines.size() && doc(last + 1)) ++last;
  std::string text;
  for (std::size_t i = first; i <= last; ++i) text += (lines[i].size() > 4 ? lines[i].substr(4) : "") + "\n";
  text += "\n";
  for (std::size_t i = last + 1; i < lines.size() && !lines[i].empty(); ++i) {
    const std::size_t brace = lines[i].find(" {");
    text += "    " + lines[i].substr(0, brace) + "\n";
    if (brace != std::string::npos) break;
  }
  return text;
}

// The Markdown section whose heading contains `mark`, up to the next heading of the same or a higher level.
std::string section(std::string_view markdown, const std::string& mark) {
  std::string text;
  std::size_t level = 0;
  for (const std::string& line : lines_of(markdown)) {
    const std::size_t hashes = line.find_first_not_of('#');
    const bool heading = hashes != std::string::npos && hashes > 0 && line[hashes] == ' ';
    if (level != 0 && heading && hashes <= level) break;
    if (level == 0 && heading && line.find(mark) != std::string::npos) {
      level = hashes;
      continue;
    }
    if (level != 0) text += line + "\n";
  }
  return text;
}

// Coq statements under "(*@ TAG *)", up to "Proof."
std::vector<std::string> statements(std::string_view coq, const std::string& tag) {
  std::vector<std::string> found;
  bool inside = false;
  std::string text;
  for (const std::string& line : lines_of(coq)) {
    if (line.find("(*@ " + tag + " *)") != std::string::npos) {
      inside = true;
      text.clear();
      continue;
    }
    if (!inside) continue;
    if (starts(line, "Proof")) {
      found.push_back(text);
      inside = false;
    } else {
      text += line + "\n";
    }
  }
  return found;
}

// "// id: a.b, c.d" above a TEST names what it shows.
std::vector<std::string> tests_of(const Text& file, const std::string& id) {
  static const std::regex test(R"(^(?:TEST|TEST_F|RC_GTEST_PROP)\((\w+), *(\w+).*)");
  std::vector<std::string> found;
  bool tagged = false;
  for (const std::string& line : lines_of(file.content)) {
    if (starts(line, "// id:")) {
      std::istringstream words(line.substr(6));
      for (std::string word; words >> word;) {
        word.erase(std::remove(word.begin(), word.end(), ','), word.end());
        tagged = tagged || word == id;
      }
    }
    std::smatch match;
    if (std::regex_match(line, match, test)) {
      if (tagged) found.push_back(std::string(file.path) + ": " + match[1].str() + "." + match[2].str());
      tagged = false;
    }
  }
  return found;
}

void append(std::vector<std::string>& to, std::vector<std::string> more) {
  to.insert(to.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

using report::filled, report::folded;

constexpr std::size_t margin = 2;

using Layout = std::string (*)(const std::string&, std::size_t, std::size_t);

void print_block(const char* title, const std::string& body, Layout layout) {
  const std::size_t first = body.find_first_not_of(" \n"), last = body.find_last_not_of(" \n");
  if (first == std::string::npos) return;
  const std::size_t line = body.rfind('\n', first) + 1;  // npos + 1 is 0
  std::printf("\n%s\n%s", title, layout(body.substr(line, last + 1 - line), terminal_width(), margin).c_str());
}

// Measured now, on inputs of a fixed seed: what `rigor verify --id ID` prints.
std::vector<std::string> figures(const std::string& id) {
  const verify::Result measured = verify::run(id, 2000, 1);
  std::vector<std::string> lines;
  for (const auto& r : measured.identities) lines.push_back(fmt::format("identity holds with == for {} of {} rational inputs: {}", r.held, r.cases, r.says));
  for (const auto& r : measured.roundings) lines.push_back(fmt::format("worst rounding {:.3f} of {}, {} inputs", r.worst, r.bound, r.cases));
  for (const auto& r : measured.agreements)
    lines.push_back(fmt::format("differs by {:.1e} at most (allowed {:.1e}), {} inputs, from an oracle: {}", r.worst, r.bound, r.cases, r.oracle));
  for (const auto& r : measured.absent) lines.push_back("no " + r.part + ": " + r.why);
  return lines;
}

std::string listed(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += "- " + line + "\n";
  return text;
}

void print(const Explanation& e) {
  std::printf("%s   (%s)\n\n%s", e.id.c_str(), e.header.c_str(), filled(e.docstring, terminal_width(), margin).c_str());
  print_block("DERIVATION", e.derivation, filled);
  for (const std::string& erratum : e.errata) print_block("ERRATUM", erratum, filled);
  for (const std::string& theorem : e.theorems) print_block("THEOREM (Coq, proofs/coq)", theorem, folded);
  for (const std::string& bridge : e.bridges)
    print_block("BRIDGE (what the C++ computes is the theorem's formula)", bridge, folded);
  for (const std::string& bound : e.roundings)
    print_block("ROUNDING BOUND (proved for any rounding to nearest)", bound, folded);
  print_block("TESTS (those in tests/exact: rationals, ==)", listed(e.tests), filled);
  print_block("CHECKS (what rigor grade asks of a submission)", listed(e.checks), filled);
  print_block("FIGURES (measured now; more: rigor verify --id ID)", listed(figures(e.id)), filled);
}

// The first sentence of a docstring: what the list shows.
std::string headline(const std::string& docstring) {
  static const std::regex end(R"([.:]\s|\n\s*\n)");
  std::smatch match;
  std::string text = std::regex_search(docstring, match, end) ? match.prefix().str() : docstring;
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

void print_list(const std::vector<std::string>& ids, bool json) {
  nlohmann::json list = nlohmann::json::array();
  for (const std::string& id : ids) {
    const std::string says = headline(explain(texts(), id)->docstring);
    if (json) {
      list.push_back({{"id", id}, {"says", says}});
    } else {
      const std::string column = filled(says, terminal_width(), 31);
      std::printf("%s%s", id.c_str(), column.substr(std::min(id.size(), std::size_t(30))).c_str());
    }
  }
  if (json) std::printf("%s\n", list.dump(2).c_str());
  else std::printf("\n%zu formula%s; 'rigor explain ID' shows one\n", ids.size(), ids.size() == 1 ? "" : "s");
}

}  // namespace

std::vector<std::string> formula_ids(const std::vector<Text>& texts) {
  std::vector<std::string> ids;
  for (const Text& text : texts)
    if (starts(text.path, "src/formulas/"))
      for (const std::string& line : lines_of(text.content))
        if (const std::string id = id_in(line); !id.empty()) ids.push_back(id);
  std::sort(ids.begin(), ids.end());
  return ids;
}

std::optional<Explanation> explain(const std::vector<Text>& texts, const std::string& id) {
  Explanation e;
  e.id = id;
  for (const Text& text : texts) {
    if (starts(text.path, "src/formulas/")) {
      const std::vector<std::string> lines = lines_of(text.content);
      for (std::size_t i = 0; i < lines.size(); ++i)
        if (id_in(lines[i]) == id) {
          e.header = text.path;
          e.docstring = docstring_around(lines, i);
        }
    } else if (starts(text.path, "proofs/coq/")) {
      append(e.theorems, statements(text.content, id));
      append(e.bridges, statements(text.content, "bridge " + id));
      append(e.roundings, statements(text.content, "rounding " + id));
    } else if (starts(text.path, "proofs/")) {
      if (const std::string found = section(text.content, "`" + id + "`"); !found.empty())
        e.derivation = found;
    } else if (starts(text.path, "tests/exact/") || starts(text.path, "tests/property/")) {
      append(e.tests, tests_of(text, id));
    }
  }
  if (e.header.empty()) return std::nullopt;
  // errata that the docstring cites ("errata a and b" too), and those that name the formula; not the points to settle below them
  static const std::regex cited(R"((?:erratum|errata|and) ([a-z][a-z0-9-]*))"), heading(R"((?:^|\n)##+ `([a-z-]+)`)");
  std::set<std::string> names;
  for (auto m = std::sregex_iterator(e.docstring.begin(), e.docstring.end(), cited); m != std::sregex_iterator(); ++m) names.insert((*m)[1]);
  const auto errata = std::find_if(texts.begin(), texts.end(), [](const Text& text) { return text.path == "reference/errata.md"; });
  if (errata != texts.end()) {
    const std::string all(errata->content);
    for (auto m = std::sregex_iterator(all.begin(), all.end(), heading); m != std::sregex_iterator(); ++m) {
      const std::string found = section(all, "`" + (*m)[1].str() + "`");
      if (names.count((*m)[1]) != 0 || found.find("`" + id + "`") != std::string::npos) e.errata.push_back(found);
    }
  }
  for (const grader::Check& check : grader::checks())
    if (check.formula == id) e.checks.push_back(check.id + ": " + check.says);
  return e;
}

void add_explain(CLI::App& app, int& exit_status) {
  struct Options {
    std::string id;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("explain", "the derivation, errata, theorem, bridge, tests, checks and figures of one formula");
  command->add_option("ID", options->id, "formula id, for example impulse.normal; impulse lists the impulse.*; without it, all are listed");
  command->add_flag("--json", options->json, "as JSON");
  command->footer("Example:  rigor explain impulse.normal");
  command->callback([options, &exit_status] {
    const std::vector<std::string> ids = formula_ids(texts());
    std::vector<std::string> shown;  // all, or those of one family: "impulse" lists impulse.*
    for (const std::string& id : ids)
      if (options->id.empty() || starts(id, options->id + ".")) shown.push_back(id);
    if (!shown.empty()) return print_list(shown, options->json);
    const std::optional<Explanation> found = explain(texts(), options->id);
    if (!found) {
      if (const grader::Check* check = grader::find_check(options->id); check != nullptr) {
        std::fprintf(stderr, "rigor explain: '%s' is a check, its formula is '%s': rigor explain %s\n", options->id.c_str(), check->formula.c_str(), check->formula.c_str());
        exit_status = 2;
        return;
      }
      std::fprintf(stderr, "rigor explain: there is no formula '%s'%s; 'rigor explain' lists them\n",
                   options->id.c_str(), did_you_mean(options->id, ids).c_str());
      exit_status = 2;
      return;
    }
    if (!options->json) return print(*found);
    std::printf("%s\n", nlohmann::json{{"id", found->id},
                                       {"header", found->header},
                                       {"docstring", found->docstring},
                                       {"derivation", found->derivation},
                                       {"errata", found->errata},
                                       {"theorems", found->theorems},
                                       {"bridges", found->bridges},
                                       {"roundings", found->roundings},
                                       {"tests", found->tests},
                                       {"checks", found->checks},
                                       {"figures", figures(found->id)}}
                            .dump(2)
                            .c_str());
  });
}

}  // namespace rigor::cli
