#include <algorithm>
#include <cmath>
#include <rigor/base/file.hpp>
#include <rigor/grader/class_run.hpp>
#include <rigor/grader/misconceptions.hpp>
#include <rigor/report/html.hpp>
#include <rigor/report/plot.hpp>
#include <set>

namespace rigor::grader {
namespace {

using report::escape;

std::string brief(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return text;
}
// RFC 4180; a cell that a spreadsheet would take for a formula is made a text.
std::string cell(std::string text) {
  if (!text.empty() && std::string("=+-@\t\r").find(text.front()) != std::string::npos) text = "'" + text;
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}
std::vector<std::string> failed_checks(const ClassRow& row) {
  std::vector<std::string> ids;
  for (const auto& [id, verdict] : row.verdicts)
    if (verdict != "pass" && find_check(id) != nullptr && find_check(id)->points > 0) ids.push_back(id);
  return ids;
}
bool written(const ClassRow& row, const std::string& id) { return row.verdicts.at(id) != name(Verdict::not_implemented); }
// The failed checks in a cell: of functions that were written, the first few by name; matrix.csv has them all.
std::string failed_text(const ClassRow& row) {
  const auto failed = failed_checks(row);
  constexpr std::size_t shown = 8;
  std::vector<std::string> ids;
  std::set<std::string> unwritten;
  for (const std::string& id : failed)
    if (written(row, id)) ids.push_back(id);
    else {
      const std::string function = student_function_name(find_check(id)->function);  // "Cuboid::update"
      unwritten.insert(function.substr(function.rfind(':') + 1));
    }
  const bool nothing = !failed.empty() && ids.empty() && std::none_of(row.verdicts.begin(), row.verdicts.end(), [](const auto& v) {
    return v.second == name(Verdict::pass) && find_check(v.first) != nullptr && find_check(v.first)->points > 0;
  });
  if (nothing) return "nothing written";
  const auto with_points = std::count_if(checks().begin(), checks().end(), [](const Check& check) { return check.points > 0; });
  if (long(ids.size()) == with_points) return "all " + std::to_string(with_points);
  std::string text;
  for (std::size_t k = 0; k < std::min(shown, ids.size()); ++k) text += (k == 0 ? "" : ", ") + ids[k];
  if (ids.size() > shown) text += " and " + std::to_string(ids.size() - shown) + " more";
  std::string functions;
  for (const std::string& function : unwritten) functions += (functions.empty() ? "" : ", ") + function;
  return text + (functions.empty() ? "" : (text.empty() ? "" : "; ") + ("not written: " + functions));
}
template <class Map>
std::vector<std::pair<std::string, int>> most_frequent(const Map& counts) {
  std::vector<std::pair<std::string, int>> list(counts.begin(), counts.end());
  std::stable_sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  return list;
}

// Everybody who gets the points of a submission.
std::vector<Person> people_of(const ClassRow& row) { return row.entry.people.empty() ? std::vector<Person>(1) : row.entry.people; }
// In a group each under the own name.
std::string shown_name(const ClassRow& row, const Person& person) {
  return row.entry.people.size() < 2 ? row.entry.student : person.name.empty() ? person.email : person.name;
}

// The directory of the report in a URL: its % is no code there.
std::string link_to(const ClassRow& row) {
  std::string url;
  for (const char c : safe_name(row.entry.student)) url += c == '%' ? std::string("%25") : std::string(1, c);
  return url;
}

std::string histogram(const std::vector<ClassRow>& rows) {
  report::Bars bars{"Scores of the class", "percent of the points", "students", {}, std::vector<double>(11, 0)};
  for (int k = 0; k < 10; ++k) bars.labels.push_back(std::to_string(10 * k) + "-" + std::to_string(10 * k + 9));
  bars.labels.push_back("100");
  for (const ClassRow& r : rows)
    if (r.trouble.empty() && r.max_score > 0) ++bars.values[std::size_t(std::clamp(int(std::floor(10 * r.score / r.max_score)), 0, 10))];
  return report::figure(bars);
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}
// Students who failed the same checks, and which of them with the same numbers to the last digit.
std::string same_failures(const std::vector<ClassRow>& rows) {
  std::map<std::string, std::map<std::string, std::vector<std::string>>> groups;  // failed checks, then numbers
  std::map<std::string, std::string> said;
  for (const ClassRow& r : rows)
    if (!r.fingerprint.empty()) {
      groups[listed(failed_checks(r))][r.fingerprint].push_back(r.entry.student);
      said[listed(failed_checks(r))] = failed_text(r);
    }
  std::vector<std::vector<std::string>> table;
  for (const auto& [failed, prints] : groups) {
    std::vector<std::string> everybody, alike;
    for (const auto& [print, students] : prints) {
      everybody.insert(everybody.end(), students.begin(), students.end());
      if (students.size() > 1) alike.push_back(listed(students));
    }
    if (everybody.size() > 1) table.push_back({std::to_string(everybody.size()), listed(everybody), said.at(failed), alike.empty() ? "none" : listed(alike)});
  }
  if (table.empty()) return "<p>No two students failed the same checks.</p>";
  return report::table({"students", "who", "failed", "with the same numbers"}, table, {0}, "Students who failed the same checks") +
         "<p class=\"soft\">The same wrong numbers to the last digit are a reason to look, no evidence: two people who make one simple mistake share them. Right code always has "
         "the same numbers; it is never listed here.</p>";
}

// What was counted, what it means, and a bar: most frequent first.
std::string counts_table(const std::map<std::string, int>& counts, const std::string& what, const std::function<std::string(const std::string&)>& says) {
  if (counts.empty()) return "<p>None.</p>";
  const auto list = most_frequent(counts);
  std::string html = "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"" + what + ", by number of students\"><table><thead><tr><th scope=\"col\">" + what +
                     "</th><th scope=\"col\" class=\"n\">students</th><th scope=\"col\" class=\"bar\" aria-hidden=\"true\"></th><th scope=\"col\">it says</th></tr></thead><tbody>\n";
  for (const auto& [id, n] : list)
    html += "<tr><td>" + escape(id) + "</td><td class=\"n\">" + std::to_string(n) + "</td><td class=\"bar\" aria-hidden=\"true\"><i style=\"width:" +
            brief(100.0 * n / list.front().second) + "%\"></i></td><td>" + escape(says(id)) + "</td></tr>\n";
  return html + "</tbody></table></div>\n";
}
std::string check_says(const std::string& id) { return find_check(id) == nullptr ? "" : find_check(id)->says; }
std::string mistake_says(const std::string& ids) {
  std::string text;
  for (std::size_t at = 0; at <= ids.size();) {
    const std::size_t end = std::min(ids.find('+', at), ids.size());
    if (const Misconception* m = find_misconception(ids.substr(at, end - at))) text += (text.empty() ? "" : "; ") + m->text;
    at = end + 1;
  }
  return text.empty() ? "a simple relation to the right numbers; see the reports" : text;
}

}  // namespace

std::string scores_csv(const std::vector<ClassRow>& rows) {
  const auto graded = std::find_if(rows.begin(), rows.end(), [](const ClassRow& r) { return !r.groups.empty(); });
  const std::vector<std::pair<std::string, double>> groups = graded == rows.end() ? std::vector<std::pair<std::string, double>>{} : graded->groups;
  std::string out = "student,score,max_score";
  for (const auto& [group, points] : groups) out += "," + cell(group);
  out += ",version,versions,late,trouble,email,id,report\n";
  for (const ClassRow& r : rows)
    for (const Person& person : people_of(r)) {
      out += cell(shown_name(r, person)) + "," + (r.trouble.empty() ? brief(r.score) + "," + brief(r.max_score) : ",");
      for (std::size_t k = 0; k < groups.size(); ++k) out += "," + (k < r.groups.size() ? brief(r.groups[k].second) : "");
      const std::string id = !person.school_id.empty() ? person.school_id : !person.canvas_id.empty() ? person.canvas_id : person.participant;
      out += "," + std::to_string(r.entry.version) + "," + std::to_string(r.entry.versions) + "," + (r.entry.late ? "yes" : "") + "," + cell(r.trouble) + "," +
             cell(person.email) + "," + cell(id) + "," + (r.trouble.empty() ? cell(safe_name(r.entry.student)) : "") + "\n";
    }
  return out;
}

std::string matrix_csv(const std::vector<ClassRow>& rows) {
  std::string out = "student";
  for (const Check& check : checks()) out += "," + check.id;
  out += "\n";
  for (const ClassRow& r : rows)
    for (const Person& person : people_of(r)) {
      out += cell(shown_name(r, person));
      for (const Check& check : checks()) out += "," + (r.verdicts.count(check.id) != 0 ? r.verdicts.at(check.id) : "");
      out += "\n";
    }
  return out;
}

std::vector<std::pair<std::string, std::string>> unfair(const std::vector<ClassRow>& rows) {
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const ClassRow& a : rows)
    for (const ClassRow& b : rows) {
      if (!a.trouble.empty() || !b.trouble.empty() || !(a.score > b.score)) continue;
      const auto more = failed_checks(a), fewer = failed_checks(b);
      if (more.size() > fewer.size() && std::includes(more.begin(), more.end(), fewer.begin(), fewer.end())) pairs.push_back({a.entry.student, b.entry.student});
    }
  return pairs;
}

