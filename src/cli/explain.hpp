#pragma once
#include <optional>
#include <rigor/cli/texts.hpp>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace rigor::cli {

/// What is known of one formula, collected from the texts by its id.
struct Explanation {
  std::string id;
  std::string header;                 ///< "src/formulas/normal_impulse.hpp"
  std::string docstring;              ///< without the /// marks
  std::string derivation;             ///< the section of proofs/*.md under its heading, Markdown
  std::vector<std::string> errata;    ///< sections of reference/errata.md that the docstring cites or that name the id
  std::vector<std::string> theorems;  ///< Coq statements tagged with the id
  std::vector<std::string> bridges;   ///< statements that tie the C++ to the theorem
  std::vector<std::string> roundings; ///< statements that bound its rounding
  std::vector<std::string> tests;     ///< "tests/exact/impulse_test.cpp: ImpulseNormal.SeparatesAtETimes..."
  std::vector<std::string> checks;    ///< "plane.impulse: ...", the grader's that are about it
};

/// Every id in the headers of src/formulas, in file order.
std::vector<std::string> formula_ids(const std::vector<Text>& texts);
std::optional<Explanation> explain(const std::vector<Text>& texts, const std::string& id);

/// `rigor explain [ID]`
void add_explain(CLI::App& app, int& exit_status);

}  // namespace rigor::cli
