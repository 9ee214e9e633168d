#include <cstdio>
#include <nlohmann/json.hpp>
#include <rigor/grader/audit.hpp>

namespace rigor::grader {
namespace {

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : between) + word;
  return all;
}
std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size()), ' ');
  return text;
}
std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", x);
  return text;
}

/// A name that was not to be given, or none where one was.
struct Confusion {
  std::string id, named;
  int seeds;
};
std::vector<Confusion> confusions(const Audit& audit) {
  std::vector<Confusion> list;
  for (const AuditRow& r : audit.misconceptions)
    for (const auto& [name, seeds] : r.names)
      if (name != r.shown_as) list.push_back({r.id, name, seeds});
  return list;
}

/// Misconceptions that are the same function of every input, by the name they share.
std::map<std::string, std::vector<std::string>> classes(const Audit& audit) {
  std::map<std::string, std::vector<std::string>> all;
  for (const AuditRow& r : audit.misconceptions)
    if (r.shown_as != r.id) all[r.shown_as].push_back(r.id);
  return all;
}

}  // namespace

std::string audit_text(const Audit& audit) {
  std::string out = "misconception                    fails  named  cases needed (median, worst)  failed checks\n";
  for (const AuditRow& r : audit.misconceptions) {
    const std::string named = r.named_right ? "yes" : r.named_wrong() ? "WRONG" : "-";
    out += padded(r.id, 33) + padded(r.failed ? "yes" : "NO", 7) + padded(named, 7) + padded(number(r.median_cases) + ", " + std::to_string(r.worst_cases), 30) + joined(r.checks, " ") +
           (r.missed.empty() ? "" : "  MISSED BY " + joined(r.missed, " ")) + "\n";
  }
  out += "\nthe same function of every input (one name for the class)\n";
  for (const auto& [name, members] : classes(audit)) out += name + " = " + joined(members, " = ") + "\n";
  out += "\nconfused with another, or not named\n";
  for (const Confusion& c : confusions(audit)) out += padded(c.id, 33) + (c.named.empty() ? "nothing named" : "named " + c.named) + " at " + std::to_string(c.seeds) + " of " + std::to_string(audit.seeds) + " seeds\n";
  if (confusions(audit).empty()) out += "none\n";
  out += "\nright ones (must get 100)\n";
  for (const AuditReading& r : audit.variants) out += padded(r.id, 33) + number(r.lowest) + (r.failed.empty() ? "" : "  " + r.failed) + "\n";
  char line[256];
  std::snprintf(line, sizeof line, "\n%zu misconceptions: %d fail, %d named right, %d named wrong; %d of %zu right ones with full marks; %d seeds, %d cases a check, %.0f s\n",
                audit.misconceptions.size(), audit.failed(), audit.named_right(), audit.named_wrong(), audit.right_full_marks(), audit.variants.size(), audit.seeds, audit.cases, audit.seconds);
  return out + line;
}

std::string audit_json(const Audit& audit) {
  using Json = nlohmann::ordered_json;
  Json json{{"misconceptions", audit.misconceptions.size()}, {"failed", audit.failed()}, {"named_right", audit.named_right()},
            {"named_wrong", audit.named_wrong()}, {"right_variants", audit.variants.size()}, {"right_full_marks", audit.right_full_marks()},
            {"seeds", audit.seeds}, {"cases", audit.cases}, {"seconds", audit.seconds}, {"table", Json::array()}, {"confusion", Json::array()}, {"classes", Json::object()}, {"right", Json::array()}};
  for (const AuditRow& r : audit.misconceptions)
    json["table"].push_back({{"id", r.id}, {"shown_as", r.shown_as}, {"failed", r.failed}, {"named_right", r.named_right}, {"named_wrong", r.named_wrong()}, {"checks", r.checks},
                             {"missed", r.missed}, {"median_cases", r.median_cases}, {"worst_cases", r.worst_cases}});
  for (const Confusion& c : confusions(audit)) json["confusion"].push_back({{"id", c.id}, {"named", c.named}, {"seeds", c.seeds}});
  for (const auto& [name, members] : classes(audit)) json["classes"][name] = members;
  for (const AuditReading& r : audit.variants) json["right"].push_back({{"id", r.id}, {"lowest", r.lowest}});
  return json.dump(2) + "\n";
}

}  // namespace rigor::grader
