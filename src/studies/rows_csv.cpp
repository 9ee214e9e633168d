#include <algorithm>
#include <cmath>
#include <rigor/studies/cell.hpp>
#include <rigor/studies/contact.hpp>
#include <rigor/studies/drift.hpp>

namespace rigor::studies {
namespace {

std::string quoted(const std::string& text) {  // for CSV
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

std::string number(double x) { return std::isnan(x) ? "" : digits(x); }

// Whether the study sweeps x, or y; else what the cell has there is no value of anything.
bool has_x(const Cell& c) {
  if (c.study != "contact") return c.study == "drift" || (c.study == "stability" && find_map(c.problem) != nullptr);
  return std::any_of(contact_problems().begin(), contact_problems().end(), [&](const ContactProblem& p) { return p.name == c.problem && !p.x.empty(); });
}
bool has_y(const Cell& c) { return c.study == "stability" && find_map(c.problem) != nullptr; }

}  // namespace

std::string rows_csv(const std::vector<Row>& rows) {
  std::vector<std::string> columns;
  for (const Row& row : rows)
    for (const auto& [name, value] : row.values)
      if (std::find(columns.begin(), columns.end(), name) == columns.end()) columns.push_back(name);
  std::string out = "study,problem,method,steps,tolerance,until,x,y,compensated";
  for (const std::string& c : columns) out += "," + c;
  out += ",failed\n";
  for (const Row& row : rows) {
    const Cell& c = row.cell;
    out += c.study + "," + quoted(c.problem) + "," + quoted(c.method) + "," + (c.steps > 0 ? std::to_string(c.steps) : "") + "," + (c.tolerance > 0 ? digits(c.tolerance) : "") + "," +
           (c.until > 0 ? digits(c.until) : "") + "," + (has_x(c) ? digits(c.x) : "") + "," + (has_y(c) ? digits(c.y) : "") + "," +
           (c.study != "drift" ? "" : c.compensated ? "yes" : "no");
    for (const std::string& column : columns) out += "," + number(row.at(column));
    out += "," + quoted(row.failed) + "\n";
  }
  return out;
}

}  // namespace rigor::studies
