#include <functional>
#include <rigor/grader/report.hpp>
#include <rigor/grader/rubric.hpp>
#include <sstream>

namespace rigor::grader {
namespace {

// A TOML text in quotes.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    char code[8];
    std::snprintf(code, sizeof code, "\\u%04X", unsigned(static_cast<unsigned char>(c)));
    const bool control = static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
    out += control ? code : c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  }
  return out + "\"";
}
template <class Texts>
std::string listed(const Texts& texts) {
  std::string out;
  for (const std::string& text : texts) out += (out.empty() ? "" : ", ") + quoted(text);
  return "[" + out + "]";
}

}  // namespace

std::string practice_rubric_text(const Rubric& r) {
  std::vector<const Check*> seen;
  std::vector<std::string> ids;
  for (const Check& check : checks())
    if (r.practises(check)) seen.push_back(&check), ids.push_back(check.id);
  std::ostringstream out;
  out << "seed = " << r.practice_seed << "                   # for practice: the course grades with another\n"
      << "title = " << quoted(r.title) << "\ncases = " << r.cases << "\ntolerance = " << shortest(r.tolerance) << "\naccept = " << listed(r.accepted) << "\nrefuse = " << listed(r.refused) << "\n";
  if (!ids.empty()) out << "practice = " << listed(ids) << "\n";
  out << "\n[limits]\ncall_seconds = " << shortest(r.limits.call_s) << "\ntotal_seconds = " << shortest(r.limits.total_s) << "\nmemory_mb = " << (r.limits.memory_bytes >> 20) << "\n\n[groups]\n";
  for (const std::string& group : r.group_names()) {
    std::vector<std::string> members;
    for (const Check* check : seen)
      if (r.group_of(*check) == group) members.push_back(check->id);
    if (!members.empty()) out << quoted(group) << " = " << listed(members) << "\n";
  }
  const auto table = [&](const char* name, const std::function<std::string(const Check&)>& value) {
    out << "\n[" << name << "]\n";
    for (const Check* check : seen)
      if (const std::string text = value(*check); !text.empty()) out << quoted(check->id) << " = " << text << "\n";
  };
  table("points", [&](const Check& c) { return shortest(r.points_of(c)); });
  table("tolerances", [&](const Check& c) { return r.tolerances.count(c.id) == 0 ? "" : shortest(r.tolerances.at(c.id)); });
  table("case_counts", [&](const Check& c) { return r.case_counts.count(c.id) == 0 ? "" : std::to_string(r.case_counts.at(c.id)); });
  return out.str();
}

std::string default_rubric_text() {
  const Rubric d;
  std::ostringstream out;
  out << "# The default rubric of rigor. Every key may be left out; these are the values then used.\n"
      << "title = \"" << d.title << "\"      # shown on the report\n"
      << "seed = " << d.seed << "            # of the graded cases: fix one per assignment and keep it to yourself\n"
      << "practice_seed = " << d.practice_seed << "          # of the cases students practise on: goes out with the kit\n"
      << "cases = " << d.cases << "                # random inputs per check; a check is all or nothing\n"
      << "tolerance = " << d.tolerance << "              # multiplies every bound (derivations: docs/grading.md)\n"
      << "accept = []                # misconceptions that count as right, for example [\"plane.printed-restitution\"]\n"
      << "refuse = []                # readings that do not, for example [\"friction-literal\"]\n\n"
      << "[limits]                   # for the student's code\n"
      << "call_seconds = " << d.limits.call_s << "         # processor time of one call\n"
      << "total_seconds = " << d.limits.total_s << "         # of one process\n"
      << "memory_mb = " << (d.limits.memory_bytes >> 20) << "            # address space of one process\n\n"
      << "[groups]                   # the headings of the report and the problems of Autolab, in this order\n";
  for (const std::string& group : d.group_names()) {
    std::string ids;
    for (const Check& check : checks())
      if (check.group == group) ids += (ids.empty() ? "\"" : ", \"") + check.id + "\"";
    out << "\"" << group << "\" = [" << ids << "]\n";
  }
  out << "\n[points]                   # 0 makes a check advice\n";
  for (const std::string& group : d.group_names()) {
    double sum = 0;
    for (const Check& check : checks()) sum += check.group == group ? check.points : 0;
    out << "# " << group << ": " << sum << "\n";
    for (const Check& check : checks())
      if (check.group == group) out << "\"" << check.id << "\" = " << check.points << "  # " << check.says << "\n";
  }
  out << "\n[tolerances]               # of single checks, multiplied with the one above: \"update.torque\" = 2\n"
      << "[case_counts]              # of single checks in place of the number above: \"plane.impulse\" = 1000\n"
      << "[visibility]               # to students: \"update.torque\" = \"hidden\" (visible, hidden, after_due_date, after_published)\n";
  return out.str();
}

}  // namespace rigor::grader
