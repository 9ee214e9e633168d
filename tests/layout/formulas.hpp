#pragma once
#include <regex>
#include <tests/layout/text.hpp>

namespace rigor::layout {

/// A public function (template or inline) of a formula header, with what its docstring says about ids.
struct Formula {
  std::string file, function, scalar;  ///< scalar: the concept of its first template parameter
  std::vector<std::string> ids;
  std::string no_id;  ///< the reason on a line `no id  reason`, or empty
};

/// Functions at namespace level (outside `namespace detail`); `text` is one header.
inline std::vector<Formula> formulas_in(const std::string& file, const std::string& text) {
  static const std::regex opening(R"(^template <(?:class|typename|(\w+)) \w+.*)"),
      inline_function(R"(^inline [^=]*\(.*)"),
      type(R"(^(struct|class|concept|using|inline constexpr|constexpr) .*)"), name(R"((\w+)\()"),
      id(R"(^/// id\s+(\S+)\s*$)"), no_id(R"(^/// no id\s+(\S.*)$)");
  const std::vector<std::string> lines = lines_of(text);
  std::vector<Formula> found;
  bool in_detail = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (starts(lines[i], "namespace detail")) in_detail = true;
    if (starts(lines[i], "}  // namespace detail")) in_detail = false;
    std::smatch match;
    const bool plain = std::regex_match(lines[i], inline_function);
    if (in_detail || !(plain || std::regex_match(lines[i], match, opening))) continue;
    Formula formula{file, "", plain ? "" : match[1].str(), {}, ""};
    std::size_t next = plain ? i : i + 1;
    while (next < lines.size() && starts(lines[next], "  requires")) ++next;
    if (next == lines.size() || std::regex_match(lines[next], type)) continue;
    if (!std::regex_search(lines[next], match, name)) continue;
    formula.function = match[1];
    for (std::size_t k = i; k-- > 0 && starts(lines[k], "///");) {
      if (std::regex_match(lines[k], match, id)) formula.ids.push_back(match[1]);
      if (std::regex_match(lines[k], match, no_id)) formula.no_id = match[1];
    }
    found.push_back(formula);
  }
  return found;
}

inline std::vector<Formula> all_formulas() {
  std::vector<Formula> all;
  for (const std::string& file : files_below("src/formulas", {".hpp"}))
    for (const Formula& formula : formulas_in(file, read(source / file))) all.push_back(formula);
  return all;
}

}  // namespace rigor::layout
