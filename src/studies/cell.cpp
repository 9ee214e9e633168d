#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <rigor/studies/cell.hpp>

namespace rigor::studies {
namespace {
using Json = nlohmann::ordered_json;
}  // namespace

std::string digits(double x) {
  if (std::isnan(x)) return "nan";  // without a sign
  char text[40];
  return std::string(text, std::to_chars(text, text + sizeof text, x).ptr);
}
std::string brief(double x, const char* format) {
  if (std::isnan(x)) return "-";
  if (x == 0) return "0";
  char text[48];
  std::snprintf(text, sizeof text, format, x);
  return text;
}

std::string Cell::text() const {
  std::string out = "study=" + study + " problem=" + problem + " method=" + method + " steps=" + std::to_string(steps) + " tolerance=" + digits(tolerance) +
                    " until=" + digits(until) + " x=" + digits(x) + " y=" + digits(y);
  return out + (compensated ? " compensated" : "") + (content.empty() ? "" : " content=" + content);
}
std::string Cell::file() const {
  std::uint64_t hash = 14695981039346656037u;  // FNV-1a
  for (const unsigned char c : text()) hash = (hash ^ c) * 1099511628211u;
  std::string name = problem.substr(problem.find_last_of('/') + 1) + "-" + method.substr(0, 40) + "-";
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '.') c = '-';
  char tail[20];
  std::snprintf(tail, sizeof tail, "%016llx", static_cast<unsigned long long>(hash));
  return name + tail + ".json";
}

void Row::put(const std::string& name, double value) { values.emplace_back(name, std::isfinite(value) ? value : NAN); }
double Row::at(const std::string& name) const {
  for (const auto& [key, value] : values)
    if (key == name) return value;
  return std::numeric_limits<double>::quiet_NaN();
}

std::string row_json(const Row& row) {
  Json values = Json::object();
  for (const auto& [name, value] : row.values) values[name] = value;  // NaN: null
  return Json{{"schema", "rigor.cell/1"}, {"cell", row.cell.text()}, {"values", values}, {"failed", row.failed}, {"note", row.note}}.dump(1) + "\n";
}
std::optional<Row> row_from_json(const std::string& text, const Cell& cell) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  const auto word = [&](const char* key) { return json.contains(key) && json[key].is_string() ? json[key].get<std::string>() : ""; };
  if (word("schema") != "rigor.cell/1" || word("cell") != cell.text() || !json.contains("values")) return std::nullopt;
  Row row{cell, {}, word("failed"), word("note")};
  for (const auto& [name, value] : json["values"].items()) {
    if (!value.is_number() && !value.is_null()) return std::nullopt;
    row.put(name, value.is_null() ? NAN : value.get<double>());
  }
  return row;
}

}  // namespace rigor::studies
