#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <rigor/base/suggest.hpp>
#include <rigor/studies/cell.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/studies/table.hpp>
#include <set>
#include <sstream>
#include <string_view>

namespace rigor::studies {
namespace {

using V = Vec3<double>;

// Splits a CSV without quotes, which is all these tables need; spaces around cells are dropped.
std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> out{""};
  for (const char c : line) {
    if (c == ',') out.emplace_back();
    else if (c != '\r' && c != ' ' && c != '"') out.back() += c;
  }
  return out;
}
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";  // of UTF-8, as spreadsheets write it
struct Parsed {
  std::vector<std::string> header;
  std::vector<std::pair<int, std::vector<std::string>>> lines;  // line number, cells
};
Parsed parse(const std::string& text) {
  Parsed parsed;
  std::istringstream in(text.starts_with(byte_order_mark) ? text.substr(byte_order_mark.size()) : text);
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.empty() || line == "\r" || line.front() == '#') continue;
    if (parsed.header.empty()) parsed.header = cells(line);
    else parsed.lines.push_back({number, cells(line)});
  }
  return parsed;
}
int column(const std::vector<std::string>& header, const std::string& name) {
  for (std::size_t i = 0; i < header.size(); ++i)
    if (header[i] == name) return int(i);
  return -1;
}
double number(const std::string& text, bool& good) {
  double x = 0;
  const auto end = std::from_chars(text.data() + (text.rfind('+', 0) == 0), text.data() + text.size(), x);
  good = end.ec == std::errc() && end.ptr == text.data() + text.size();
  return x;
}

}  // namespace

std::string table_json(const std::string& name, const std::string& csv) {
  nlohmann::ordered_json json{{"schema", "rigor." + name + "-table/1"}, {"command", "rigor check-table --write DIR"}, {"provenance", nlohmann::ordered_json::array()}, {"cases", nlohmann::ordered_json::array()}};
  std::istringstream in(csv);
  for (std::string line; std::getline(in, line);)
    if (line.rfind("# ", 0) == 0) json["provenance"].push_back(line.substr(2));
  const Parsed parsed = parse(csv);
  for (const auto& [line, c] : parsed.lines) {
    nlohmann::ordered_json row;
    for (std::size_t i = 0; i < c.size(); ++i) row[parsed.header[i]] = c[i];
    json["cases"].push_back(row);
  }
  return json.dump(1) + "\n";
}

