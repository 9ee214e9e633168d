#include <cmath>
#include <cstdio>
#include <map>
#include <string_view>
#include <rigor/grader/picture.hpp>
#include <rigor/grader/report_parts.hpp>
#include <rigor/report/formula.hpp>
#include <rigor/report/html.hpp>

namespace rigor::grader {
namespace {

using rigor::report::escape;

constexpr const char* style = R"css(
summary{cursor:pointer;padding:.3rem 0;display:flex;flex-wrap:wrap;gap:.15rem .7rem;align-items:baseline}
summary .says{flex:1 1 18rem}summary::before{content:"▸";color:var(--soft)}details[open]>summary::before{content:"▾"}
details{border-bottom:1px solid var(--line)}details>.card{margin:.3rem 0 1rem}.card h3{margin:.9rem 0 .2rem}
.case{display:flex;flex-wrap:wrap;gap:0 1.5rem;align-items:flex-start}.case>.scroll{flex:1 1 22rem;min-width:0}figure.case{display:block;flex:0 1 26rem;margin:.6rem 0}
figure.case svg{background:var(--paper);border:1px solid var(--line);border-radius:6px}
svg .name{font-style:italic;font-size:14px;stroke:var(--paper);stroke-width:4px;paint-order:stroke;stroke-linejoin:round}
.total{font-size:1.15rem}.total strong{font-size:1.5rem}.likely{border-left:4px solid var(--warn);padding-left:.7rem}
@media print{summary::before{content:""}.card{border:0;padding:0}}
)css";

std::string brief(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.7g", x == 0 ? 0.0 : x);
  return text;
}
std::string shorter(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.2g", x);
  return text;
}

const char* css_class(const CheckResult& r) {
  if (r.verdict == Verdict::pass) return "good";
  return r.max_points == 0 || r.verdict == Verdict::skipped ? "warn" : "bad";
}
std::string word(const CheckResult& r) {
  return r.max_points == 0 && r.verdict == Verdict::fail ? "advice" : name(r.verdict);
}
bool wrong(const Component& c) { return !(std::fabs(c.got - c.want) <= c.bound); }

std::string counterexample(const Report& report, const CheckResult& r) {
  const Counterexample& e = *r.counterexample;
  std::vector<std::vector<std::string>> inputs, rows;
  for (const auto& [what, value] : named_inputs(e)) inputs.push_back({what, value});
  std::string html = "<h3>The smallest case found on which it fails</h3>\n<div class=\"case\">" +
                     rigor::report::table({"input", "value"}, inputs, {}, "Inputs, from case " + std::to_string(e.number)) + picture(e) + "</div>\n";
  if (!e.death.empty()) html += "<p class=\"bad\">The call then ended: " + escape(e.death) + "</p>\n";
  for (const Component& c : e.judgement.components)
    rows.push_back({wrong(c) ? "wrong" : "right", c.name, c.unit, brief(c.got), brief(c.want), c.bound == 0 ? "none" : shorter(c.bound), shorter(c.got == c.want ? 0 : std::fabs(c.got - c.want) / c.bound)});
  if (!rows.empty())
    html += rigor::report::table({"", "result", "unit", "got", "want", "allowed error", "error / allowed"}, rows, {3, 4, 5, 6}, "What came out, and what should have");
  const std::string command = replay_command(report, r);
  return html + (command.empty() ? "" : "<h3>Once more, by hand</h3><pre>" + escape(command) + "</pre>\n");
}

std::string one(const Report& report, const CheckResult& r, std::map<std::string, std::string>& said) {
  const bool passed = r.verdict == Verdict::pass;
  std::string html = "<details id=\"" + escape(r.check->id) + "\"" + (passed || r.max_points == 0 ? "" : " open") + "><summary><span class=\"badge " + css_class(r) + "\">" + escape(word(r)) +
                     "</span> <strong>" + escape(r.check->id) + "</strong> <span class=\"says\">" + escape(said_of(r)) + "</span> <span class=\"soft\">" +
                     (r.max_points > 0 ? brief(r.points) + " of " + brief(r.max_points) : "no points") + "</span></summary><div class=\"card\">\n" +
                     "<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"formula\">" + rigor::report::formula_html(r.check->formula) + "</div><p class=\"soft\">" + escape(student_function_name(r.check->function)) + "; derivation: <code>rigor explain " +
                     escape(r.check->formula) + "</code></p>\n";
  if (std::string_view(r.visibility) != "visible") html += "<p class=\"soft\">Hidden from students (" + escape(r.visibility) + ").</p>\n";
  if (!r.words.empty()) {  // what the compiler said of a function is said once
    const auto [first, fresh] = said.emplace(r.words, r.check->id);
    html += fresh || r.verdict != Verdict::not_compiled ? "<pre>" + escape(r.words) + "</pre>\n" : "<p>Does not compile: see <a href=\"#" + escape(first->second) + "\">" + escape(first->second) + "</a>.</p>\n";
  }
  for (const Diagnosis& d : r.diagnosis)
    html += "<p class=\"likely\"><strong>Likely:</strong> " + escape(d.text) + ". <span class=\"soft\">That gives the submission's numbers on " + std::to_string(d.agreements) + " of " +
            counted(d.cases, "case") + ".</span></p>\n";
  for (const std::string& note : r.notes) html += "<p>Note: " + escape(note) + "</p>\n";
  if (!passed && r.counterexample) html += counterexample(report, r);
  if (r.cases > 0)
    html += "<p class=\"soft\">" + counted(r.cases, "case") +
            (r.answered == 0                   ? "; none got an answer"
             : std::isfinite(r.worst_ratio) ? "; the worst error is " + shorter(r.worst_ratio) + " times what is allowed"
                                            : "; an answer was no finite number") +
            ".</p>\n";
  return html + "</div></details>\n";
}

// Points by part, and where they were lost.
std::string summary(const Report& report) {
  std::vector<std::string> groups;
  std::vector<double> points, most;
  std::string lost;
  for (const CheckResult& r : report.results) {
    if (!shown(report, r)) continue;
    if (groups.empty() || groups.back() != r.group) groups.push_back(r.group), points.push_back(0), most.push_back(0);
    points.back() += r.points;
    most.back() += r.max_points;
    if (r.points >= r.max_points) continue;
    lost += "<li><a href=\"#" + escape(r.check->id) + "\">" + escape(r.check->id) + "</a>: " + escape(word(r)) + ", " + brief(r.max_points - r.points) + (r.max_points - r.points == 1 ? " point" : " points");
    if (!r.diagnosis.empty()) lost += "; likely " + escape(r.diagnosis.front().text);
    lost += "</li>\n";
  }
  std::vector<std::vector<std::string>> parts;  // without those that are advice only
  for (std::size_t i = 0; i < groups.size(); ++i)
    if (most[i] > 0) parts.push_back({groups[i], brief(points[i]), brief(most[i])});
  return "<p class=\"total\"><strong>" + brief(report.score) + "</strong> of " + brief(report.max_score) + " points</p>\n" +
         (report.rubric_points == 100 ? "" : "<p>The points of this rubric add up to " + brief(report.rubric_points) + ", not 100.</p>\n") +
         (withheld(report).empty() ? "" : "<p>" + withheld(report) + ".</p>\n") + rigor::report::table({"part", "points", "of"}, parts, {1, 2}, "Points by part") +
         (lost.empty() ? "" : "<h2>Where points were lost</h2>\n<ul>" + lost + "</ul>\n");
}

constexpr const char* symbols =
    "<details><summary>Symbols</summary><p>x position, v velocity, ω spin (rad/s), R rotation from body to world, m mass, I inertia in world axes and I<sub>B</sub> in body axes, both about "
    "the centre; w, h, d full edge lengths; F, τ net force and torque; r arm from the centre to a point, in world axes; n unit normal, of the plane or from body 1 to body 2; "
    "v<sub>c</sub> velocity of the contact point (of 2 relative to 1); e restitution, μ<sub>s</sub> and μ<sub>d</sub> friction; j impulse; h the step; ⁺ marks afterwards. SI units.</p></details>\n";

}  // namespace

