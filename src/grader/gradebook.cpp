#include <algorithm>
#include <cmath>
#include <limits>
#include <rigor/base/file.hpp>
#include <rigor/base/suggest.hpp>
#include <rigor/grader/class_run.hpp>

namespace rigor::grader {
namespace {

using Line = std::vector<std::string>;

// RFC 4180. nullopt where a quote is never closed.
std::optional<std::vector<Line>> parse_csv(const std::string& text) {
  std::vector<Line> lines{{""}};
  bool quoted = false;
  for (std::size_t i = text.rfind("\xef\xbb\xbf", 0) == 0 ? 3 : 0; i < text.size(); ++i) {
    std::string& cell = lines.back().back();
    const char c = text[i];
    if (quoted) {
      if (c != '"') cell += c;
      else if (i + 1 < text.size() && text[i + 1] == '"') cell += '"', ++i;
      else quoted = false;
    } else if (c == '"' && cell.empty()) {
      quoted = true;
    } else if (c == ',') {
      lines.back().emplace_back();
    } else if (c == '\n') {
      lines.push_back({""});
    } else if (c != '\r') {
      cell += c;
    }
  }
  if (quoted) return std::nullopt;
  if (lines.back() == Line{""}) lines.pop_back();
  return lines;
}
std::string write_csv(const std::vector<Line>& lines) {
  std::string out;
  for (const Line& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) {
      std::string cell = line[i];
      if (cell.find_first_of(",\"\n\r") != std::string::npos) {
        std::string doubled;
        for (const char c : cell) doubled += c == '"' ? std::string("\"\"") : std::string(1, c);
        cell = "\"" + doubled + "\"";
      }
      out += cell + (i + 1 < line.size() ? "," : "\n");
    }
  return out;
}
std::string points_text(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", x);
  return text;
}
std::string lower(std::string text) {
  for (char& c : text) c = char(std::tolower(static_cast<unsigned char>(c)));
  return text;
}
// Canvas files are named lastfirst_<id>: the id stands in the gradebook's column "ID".
bool names(const ClassRow& row, const std::string& cell) {
  if (cell.empty()) return false;
  const std::string student = lower(row.entry.student), asked = lower(cell);
  return student == asked || student.ends_with("_" + asked) || student.rfind(asked + "@", 0) == 0 || asked.rfind(student + "@", 0) == 0;
}
std::optional<std::size_t> column_named(const Line& header, const std::string& name) {
  for (std::size_t i = 0; i < header.size(); ++i)
    if (lower(header[i]) == lower(name)) return i;
  return std::nullopt;
}

}  // namespace

Outcome<Filled> fill_gradebook(const std::filesystem::path& gradebook, const std::string& column, const std::vector<ClassRow>& rows) {
  using Kind = Fault::Kind;
  const auto text = read_file(gradebook);
  if (!text) return text.fault();
  auto lines = parse_csv(*text);
  if (!lines || lines->empty()) return Fault{Kind::malformed, gradebook.string(), "is no CSV file (empty, or a quote is not closed)"};
  const Line header = lines->front();
  std::vector<std::size_t> keys;
  for (const char* key : {"ID", "SIS Login ID", "SIS User ID", "Email address", "Identifier", "Username", "Student"})
    if (const auto i = column_named(header, key)) keys.push_back(*i);
  std::size_t first = 1, target = 0;
  if (keys.empty() && header.front().find('@') != std::string::npos) {  // Autolab's form: e-mail, then the points
    keys = {0};
    first = 0;
    target = 1;
  } else if (keys.empty()) {
    return Fault{Kind::malformed, gradebook.string(), "has no column that names students (ID, SIS Login ID, Email address, Identifier, Username), and no e-mail first"};
  } else {
    const auto wanted = column_named(header, column.empty() ? "Grade" : column);
    if (!wanted) {
      std::string all;
      for (const std::string& name : header) all += (all.empty() ? "" : ", ") + name;
      return Fault{Kind::missing, gradebook.string(), "has no column '" + (column.empty() ? "Grade" : column) + "'" + did_you_mean(column, header) + "; columns: " + all};
    }
    target = *wanted;
  }
  Filled filled;
  for (std::size_t k = first; k < lines->size(); ++k) {
    Line& line = (*lines)[k];
    const ClassRow* who = nullptr;
    for (const std::size_t key : keys)
      for (const ClassRow& row : rows)
        if (who == nullptr && key < line.size() && row.trouble.empty() && names(row, line[key])) who = &row;
    if (who == nullptr) {
      ++filled.unmatched;
      continue;
    }
    if (line.size() <= target) line.resize(target + 1);
    line[target] = points_text(who->score);
    ++filled.filled;
  }
  filled.csv = write_csv(*lines);
  return filled;
}

std::vector<Change> changes(const std::vector<ClassRow>& before, const std::vector<ClassRow>& after) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<Change> list;
  for (const ClassRow& now : after)
    for (const ClassRow& then : before) {
      if (then.entry.student != now.entry.student) continue;
      Change change{now.entry.student, then.trouble.empty() ? then.score : none, now.trouble.empty() ? now.score : none, ""};
      std::string moved;
      for (const auto& [id, verdict] : now.verdicts) {
        const auto old = then.verdicts.find(id);
        const std::string was = old == then.verdicts.end() ? "absent" : old->second;
        const bool points = old != then.verdicts.end() && then.points.count(id) != 0 && now.points.count(id) != 0 && then.points.at(id) != now.points.at(id);
        if (was != verdict) moved += "; " + id + " " + was + " -> " + verdict;
        else if (points) moved += "; " + id + " " + points_text(then.points.at(id)) + " -> " + points_text(now.points.at(id)) + " points";
      }
      const bool same = (change.before == change.after || (std::isnan(change.before) && std::isnan(change.after))) && moved.empty();
      if (same) continue;
      if (!then.trouble.empty()) change.why += "; before: " + then.trouble;
      if (!now.trouble.empty()) change.why += "; now: " + now.trouble;
      if (then.trouble.empty() && now.trouble.empty()) {
        if (then.submission_hash != now.submission_hash) change.why += "; other files";
        if (then.tool != now.tool) change.why += "; tool " + then.tool + " -> " + now.tool;
        if (then.rubric_hash != now.rubric_hash) change.why += "; other rubric";
      }
      change.why = (change.why + moved).substr(2);
      list.push_back(change);
    }
  return list;
}

std::string changes_csv(const std::vector<Change>& list) {
  std::vector<Line> lines{{"student", "before", "after", "why"}};
  for (const Change& c : list) lines.push_back({c.student, std::isnan(c.before) ? "" : points_text(c.before), std::isnan(c.after) ? "" : points_text(c.after), c.why});
  return write_csv(lines);
}

}  // namespace rigor::grader
