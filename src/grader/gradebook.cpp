#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <rigor/base/file.hpp>
#include <rigor/base/suggest.hpp>
#include <rigor/grader/class_run.hpp>
#include <rigor/grader/printable.hpp>

namespace rigor::grader {
namespace {

using Line = std::vector<std::string>;

/// A CSV file that is written back as it was: where each cell stands in it.
struct Csv {
  struct Place {
    std::size_t begin, end;  ///< with its quotes
  };
  std::string text;
  std::vector<Line> lines;
  std::vector<std::vector<Place>> places;
};

// RFC 4180, lines ending in any system's way. nullopt where a quote is never closed.
std::optional<Csv> parse_csv(const std::string& text) {
  Csv csv{text, {}, {}};
  std::size_t i = text.rfind("\xef\xbb\xbf", 0) == 0 ? 3 : 0;
  for (bool fresh = true; i < text.size();) {
    if (fresh) csv.lines.emplace_back(), csv.places.emplace_back();
    const std::size_t begin = i;
    std::string cell;
    bool quoted = text[i] == '"';
    if (quoted) ++i;
    for (; i < text.size() && (quoted || (text[i] != ',' && text[i] != '\n' && text[i] != '\r')); ++i) {
      if (!quoted || text[i] != '"') cell += text[i];
      else if (i + 1 < text.size() && text[i + 1] == '"') cell += text[i++];
      else quoted = false;
    }
    if (quoted) return std::nullopt;
    csv.lines.back().push_back(cell);
    csv.places.back().push_back({begin, i});
    fresh = i >= text.size() || text[i] != ',';
    if (text.compare(i, 2, "\r\n") == 0) ++i;
    if (i < text.size()) ++i;
    if (!fresh && i == text.size()) csv.lines.back().emplace_back(), csv.places.back().push_back({i, i});
  }
  return csv;
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
std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}
std::optional<double> number(const std::string& text) {
  const std::string t = trimmed(text);
  char* end = nullptr;
  const double x = std::strtod(t.c_str(), &end);
  return t.empty() || *end != '\0' ? std::nullopt : std::optional(x);
}
std::optional<std::size_t> column_named(const Line& header, const std::string& name) {
  for (std::size_t i = 0; i < header.size(); ++i)
    if (lower(trimmed(header[i])) == lower(name)) return i;
  return std::nullopt;
}

// What a column says of a student.
enum class Says { email, school_id, canvas_id, participant, full_name, sortable_name };
struct KeyColumn {
  const char* header;
  Says says;
};
constexpr KeyColumn key_columns[] = {{"Email", Says::email},           {"Email address", Says::email},     {"SIS Login ID", Says::email},      {"Username", Says::email},
                                     {"SIS User ID", Says::school_id}, {"Student ID", Says::school_id},    {"SID", Says::school_id},           {"ID number", Says::school_id},
                                     {"ID", Says::canvas_id},          {"Identifier", Says::participant},  {"Full name", Says::full_name},     {"Student", Says::sortable_name}};

bool equal(const std::string& a, const std::string& b) { return !trimmed(a).empty() && lower(trimmed(a)) == lower(trimmed(b)); }
// "Participant 987", in whatever language.
std::string digits_at_end(const std::string& text) { return text.substr(text.find_last_not_of("0123456789") + 1); }
// Letters and digits alone: what Moodle leaves of a name in the name of a folder.
std::string bare(const std::string& name) {
  std::string out;
  for (const char c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80) out += char(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

/// Which rows of a gradebook are whose.
class Gradebook {
 public:
  Gradebook(Csv csv, std::vector<std::pair<std::size_t, Says>> keys, std::size_t first, std::size_t target)
      : csv_(std::move(csv)), keys_(std::move(keys)), first_(first), target_(target) {}

  Filled fill(const std::vector<ClassRow>& rows) {
    Filled filled;
    struct Claim {
      const ClassRow* row;
      std::string who;
    };
    std::map<std::size_t, std::vector<Claim>> claims;
    for (const ClassRow& row : rows)
      for (const Person& person : row.entry.people.empty() ? std::vector<Person>{{.name = row.entry.student}} : row.entry.people) {
        const std::string who = printable(row.entry.people.size() > 1 ? row.entry.student + ": " + (person.name.empty() ? person.email : person.name) : row.entry.student);
        const auto found = rows_of(person, row.entry.people.empty());
        if (found.size() == 1) claims[found.front()].push_back({&row, who});
        else if (found.empty()) filled.remarks.push_back(who + ": " + result(row) + "; no row of the gradebook is this student's");
        else filled.remarks.push_back(who + ": " + result(row) + "; not filled in, several rows fit: " + title(found[0]) + " and " + title(found[1]));
      }
    std::map<std::size_t, std::string> points;  // by line
    for (std::size_t k = first_; k < csv_.lines.size(); ++k) {
      if (!is_student(k)) {
        possible(k, rows, filled);
        continue;
      }
      ++filled.rows;
      const std::string was = target_ < csv_.lines[k].size() ? trimmed(csv_.lines[k][target_]) : "", kept = was.empty() ? "stays empty" : "keeps " + was;
      const auto at = claims.find(k);
      if (at == claims.end()) {
        filled.remarks.push_back(title(k) + ": not filled in, nobody's submission; " + kept);
      } else if (at->second.size() > 1) {
        filled.remarks.push_back(title(k) + ": not filled in, " + at->second[0].who + " and " + at->second[1].who + " both fit; " + kept);
      } else if (const Claim& claim = at->second.front(); !claim.row->trouble.empty()) {
        filled.remarks.push_back(title(k) + ": not filled in, could not be graded (" + claim.who + "); " + kept);
      } else {
        const auto before = number(was);
        if (!was.empty() && (!before || *before != claim.row->score)) filled.remarks.push_back(title(k) + ": " + was + " overwritten with " + points_text(claim.row->score));
        if (!before || *before != claim.row->score) points[k] = points_text(claim.row->score);
        ++filled.filled;
      }
    }
    maximum_grade(rows, filled);
    filled.csv = with(points);
    return filled;
  }

 private:
  /// The file with new cells in the column of points; whatever else is in it stays, byte for byte.
  std::string with(const std::map<std::size_t, std::string>& points) const {
    std::string out;
    std::size_t done = 0;
    for (const auto& [k, cell] : points) {
      const auto& places = csv_.places[k];
      const bool there = target_ < places.size();
      const std::size_t begin = there ? places[target_].begin : places.back().end;
      out += csv_.text.substr(done, begin - done) + (there ? "" : std::string(target_ + 1 - places.size(), ',')) + cell;
      done = there ? places[target_].end : begin;
    }
    return out + csv_.text.substr(done);
  }
  const std::string& at(std::size_t line, std::size_t column) const {
    static const std::string none;
    return column < csv_.lines[line].size() ? csv_.lines[line][column] : none;
  }
  static std::string result(const ClassRow& row) { return row.trouble.empty() ? points_text(row.score) + " points" : "could not be graded"; }
  bool is_student(std::size_t k) const {
    if (lower(trimmed(at(k, 0))) == "points possible") return false;
    return std::any_of(keys_.begin(), keys_.end(), [&](const auto& key) { return !trimmed(at(k, key.first)).empty(); });
  }
  /// "Lovelace, Ada (77)"
  std::string title(std::size_t k) const {
    std::string name, id;
    for (const auto& [column, says] : keys_) {
      const std::string text = trimmed(at(k, column));
      std::string& part = says == Says::full_name || says == Says::sortable_name ? name : id;
      if (part.empty()) part = text;
    }
    return printable(name.empty() ? id : id.empty() ? name : name + " (" + id + ")");
  }
  std::string full_name(std::size_t k) const {
    for (const auto& [column, says] : keys_)
      if (says == Says::full_name) return at(k, column);
    return "";
  }
  std::vector<std::size_t> rows_of(const Person& person, bool only_a_name) const {
    std::vector<std::size_t> found;
    for (std::size_t k = first_; k < csv_.lines.size(); ++k)
      if (is_student(k) && std::any_of(keys_.begin(), keys_.end(), [&](const auto& key) { return fits(person, only_a_name, k, key.first, key.second); })) found.push_back(k);
    if (!found.empty() || person.participant.empty()) return found;
    for (std::size_t k = first_; k < csv_.lines.size(); ++k)
      if (is_student(k) && equal(full_name(k), person.name)) found.push_back(k);
    return found;
  }
  bool fits(const Person& person, bool only_a_name, std::size_t k, std::size_t column, Says says) const {
    const std::string& cell = at(k, column);
    if (only_a_name) return equal(cell, person.name);
    switch (says) {
      case Says::email: return equal(cell, person.email);
      case Says::school_id: return equal(cell, person.school_id);
      case Says::canvas_id: return equal(cell, person.canvas_id);
      case Says::participant:  // numbers belong to one assignment: of another's worksheet they are somebody else's
        return equal(digits_at_end(trimmed(cell)), person.participant) && (bare(full_name(k)).empty() || bare(full_name(k)) == bare(person.name));
      default: return false;
    }
  }
  static std::optional<double> rubric_maximum(const std::vector<ClassRow>& rows) {
    for (const ClassRow& row : rows)
      if (row.trouble.empty()) return row.max_score;
    return std::nullopt;
  }
  void possible(std::size_t k, const std::vector<ClassRow>& rows, Filled& filled) const {
    const auto here = number(at(k, target_)), ours = rubric_maximum(rows);
    if (here && ours && *here != *ours)
      filled.remarks.push_back("the gradebook's points possible are " + trimmed(at(k, target_)) + ", the rubric's " + points_text(*ours) + ": the points are filled in as they are");
  }
  void maximum_grade(const std::vector<ClassRow>& rows, Filled& filled) const {
    const auto ours = rubric_maximum(rows);
    const auto column = column_named(csv_.lines.front(), "Maximum Grade");
    if (!column || !ours) return;
    for (std::size_t k = first_; k < csv_.lines.size(); ++k)
      if (const auto here = number(at(k, *column)); here && *here != *ours) {
        filled.remarks.push_back("the gradebook's maximum grade is " + trimmed(at(k, *column)) + ", the rubric's " + points_text(*ours) + ": the points are filled in as they are");
        return;
      }
  }

  Csv csv_;
  std::vector<std::pair<std::size_t, Says>> keys_;
  std::size_t first_, target_;
};

}  // namespace

Outcome<Filled> fill_gradebook(const std::filesystem::path& gradebook, const std::string& column, const std::vector<ClassRow>& rows) {
  using Kind = Fault::Kind;
  const auto text = read_file(gradebook);
  if (!text) return text.fault();
  const auto csv = parse_csv(*text);
  if (!csv || csv->lines.empty()) return Fault{Kind::malformed, gradebook.string(), "is no CSV file (empty, or a quote is not closed)"};
  const Line header = csv->lines.front();
  std::vector<std::pair<std::size_t, Says>> keys;
  for (const KeyColumn& key : key_columns)
    if (const auto i = column_named(header, key.header)) keys.push_back({*i, key.says});
  if (keys.empty() && header.front().find('@') != std::string::npos) {  // Autolab's form: e-mail, then the points
    if (!column.empty()) return Fault{Kind::malformed, gradebook.string(), "has no header to find the column '" + column + "' in; without --column the points go to the second"};
    return Gradebook(*csv, {{0, Says::email}}, 0, 1).fill(rows);
  }
  if (keys.empty())
    return Fault{Kind::malformed, gradebook.string(), "has no column that names students (ID, SIS Login ID, Email address, Identifier, Username), and no e-mail first"};
  const auto wanted = column_named(header, column.empty() ? "Grade" : column);
  if (!wanted) {
    std::string all;
    for (const std::string& name : header) all += (all.empty() ? "" : ", ") + printable(name);
    return Fault{Kind::missing, gradebook.string(), "has no column '" + (column.empty() ? "Grade" : column) + "'" + did_you_mean(column, header) + "; columns: " + all};
  }
  return Gradebook(*csv, keys, 1, *wanted).fill(rows);
}

std::vector<Change> changes(const std::vector<ClassRow>& before, const std::vector<ClassRow>& after) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<Change> list;
  const auto grade_of = [&](const ClassRow& row) { return row.trouble.empty() ? row.score : none; };
  std::map<std::string, const ClassRow*> earlier;
  for (const ClassRow& then : before) earlier[then.entry.student] = &then;
  for (const ClassRow& now : after) {
    const auto found = earlier.find(now.entry.student);
    if (found == earlier.end()) {
      if (now.trouble.empty()) list.push_back({now.entry.student, none, now.score, "new: no report in the earlier run"});
      continue;
    }
    const ClassRow& then = *found->second;
    earlier.erase(found);
    Change change{now.entry.student, grade_of(then), grade_of(now), ""};
    std::string moved;
    for (const auto& [id, verdict] : now.verdicts) {
      const auto old = then.verdicts.find(id);
      const std::string was = old == then.verdicts.end() ? "absent" : old->second;
      const bool points = old != then.verdicts.end() && then.points.count(id) != 0 && now.points.count(id) != 0 && then.points.at(id) != now.points.at(id);
      if (was != verdict) moved += "; " + id + " " + was + " -> " + verdict;
      else if (points) moved += "; " + id + " " + points_text(then.points.at(id)) + " -> " + points_text(now.points.at(id)) + " points";
    }
    if (change.before == change.after && moved.empty()) continue;
    if (!now.trouble.empty()) change.why += "; now: " + now.trouble;
    else {
      if (then.submission_hash != now.submission_hash) change.why += "; other files";
      if (then.tool != now.tool) change.why += "; tool " + then.tool + " -> " + now.tool;
      if (then.rubric_hash != now.rubric_hash) change.why += "; other rubric";
    }
    change.why += moved;
    if (!change.why.empty()) change.why = change.why.substr(2);
    list.push_back(change);
  }
  for (const auto& [student, then] : earlier) list.push_back({student, grade_of(*then), none, "gone: graded in the earlier run, no submission now"});
  return list;
}

std::string changes_csv(const std::vector<Change>& list) {
  std::vector<Line> lines{{"student", "before", "after", "why"}};
  for (const Change& c : list) lines.push_back({c.student, std::isnan(c.before) ? "" : points_text(c.before), std::isnan(c.after) ? "" : points_text(c.after), c.why});
  return write_csv(lines);
}

}  // namespace rigor::grader
