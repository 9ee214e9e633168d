#include <cmath>
#include <cstdio>
#include <rigor/grader/report.hpp>
#include <rigor/report/html.hpp>

namespace rigor::grader {
namespace {

using rigor::report::escape;

std::string brief(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.7g", x);
  return text;
}

const char* css_class(const CheckResult& r) {
  if (r.verdict == Verdict::pass) return "good";
  return r.max_points == 0 || r.verdict == Verdict::skipped ? "warn" : "bad";
}
std::string word(const CheckResult& r) {
  return r.max_points == 0 && r.verdict == Verdict::fail ? "advice" : name(r.verdict);
}

// The box and what acts on it, projected along z onto the plane of x and y: enough to see which way things point.
std::string picture(const Counterexample& e) {
  if (e.function != Function::plane_response && e.function != Function::friction_tangent && e.function != Function::pair_response) return "";
  const Scenario& s = e.inputs;
  const double unit = 60 / std::fmax(1, std::fmax(s.A.reach(), e.function == Function::pair_response ? s.B.reach() : 0));
  const Vec3<double> origin = s.point;
  const auto at = [&](const Vec3<double>& p) {
    return std::pair<double, double>{160 + unit * (p[0] - origin[0] + 0.35 * (p[2] - origin[2])), 120 - unit * (p[1] - origin[1] + 0.25 * (p[2] - origin[2]))};
  };
  std::string svg;
  const auto line = [&](const Vec3<double>& a, const Vec3<double>& b, const std::string& style) {
    const auto [x1, y1] = at(a);
    const auto [x2, y2] = at(b);
    char text[240];
    std::snprintf(text, sizeof text, "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" %s/>", x1, y1, x2, y2, style.c_str());
    svg += text;
  };
  const auto box = [&](const Box& b, const std::string& colour) {
    const Mat3<double> R = b.R_WB();
    const auto corner = [&](int k) {
      return Vec3<double>(b.position + R * Vec3<double>((k & 1 ? 1 : -1) * b.size[0] / 2, (k & 2 ? 1 : -1) * b.size[1] / 2, (k & 4 ? 1 : -1) * b.size[2] / 2));
    };
    for (int k = 0; k < 8; ++k)
      for (int bit : {1, 2, 4})
        if ((k & bit) == 0) line(corner(k), corner(k | bit), "stroke=\"" + colour + "\" stroke-width=\"1.3\"");
    line(b.position, Vec3<double>(b.position + 0.5 * b.velocity), "stroke=\"" + colour + "\" stroke-width=\"2\" stroke-dasharray=\"4 3\"");
  };
  box(s.A, "var(--s0)");
  if (e.function == Function::pair_response) box(s.B, "var(--s1)");
  line(s.point, Vec3<double>(s.point + s.normal), "stroke=\"var(--s2)\" stroke-width=\"2.5\"");
  const std::string says = e.function == Function::pair_response
                               ? "body 1 (blue), body 2 (orange), their velocities (dashed), the normal from 1 to 2 at the contact (green)"
                               : "the cuboid (blue), its velocity (dashed), the plane's normal at the contact (green)";
  return "<figure><svg role=\"img\" viewBox=\"0 0 320 240\" width=\"320\" height=\"240\"><title>" + says + "</title>" + svg +
         "<circle cx=\"160\" cy=\"120\" r=\"3.5\" fill=\"var(--s2)\"/></svg><figcaption>" + says + "</figcaption></figure>\n";
}

std::string counterexample(const Report& report, const CheckResult& r) {
  const Counterexample& e = *r.counterexample;
  std::string html = "<p>The smallest case found on which it fails (from case " + std::to_string(e.number) + "):</p>\n";
  std::vector<std::vector<std::string>> inputs;
  for (const auto& [what, value] : named_inputs(e)) inputs.push_back({what, value});
  html += rigor::report::table({"input", "value"}, inputs) + picture(e);
  if (!e.death.empty()) html += "<p class=\"bad\">The call then ended: " + escape(e.death) + "</p>\n";
  std::vector<std::vector<std::string>> rows;
  for (const Component& c : e.judgement.components)
    rows.push_back({c.name, c.unit, brief(c.got), brief(c.want), brief(c.bound), brief(c.got == c.want ? 0 : std::fabs(c.got - c.want) / c.bound)});
  if (!rows.empty()) html += rigor::report::table({"result", "unit", "got", "want", "allowed error", "error/allowed"}, rows, {2, 3, 4, 5});
  return html + "<p>Replay:</p><pre>" + escape(replay_command(report, r)) + "</pre>\n";
}

std::string one(const Report& report, const CheckResult& r) {
  std::string html = "<details" + std::string(r.verdict == Verdict::pass || r.max_points == 0 ? "" : " open") + "><summary><span class=\"" + css_class(r) + "\">" +
                     escape(word(r)) + "</span> <strong>" + escape(r.check->id) + "</strong> <span class=\"soft\">" + brief(r.points) + " of " + brief(r.max_points) +
                     "</span></summary><div class=\"card\"><p>" + escape(r.check->says) + " <span class=\"soft\">(" + escape(student_function_name(r.check->function)) +
                     "; <code>rigor explain " + escape(r.check->formula) + "</code>)</span></p>\n";
  if (!r.words.empty()) html += "<pre>" + escape(r.words) + "</pre>\n";
  for (const Diagnosis& d : r.diagnosis)
    html += "<p><strong>Likely:</strong> " + escape(d.text) + " <span class=\"soft\">(agrees on " + std::to_string(d.agreements) + " of " + std::to_string(d.cases) + " cases)</span></p>\n";
  for (const std::string& note : r.notes) html += "<p class=\"soft\">Note: " + escape(note) + "</p>\n";
  if (r.verdict != Verdict::pass && r.counterexample) html += counterexample(report, r);
  if (r.cases > 0) html += "<p class=\"soft\">" + std::to_string(r.cases) + " cases, worst error " + brief(r.worst_ratio) + " of what is allowed.</p>\n";
  return html + "</div></details>\n";
}

}  // namespace

std::string report_html(const Report& report) {
  rigor::report::Page page;
  page.title = report.submission + ": " + brief(report.score) + " of " + brief(report.max_score);
  page.lead = report.rubric_title;
  page.style = "summary{cursor:pointer;padding:.25rem 0}summary strong{font-weight:600}";
  std::vector<std::vector<std::string>> groups;
  for (const CheckResult& r : report.results) {
    if (groups.empty() || groups.back()[0] != r.check->group) groups.push_back({r.check->group, "0", "0"});
    groups.back()[1] = brief(std::stod(groups.back()[1]) + r.points);
    groups.back()[2] = brief(std::stod(groups.back()[2]) + r.max_points);
  }
  page.body = rigor::report::table({"part", "points", "of"}, groups, {1, 2});
  std::string group;
  for (const CheckResult& r : report.results) {
    if (r.check->group != group) page.body += "<h2>" + escape(group = r.check->group) + "</h2>\n";
    page.body += one(report, r);
  }
  if (!report.notes.empty()) {
    page.body += "<h2>Notes</h2><ul>";
    for (const std::string& note : report.notes) page.body += "<li>" + escape(note) + "</li>";
    page.body += "</ul>\n";
  }
  if (!report.output.empty()) page.body += "<h2>Printed by the submission</h2><pre>" + escape(report.output) + "</pre>\n";
  page.footer = report.tool + "; seed " + std::to_string(report.seed) + ", " + std::to_string(report.cases) + " cases a check; submission " + report.submission_hash + "; isolation: ";
  for (std::size_t i = 0; i < report.isolation.size(); ++i) page.footer += (i > 0 ? "; " : "") + report.isolation[i];
  return rigor::report::render(page);
}

}  // namespace rigor::grader