std::string class_html(const std::vector<ClassRow>& rows, const Rubric& rubric, const std::vector<Change>& changed) {
  report::Page page;
  std::map<std::string, int> failures, named;
  int stubs = 0;
  std::vector<double> scores;
  std::vector<std::vector<std::string>> trouble, table;
  std::string list = "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"students\"><table><thead><tr><th scope=\"col\">student</th><th scope=\"col\" class=\"n\">points</th><th scope=\"col\">failed checks</th><th scope=\"col\">named</th><th scope=\"col\">remarks</th></tr></thead><tbody>\n";
  for (const ClassRow& r : rows) {
    if (!r.trouble.empty()) {
      trouble.push_back({r.entry.student, r.trouble});
      continue;
    }
    scores.push_back(r.score);
    std::string named_text;
    bool stub = false;
    for (const std::string& id : failed_checks(r))
      if (written(r, id)) ++failures[id];
      else stub = true;
    stubs += stub;
    for (const std::string& id : r.diagnoses) ++named[id], named_text += (named_text.empty() ? "" : ", ") + id;
    std::string group;
    if (r.entry.people.size() > 1)
      for (const Person& person : r.entry.people) group += (group.empty() ? "group: " : ", ") + shown_name(r, person);
    const std::string remarks = group + (group.empty() ? "" : " ") + std::string(r.entry.late ? "late " : "") + (r.entry.versions > 1 ? "version " + std::to_string(r.entry.version) + " of " + std::to_string(r.entry.versions) : "");
    list += "<tr><td><a href=\"" + link_to(r) + "/report.html\">" + escape(r.entry.student) + "</a></td><td class=\"n\">" + brief(r.score) +
            "</td><td>" + escape(failed_text(r)) + "</td><td>" + escape(named_text) + "</td><td>" + escape(remarks) + "</td></tr>\n";
  }
  list += "</tbody></table></div>\n";
  std::sort(scores.begin(), scores.end());
  page.title = rubric.title + ": a class of " + std::to_string(rows.size());
  double sum = 0;
  for (const double s : scores) sum += s;
  if (!scores.empty()) page.lead = std::to_string(scores.size()) + " graded; mean " + brief(std::round(10 * sum / double(scores.size())) / 10) + ", median " + brief((scores[(scores.size() - 1) / 2] + scores[scores.size() / 2]) / 2) + " points.";
  if (!trouble.empty()) page.body += "<h2>Could not be graded</h2>" + report::table({"student", "why"}, trouble, {}, "Students who could not be graded");
  if (!changed.empty()) {
    std::vector<std::vector<std::string>> lines;
    for (const Change& c : changed) lines.push_back({c.student, std::isnan(c.before) ? "none" : brief(c.before), std::isnan(c.after) ? "none" : brief(c.after), c.why});
    page.body += "<h2>Changed since the earlier run</h2>" + report::table({"student", "before", "after", "why"}, lines, {1, 2}, "Points before and after");
  }
  page.body += "<h2>Students</h2>" + list;
  page.body += "<h2>Scores</h2>" + histogram(rows);
  page.body += "<h2>Most failed checks</h2>" + counts_table(failures, "check", check_says);
  if (stubs > 0) page.body += "<p class=\"soft\">Functions left as they were handed out are not counted here; " + std::to_string(stubs) + (stubs == 1 ? " student has" : " students have") + " some.</p>";
  page.body += "<h2>Misconceptions</h2>" + counts_table(named, "named", mistake_says);
  page.body += "<h2>The same failures</h2>" + same_failures(rows);
  const auto pairs = unfair(rows);
  page.body += "<h2>Fairness</h2><p>" + (pairs.empty() ? "Every two students were compared: no one has more points than a classmate after failing all the checks that classmate failed and at least one more."
                                                       : escape(pairs.front().first + " failed more than " + pairs.front().second + " and has more points: " + std::to_string(pairs.size()) + " such pairs")) + "</p>";
  page.footer = "seed " + std::to_string(rubric.seed) + ", " + std::to_string(rubric.cases) + " cases a check, rubric " + rubric.hash();
  return report::render(page);
}

Outcome<bool> write_class(const std::filesystem::path& out, const std::vector<ClassRow>& rows, const Rubric& rubric, const std::vector<Change>& changed) {
  for (const auto& [name, text] : {std::pair{"scores.csv", scores_csv(rows)}, std::pair{"matrix.csv", matrix_csv(rows)}, std::pair{"class.html", class_html(rows, rubric, changed)}})
    if (const auto written = write_file(out / name, text); !written) return written;
  return true;
}

}  // namespace rigor::grader
