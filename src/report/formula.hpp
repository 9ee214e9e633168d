#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace rigor::report {

/// A formula of src/formulas/typeset.tsv or a law of src/studies/problems.tsv, as HTML: MathML with its TeX as annotation, or, in
/// a program that was built without node, its plain text. "" where there is none of that id.
std::string formula_html(std::string_view id);

/// The same as one line of plain text.
std::string formula_text(std::string_view id);

/// Every id of the former, in the order of the file.
std::vector<std::string> formula_ids();

}  // namespace rigor::report