std::string report_html(const Report& report) {
  rigor::report::Page page;
  page.title = report.submission + ": " + brief(report.score) + " of " + brief(report.max_score);
  page.lead = report.rubric_title;
  page.style = style;
  page.body = summary(report);
  std::string group;
  std::map<std::string, std::string> said;
  for (const CheckResult& r : report.results) {
    if (!shown(report, r)) continue;
    if (r.group != group) page.body += "<h2>" + escape(group = r.group) + "</h2>\n" + (&r == &report.results.front() ? symbols : "");
    page.body += one(report, r, said);
  }
  if (report.ladder) page.body += "<h2>How update converges</h2>\n" + ladder_figures(*report.ladder);
  if (report.scene) page.body += "<h2>The scene over 20 s</h2>\n" + scene_figures(*report.scene);
  if (!report.notes.empty()) {
    page.body += "<h2>Notes</h2><ul>";
    for (const std::string& note : report.notes) page.body += "<li>" + escape(note) + "</li>";
    page.body += "</ul>\n";
  }
  if (!report.output.empty()) page.body += "<h2>Printed by the submission</h2><pre>" + escape(report.output) + "</pre>\n";
  page.footer = report.tool + "; " + (report.reader == Reader::instructor ? "seed " + std::to_string(report.seed) + ", " : "") + counted(report.cases, "case") + " a check; submission " + report.submission_hash;
  for (const std::string& line : report.isolation) page.footer += "; isolation: " + line;
  return rigor::report::render(page);
}

}  // namespace rigor::grader
