#include <algorithm>
#include <cmath>
#include <cstdio>
#include <rigor/grader/printable.hpp>
#include <rigor/grader/report.hpp>
#include <rigor/report/html.hpp>

namespace rigor::grader {
namespace {

// What a student wrote, made safe for a terminal.
std::string plain(const std::string& text) { return rigor::report::clean(text); }

std::string format(const char* pattern, double a) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, a);
  return text;
}

class Text {
 public:
  explicit Text(bool colour) : colour_(colour) {}
  std::string out;

  std::string paint(const char* code, const std::string& text) const { return colour_ ? "\x1b[" + std::string(code) + "m" + text + "\x1b[0m" : text; }
  std::string verdict(Verdict v, bool advice) const {
    std::string word = name(v);
    if (advice && v == Verdict::fail) word = "advice";
    word.resize(16, ' ');
    return paint(v == Verdict::pass ? "32" : advice || v == Verdict::skipped ? "33" : "31", word);
  }
  // "  words words" wrapped at 80 columns
  void wrap(const std::string& text, const std::string& indent) {
    std::string line = indent;
    std::string word;
    const auto flush = [&] {
      if (line.size() > indent.size() && line.size() + 1 + word.size() > 80) out += line + "\n", line = indent;
      if (line.size() > indent.size()) line += " ";
      line += word;
      word.clear();
    };
    for (const char c : text) {
      if (c == '\n') { flush(); out += line + "\n"; line = indent; }
      else if (c == ' ') flush();
      else word += c;
    }
    flush();
    if (line.size() > indent.size()) out += line + "\n";
  }

 private:
  bool colour_;
};

void add_counterexample(Text& t, const Report& report, const CheckResult& r) {
  const Counterexample& e = *r.counterexample;
  t.out += "      smallest failing case (from case " + std::to_string(e.number) + "):\n";
  for (const auto& [what, value] : named_inputs(e)) t.wrap(what + " = " + value, "        ");
  if (!e.death.empty()) t.wrap("then: " + plain(e.death), "        ");
  std::vector<const Component*> wrong;
  for (const Component& c : e.judgement.components)
    if (!(std::fabs(c.got - c.want) <= c.bound)) wrong.push_back(&c);
  if (!wrong.empty()) t.out += "        " + std::string("got            want           error/bound") + "\n";
  for (std::size_t i = 0; i < wrong.size() && i < 6; ++i) {
    const Component& c = *wrong[i];
    char line[200];
    std::snprintf(line, sizeof line, "        %-14.7g %-14.7g %-9.3g %s [%s]\n", c.got, c.want, std::fabs(c.got - c.want) / c.bound, c.name.c_str(), c.unit.c_str());
    t.out += line;
  }
  if (wrong.size() > 6) t.out += "        ... and " + std::to_string(wrong.size() - 6) + " more\n";
  t.out += "      replay: " + plain(replay_command(report, r)) + "\n";
}

void add_result(Text& t, const Report& report, const CheckResult& r) {
  const bool advice = r.max_points == 0;
  char line[160];
  std::snprintf(line, sizeof line, " %-28s %4g of %-4g %s\n", r.check->id.c_str(), r.points, r.max_points,
                r.cases > 0 ? (std::to_string(r.cases) + " cases, worst error " + format("%.2g", r.worst_ratio) + " of its bound").c_str() : "");
  t.out += "  " + t.verdict(r.verdict, advice) + line;
  for (const std::string& note : r.notes) t.wrap("note: " + plain(note), "      ");
  if (r.verdict == Verdict::pass) return;
  t.wrap(r.check->says + " (rigor explain " + r.check->formula + ")", "      ");
  if (!r.words.empty()) t.wrap(plain(r.words), "      ");
  for (const Diagnosis& d : r.diagnosis)
    t.wrap("likely: " + plain(d.text) + " (agrees on " + std::to_string(d.agreements) + " of " + std::to_string(d.cases) + " cases)", "      ");
  if (r.counterexample && !advice) add_counterexample(t, report, r);
}

}  // namespace

std::string report_text(const Report& report, bool colour) {
  Text t(colour);
  t.out += t.paint("1", plain(printable(report.submission)) + ": " + format("%g", report.score) + " of " + format("%g", report.max_score)) + "\n";
  std::string group;
  for (const CheckResult& r : report.results) {
    if (r.group != group) {
      double points = 0, most = 0;
      for (const CheckResult& other : report.results)
        if (other.group == r.group) points += other.points, most += other.max_points;
      t.out += "\n" + t.paint("1", (group = r.group)) + "  " + format("%g", points) + " of " + format("%g", most) + "\n";
    }
    add_result(t, report, r);
  }
  t.out += "\n";
  for (const std::string& note : report.notes) t.wrap("note: " + plain(note), "");
  if (!report.output.empty()) {
    t.out += "printed by the submission:\n";
    t.wrap(plain(report.output.substr(0, 400)), "  | ");
  }
  std::string isolation;
  for (const std::string& line : report.isolation) isolation += (isolation.empty() ? "" : "; ") + line;
  t.wrap("seed " + std::to_string(report.seed) + ", " + std::to_string(report.cases) + " cases a check, " + format("%.1f", report.seconds) + " s; isolation: " + isolation, "");
  return t.out;
}

}  // namespace rigor::grader
