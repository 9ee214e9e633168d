#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string_view>
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
    word.resize(15, ' ');
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

void add_component(Text& t, const Component& c) {
  char numbers[120];
  const int width = std::snprintf(numbers, sizeof numbers, "        %-14.7g %-14.7g %-9.3g ", c.got, c.want, c.bound == 0 ? INFINITY : std::fabs(c.got - c.want) / c.bound);
  const std::size_t start = t.out.size();
  t.wrap(c.name + " [" + c.unit + "]", std::string(std::size_t(width), ' '));
  t.out.replace(start, std::size_t(width), numbers);
}

// A command that is too long for 80 columns goes on in lines of its own, as a shell takes it.
void add_command(Text& t, const std::string& before, const std::string& command) {
  std::string line = before;
  for (std::size_t begin = 0; begin < command.size();) {
    const std::size_t end = std::min(command.find(" --", begin + 1), command.size());
    const std::string word = command.substr(begin, end - begin);  // "rigor grade PATH", " --check ID"
    const std::size_t room = end == command.size() ? 80 : 78;
    if (begin > 0 && line.size() + word.size() > room) t.out += line + " \\\n", line = std::string(9, ' ');
    line += word;
    begin = end;
  }
  t.out += line + "\n";
}

void add_counterexample(Text& t, const Report& report, const CheckResult& r) {
  const Counterexample& e = *r.counterexample;
  t.out += "      smallest failing case (from case " + std::to_string(e.number) + "):\n";
  for (const auto& [what, value] : named_inputs(e)) t.wrap(what + " = " + value, "        ");
  if (!e.death.empty()) t.wrap("then: " + plain(e.death), "        ");
  std::vector<const Component*> wrong;
  for (const Component& c : e.judgement.components)
    if (!(std::fabs(c.got - c.want) <= c.bound)) wrong.push_back(&c);
  if (wrong.empty() && worst(e) != nullptr) wrong.push_back(worst(e));
  if (!wrong.empty()) t.out += "        got            want           error/bound\n";
  for (std::size_t i = 0; i < wrong.size() && i < 6; ++i) add_component(t, *wrong[i]);
  if (wrong.size() > 6) t.out += "        ... and " + std::to_string(wrong.size() - 6) + " more\n";
  if (const std::string command = replay_command(report, r); !command.empty()) add_command(t, "      replay: ", plain(command));
}

// "compiler: nobody, bubblewrap, system calls filtered, limits"; report.json and the page have the layers in full.
std::string brief_isolation(const std::string& layers) {
  const std::size_t begin = layers.find(": ") + 2;
  std::string out = layers.substr(0, begin);
  const auto add = [&](const char* sign, const char* words) {
    if (layers.find(sign, begin) != layers.npos) out += (out.size() > begin ? ", " : "") + std::string(words);
  };
  add("user: nobody", "nobody");
  add("user: the one", "your own user");
  add("bubblewrap: ", "bubblewrap");
  add("process only: ", "process only (no bubblewrap)");
  add("landlock: ", "landlock");
  add("files: all", "files in sight");
  add("system calls: an allow-list", "few system calls");
  add("system calls: network", "no network");
  add("system calls: not filtered", "system calls not filtered");
  add("limits: ", "limits");
  return out;
}

// "200 cases, error 3e-06", in parts of what is allowed; nothing of an error where no case got an answer.
std::string seen(const CheckResult& r) {
  if (r.cases == 0) return "";
  const std::string cases = counted(r.cases, "case");
  if (r.answered == 0) return cases;
  return cases + (std::isfinite(r.worst_ratio) ? ", error " + format("%.2g", r.worst_ratio) : ", no number");
}

void add_result(Text& t, const Report& report, const CheckResult& r, std::map<std::string, std::string>& said) {
  const bool advice = r.max_points == 0;
  char line[160];
  std::snprintf(line, sizeof line, " %-25s %2g of %-2g ", r.check->id.c_str(), r.points, r.max_points);
  std::string row = line + seen(r);
  row.erase(row.find_last_not_of(' ') + 1);
  t.out += "  " + t.verdict(r.verdict, advice) + row + "\n";
  if (std::string_view(r.visibility) != "visible") t.wrap("hidden from students (" + std::string(r.visibility) + ")", "      ");
  for (const std::string& note : r.notes) t.wrap("note: " + plain(note), "      ");
  if (r.verdict == Verdict::pass) return;
  t.wrap(said_of(r) + " (rigor explain " + r.check->formula + ")", "      ");
  if (!r.words.empty()) {  // what the compiler said of a function is said once
    const auto [first, fresh] = said.emplace(r.words, r.check->id);
    t.wrap(fresh || r.verdict != Verdict::not_compiled ? plain(r.words) : "does not compile: see " + first->second, "      ");
  }
  for (const Diagnosis& d : r.diagnosis)
    t.wrap("likely: " + plain(d.text) + " (agrees on " + std::to_string(d.agreements) + " of " + counted(d.cases, "case") + ")", "      ");
  if (r.counterexample && !advice) add_counterexample(t, report, r);
}

}  // namespace

std::string report_text(const Report& report, bool colour) {
  Text t(colour);
  t.out += t.paint("1", plain(printable(report.submission)) + ": " + format("%g", report.score) + " of " + format("%g", report.max_score)) + "\n";
  if (report.rubric_points != 100) t.out += "the points of this rubric add up to " + format("%g", report.rubric_points) + ", not 100\n";
  std::map<std::string, std::string> said;
  std::string group;
  for (const CheckResult& r : report.results) {
    if (!shown(report, r)) continue;
    if (r.group != group) {
      double points = 0, most = 0;
      for (const CheckResult& other : report.results)
        if (other.group == r.group && shown(report, other)) points += other.points, most += other.max_points;
      t.out += "\n" + t.paint("1", (group = r.group)) + "  " + format("%g", points) + " of " + format("%g", most) + "\n";
    }
    add_result(t, report, r, said);
  }
  t.out += "\nerror: the largest over a check's cases; 1 is what is allowed\n";
  t.wrap(withheld(report), "");
  for (const std::string& note : report.notes) t.wrap("note: " + plain(note), "");
  if (!report.output.empty()) {
    t.out += "printed by the submission:\n";
    t.wrap(plain(report.output.substr(0, 400)), "  | ");
  }
  const std::string seed = report.reader == Reader::platform ? "" : report.reader == Reader::practice ? "cases for practice, " : "seed " + std::to_string(report.seed) + ", ";
  t.wrap(seed + counted(report.cases, "case") + " a check, " + format("%.1f", report.seconds) + " s", "");
  for (const std::string& line : report.isolation) t.wrap("isolation of the " + brief_isolation(line), "");
  return t.out;
}

}  // namespace rigor::grader
