#include <algorithm>
#include <cmath>
#include <rigor/grader/class_run.hpp>
#include <rigor/grader/misconceptions.hpp>
#include <rigor/report/html.hpp>
#include <rigor/report/plot.hpp>

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
template <class Map>
std::vector<std::pair<std::string, int>> most_frequent(const Map& counts) {
  std::vector<std::pair<std::string, int>> list(counts.begin(), counts.end());
  std::stable_sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  return list;
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
// Which checks a student failed, in words.
std::string failed_text(const ClassRow& row) {
  const std::vector<std::string> ids = failed_checks(row);
  const auto with_points = std::count_if(checks().begin(), checks().end(), [](const Check& check) { return check.points > 0; });
  return long(ids.size()) == with_points ? "all " + std::to_string(with_points) : listed(ids);
}

// Students who failed the same checks, and which of them with the same numbers to the last digit.
std::string same_failures(const std::vector<ClassRow>& rows) {
  std::map<std::string, std::map<std::string, std::vector<std::string>>> groups;  // failed checks, then numbers
  for (const ClassRow& r : rows)
    if (!r.fingerprint.empty()) groups[failed_text(r)][r.fingerprint].push_back(r.entry.student);
  std::vector<std::vector<std::string>> table;
  for (const auto& [failed, prints] : groups) {
    std::vector<std::string> everybody, alike;
    for (const auto& [print, students] : prints) {
      everybody.insert(everybody.end(), students.begin(), students.end());
      if (students.size() > 1) alike.push_back(listed(students));
    }
    if (everybody.size() > 1) table.push_back({std::to_string(everybody.size()), listed(everybody), failed, alike.empty() ? "none" : listed(alike)});
  }
  if (table.empty()) return "<p>No two students failed the same checks.</p>";
  return report::table({"students", "who", "failed", "with the same numbers"}, table, {0}, "Students who failed the same checks") +
         "<p class=\"soft\">The same wrong numbers to the last digit are a reason to look, no evidence: two people who make one simple mistake share them. Right code always has "
         "the same numbers; it is never listed here.</p>";
}

// What was counted, what it means, and a bar: most frequent first.
std::string counted(const std::map<std::string, int>& counts, const std::string& what, const std::function<std::string(const std::string&)>& says) {
  if (counts.empty()) return "<p>None.</p>";
  const auto list = most_frequent(counts);
  std::string html = "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"" + what + ", by number of students\"><table><thead><tr><th scope=\"col\">" + what +
                     "</th><th scope=\"col\">it says</th><th scope=\"col\" class=\"n\">students</th><th scope=\"col\" class=\"bar\" aria-hidden=\"true\"></th></tr></thead><tbody>\n";
  for (const auto& [id, n] : list)
    html += "<tr><td>" + escape(id) + "</td><td>" + escape(says(id)) + "</td><td class=\"n\">" + std::to_string(n) + "</td><td class=\"bar\" aria-hidden=\"true\"><i style=\"width:" +
            brief(100.0 * n / list.front().second) + "%\"></i></td></tr>\n";
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
  out += ",version,versions,late,trouble\n";
  for (const ClassRow& r : rows) {
    out += cell(r.entry.student) + "," + (r.trouble.empty() ? brief(r.score) + "," + brief(r.max_score) : ",");
    for (std::size_t k = 0; k < groups.size(); ++k) out += "," + (k < r.groups.size() ? brief(r.groups[k].second) : "");
    out += "," + std::to_string(r.entry.version) + "," + std::to_string(r.entry.versions) + "," + (r.entry.late ? "yes" : "") + "," + cell(r.trouble) + "\n";
  }
  return out;
}

std::string matrix_csv(const std::vector<ClassRow>& rows) {
  std::string out = "student";
  for (const Check& check : checks()) out += "," + check.id;
  out += "\n";
  for (const ClassRow& r : rows) {
    out += cell(r.entry.student);
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
  std::vector<double> scores;
  std::vector<std::vector<std::string>> trouble, table;
  std::string list = "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"students\"><table><thead><tr><th scope=\"col\">student</th><th scope=\"col\" class=\"n\">points</th><th scope=\"col\">failed checks</th><th scope=\"col\">named</th><th scope=\"col\">remarks</th></tr></thead><tbody>\n";
  for (const ClassRow& r : rows) {
    if (!r.trouble.empty()) {
      trouble.push_back({r.entry.student, r.trouble});
      continue;
    }
    scores.push_back(r.score);
    for (const std::string& id : failed_checks(r)) ++failures[id];
    for (const std::string& id : r.diagnoses) ++named[id];
    const std::string remarks = std::string(r.entry.late ? "late " : "") + (r.entry.versions > 1 ? "version " + std::to_string(r.entry.version) + " of " + std::to_string(r.entry.versions) : "");
    list += "<tr><td><a href=\"" + escape(safe_name(safe_name(r.entry.student))) + "/report.html\">" + escape(r.entry.student) + "</a></td><td class=\"n\">" + brief(r.score) +
            "</td><td>" + escape(failed_text(r)) + "</td><td>" + escape(listed(r.diagnoses)) + "</td><td>" + escape(remarks) + "</td></tr>\n";
  }
  list += "</tbody></table></div>\n";
  std::sort(scores.begin(), scores.end());
  page.title = rubric.title + ": a class of " + std::to_string(rows.size());
  double sum = 0;
  for (const double s : scores) sum += s;
  if (!scores.empty()) page.lead = std::to_string(scores.size()) + " graded; mean " + brief(std::round(10 * sum / double(scores.size())) / 10) + ", median " + brief((scores[(scores.size() - 1) / 2] + scores[scores.size() / 2]) / 2) + " points.";
  page.body = histogram(rows);
  if (!trouble.empty()) page.body += "<h2>Could not be graded</h2>" + report::table({"student", "why"}, trouble, {}, "Students who could not be graded");
  if (!changed.empty()) {
    std::vector<std::vector<std::string>> lines;
    for (const Change& c : changed) lines.push_back({c.student, std::isnan(c.before) ? "none" : brief(c.before), std::isnan(c.after) ? "none" : brief(c.after), c.why});
    page.body += "<h2>Changed since the earlier run</h2>" + report::table({"student", "before", "after", "why"}, lines, {1, 2}, "Points before and after");
  }
  page.body += "<h2>Most failed checks</h2>" + counted(failures, "check", check_says);
  page.body += "<h2>Misconceptions</h2>" + counted(named, "named", mistake_says);
  page.body += "<h2>The same failures</h2>" + same_failures(rows);
  const auto pairs = unfair(rows);
  page.body += "<h2>Fairness</h2><p>" + (pairs.empty() ? "Nobody who failed everything another failed, and more, has more points than the other."
                                                       : escape(pairs.front().first + " failed more than " + pairs.front().second + " and has more points: " + std::to_string(pairs.size()) + " such pairs")) + "</p>";
  page.body += "<h2>Students</h2>" + list;
  page.footer = "seed " + std::to_string(rubric.seed) + ", " + std::to_string(rubric.cases) + " cases a check, rubric " + rubric.hash();
  return report::render(page);
}

}  // namespace rigor::grader