Outcome<std::vector<TableRow>> check_table(const std::string& table, const std::string& theirs, const std::string& name) {
  using Kind = Fault::Kind;
  const Parsed reference = parse(table), answers = parse(theirs);
  if (theirs.starts_with("\xFF\xFE") || theirs.starts_with("\xFE\xFF")) return Fault{Kind::malformed, name, "is UTF-16, must be UTF-8"};
  if (answers.header.empty()) return Fault{Kind::malformed, name, "is empty, must be a CSV with a header"};
  if (answers.header.size() == 1)
    for (const auto& [separator, word] : {std::pair{';', "';'"}, {'\t', "tabs"}})
      if (answers.header[0].find(separator) != std::string::npos) return Fault{Kind::malformed, name, fmt::format("has its columns separated by {}, must have ',' (and '.' in numbers)", word)};
  std::vector<std::string> needed{"case", "qw", "qx", "qy", "qz", "wx", "wy", "wz"};
  const bool event = column(reference.header, "time") >= 0;
  if (event) needed.insert(needed.end(), {"time", "vx", "vy", "vz"});
  std::vector<int> at, frozen_at;
  for (const std::string& c : needed) {
    at.push_back(column(answers.header, c));
    frozen_at.push_back(column(reference.header, c));
    if (at.back() < 0) return Fault{Kind::missing, name, fmt::format("has no column '{}'; needed: {}", c, fmt::join(needed, ", "))};
  }
  struct Want {
    std::string stratum;
    std::vector<double> x;  // by `needed`, without the case
  };
  std::map<std::string, Want> wanted;
  std::vector<TableRow> rows;
  bool good = true;
  for (const auto& [line, c] : reference.lines) {
    Want want{c[1], {}};
    for (std::size_t i = 1; i < needed.size(); ++i) want.x.push_back(number(c[std::size_t(frozen_at[i])], good));
    wanted[c[0]] = want;
    if (rows.empty() || rows.back().stratum != c[1]) {
      rows.push_back({});
      rows.back().stratum = c[1];
      rows.back().event = event;
    }
    ++rows.back().of;
  }
  std::vector<std::string> known;
  for (const auto& [id, want] : wanted) known.push_back(id);
  std::set<std::string> seen;
  for (const auto& [line, c] : answers.lines) {
    const std::string where = name + ":" + std::to_string(line);
    if (c.size() < answers.header.size()) return Fault{Kind::malformed, where, "has " + std::to_string(c.size()) + " cells, the header has " + std::to_string(answers.header.size())};
    const std::string id = c[std::size_t(at[0])];
    const auto want = wanted.find(id);
    if (want == wanted.end()) return Fault{Kind::unknown_key, where, "there is no case '" + id + "'" + did_you_mean(id, known)};
    if (!seen.insert(id).second) return Fault{Kind::unknown_key, where, "case '" + id + "' is there twice"};
    std::vector<double> x;
    for (std::size_t i = 1; i < needed.size(); ++i) {
      const std::string& cell = c[std::size_t(at[i])];
      x.push_back(number(cell, good));
      if (!good) return Fault{Kind::wrong_type, where + ", " + needed[i], "is '" + cell.substr(0, 40) + "', must be a number"};
      if (!std::isfinite(x.back())) return Fault{Kind::not_finite, where + ", " + needed[i], "is not finite"};
    }
    const auto quaternion = [](const std::vector<double>& y) { return Vec4<double>(y[0], y[1], y[2], y[3]); };
    const auto vector = [](const std::vector<double>& y, std::size_t from) { return V(y[from], y[from + 1], y[from + 2]); };
    const auto relative = [](const V& got, const V& wants) { return norm<double>(V(got - wants)) / norm<double>(wants); };
    const Vec4<double> q = quaternion(x);
    const std::vector<double>& frozen = want->second.x;
    if (std::fabs(q.norm() - 1) > 1e-3) return Fault{Kind::not_unit, where, "the quaternion has length " + digits(q.norm()) + ", must be 1 within 1e-3"};
    const double attitude = angle_between<double>(rotation_of<double>(q), rotation_of<double>(quaternion(frozen)));
    for (TableRow& row : rows) {
      if (row.stratum != want->second.stratum) continue;
      ++row.answered;
      if (attitude >= row.attitude) row.attitude = attitude, row.worst = id;
      row.spin = std::fmax(row.spin, relative(vector(x, 4), vector(frozen, 4)));
      if (!event) continue;
      row.time = std::fmax(row.time, std::fabs(x[7] / frozen[7] - 1));
      row.velocity = std::fmax(row.velocity, relative(vector(x, 8), vector(frozen, 8)));
    }
  }
  if (seen.empty()) return Fault{Kind::missing, name, "answers no case of the table"};
  return rows;
}

std::string table_text(const std::vector<TableRow>& rows) {
  const bool event = !rows.empty() && rows[0].event;
  std::string out = event ? "stratum       answered  angle, rad rel. spin rel. time rel. vel.  at\n" : "stratum       answered   worst attitude, rad   worst spin, relative   at\n";
  for (const TableRow& r : rows) {
    std::string line = fmt::format("{:<12}  {:3} of {:<3}", r.stratum, r.answered, r.of);
    if (r.answered > 0 && event) line += fmt::format("{:10.2e} {:9.2e} {:9.2e} {:9.2e}  {}", r.attitude, r.spin, r.time, r.velocity, r.worst);
    if (r.answered > 0 && !event) line += fmt::format(" {:15.2e} {:22.2e}   {}", r.attitude, r.spin, r.worst);
    while (line.back() == ' ') line.pop_back();
    out += line + "\n";
  }
  return out;
}

TableVerdict verdict_of(const std::vector<TableRow>& rows) {
  TableVerdict verdict;
  for (const TableRow& r : rows) {
    verdict.answered += r.answered, verdict.cases += r.of;
    for (const auto& [name, error] : {std::pair{"attitude", r.attitude}, {"spin", r.spin}, {"time", r.time}, {"velocity", r.velocity}})
      if (r.answered > 0 && (verdict.of.empty() || error > verdict.worst)) verdict.worst = error, verdict.of = name + (", " + r.stratum);
  }
  return verdict;
}
std::string verdict_text(const TableVerdict& v) { return fmt::format("worst {:.2e} ({}), {} of {} cases answered", v.worst, v.of, v.answered, v.cases); }

}  // namespace rigor::studies
