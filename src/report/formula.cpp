#include <rigor/report/formula.hpp>
#include <rigor/report/html.hpp>
#include <rigor/report/texts.hpp>

namespace rigor::report {
namespace {

/// The line of `file` whose first field is `id`, without that field; "" where there is none.
std::string_view line_of(std::string_view file, std::string_view id) {
  for (std::size_t at = 0; at < file.size();) {
    const std::size_t end = std::min(file.find('\n', at), file.size());
    const std::string_view line = file.substr(at, end - at);
    if (line.size() > id.size() && line.substr(0, id.size()) == id && line[id.size()] == '\t') return line.substr(id.size() + 1);
    at = end + 1;
  }
  return {};
}

}  // namespace

std::string formula_text(std::string_view id) {
  for (const char* file : {"typeset.tsv", "problems.tsv"})
    if (const std::string_view line = line_of(text_named(file, texts()), id); !line.empty()) return std::string(line.substr(0, line.find('\t')));
  return "";
}

std::string formula_html(std::string_view id) {
  const std::string_view markup = line_of(text_named("formulas.mathml", texts()), id);
  if (!markup.empty()) return std::string(markup);
  const std::string plain = formula_text(id);
  return plain.empty() ? "" : "<code>" + escape(plain) + "</code>";
}

std::vector<std::string> formula_ids() {
  std::vector<std::string> ids;
  const std::string_view file = text_named("typeset.tsv", texts());
  for (std::size_t at = file.find('\n') + 1; at < file.size(); at = file.find('\n', at) + 1) ids.emplace_back(file.substr(at, file.find('\t', at) - at));
  return ids;
}

}  // namespace rigor::report
