#include <toml++/toml.h>

#include <cmath>
#include <rigor/base/file.hpp>
#include <rigor/base/suggest.hpp>
#include <rigor/grader/misconceptions.hpp>
#include <rigor/grader/rubric.hpp>
#include <sstream>

namespace rigor::grader {
namespace {

using Kind = Fault::Kind;

std::string number_text(double x) {
  std::ostringstream out;
  out << x;
  return out.str();
}

// Reads one number of a table into `value`; the range is said when it does not fit.
Outcome<bool> take(const toml::node& node, const std::string& where, double low, double high, double& value) {
  const auto number = node.value<double>();
  if (!number || (!node.is_integer() && !node.is_floating_point())) return Fault{Kind::wrong_type, where, "must be a number"};
  if (!std::isfinite(*number) || *number < low || *number > high)
    return Fault{Kind::out_of_range, where, "is " + number_text(*number) + ", must be in [" + number_text(low) + ", " + number_text(high) + "]"};
  value = *number;
  return true;
}

Fault unknown(const std::string& where, const std::string& key, const std::vector<std::string>& known) {
  return {Kind::unknown_key, where, "unknown key '" + key + "'" + did_you_mean(key, known)};
}

Outcome<bool> read_limits(const toml::table& table, const std::string& where, Limits& limits) {
  double memory_mb = double(limits.memory_bytes >> 20);
  for (const auto& [key, node] : table) {
    const std::string name(key.str());
    Outcome<bool> ok = name == "call_seconds"    ? take(node, where + "." + name, 0.01, 600, limits.call_s)
                       : name == "total_seconds" ? take(node, where + "." + name, 1, 3600, limits.total_s)
                       : name == "memory_mb"     ? take(node, where + "." + name, 64, 65536, memory_mb)
                                                 : Outcome<bool>(unknown(where, name, {"call_seconds", "total_seconds", "memory_mb"}));
    if (!ok) return ok;
  }
  limits.memory_bytes = std::uint64_t(memory_mb) << 20;
  return true;
}

Outcome<bool> read_points(const toml::table& table, const std::string& where, std::map<std::string, double>& points) {
  std::vector<std::string> ids;
  for (const Check& check : checks()) ids.push_back(check.id);
  for (const auto& [key, node] : table) {
    const std::string id(key.str());
    if (find_check(id) == nullptr) return unknown(where, id, ids);
    if (const auto ok = take(node, where + ".\"" + id + "\"", 0, 1e6, points[id]); !ok) return ok;
  }
  return true;
}

Outcome<bool> read_accepted(const toml::node& node, const std::string& where, std::set<std::string>& accepted) {
  if (!node.is_array()) return Fault{Kind::wrong_type, where, "must be a list of misconception ids"};
  std::vector<std::string> ids;
  for (const Misconception& row : misconceptions()) ids.push_back(row.id);
  for (const toml::node& item : *node.as_array()) {
    const auto id = item.value<std::string>();
    if (!id) return Fault{Kind::wrong_type, where, "must be a list of misconception ids in quotes"};
    const Misconception* found = find_misconception(*id);
    if (found == nullptr)
      return Fault{Kind::unknown_key, where, "there is no misconception '" + *id + "'" + did_you_mean(*id, ids)};
    accepted.insert(found->same_as.empty() ? *id : found->same_as);
  }
  return true;
}

Outcome<Rubric> from_table(const toml::table& root, const std::string& file) {
  Rubric rubric;
  for (const auto& [key, node] : root) {
    const std::string name(key.str()), where = file + ": " + name;
    double number = 0;
    Outcome<bool> ok = true;
    if (name == "title") {
      if (const auto text = node.value<std::string>()) rubric.title = *text;
      else ok = Fault{Kind::wrong_type, where, "must be a text in quotes"};
    } else if (name == "seed") {
      ok = take(node, where, 0, 9007199254740992.0, number);
      rubric.seed = std::uint64_t(number);
    } else if (name == "cases") {
      ok = take(node, where, 1, 100000, number);
      rubric.cases = int(number);
    } else if (name == "tolerance") {
      ok = take(node, where, 0.01, 1000, rubric.tolerance);
    } else if (name == "limits" || name == "points") {
      if (!node.is_table()) ok = Fault{Kind::wrong_type, where, "must be a table: [" + name + "]"};
      else ok = name == "limits" ? read_limits(*node.as_table(), where, rubric.limits) : read_points(*node.as_table(), where, rubric.points);
    } else if (name == "accept") {
      ok = read_accepted(node, where, rubric.accepted);
    } else {
      ok = unknown(file, name, {"title", "seed", "cases", "tolerance", "limits", "points", "accept"});
    }
    if (!ok) return ok.fault();
  }
  double total = 0;
  for (const Check& check : checks()) total += rubric.points_of(check);
  if (!(total > 0)) return Fault{Kind::out_of_range, file + ": points", "add up to 0, must be > 0"};
  return rubric;
}

}  // namespace

std::string Rubric::hash() const {
  std::ostringstream all;
  all.precision(17);
  all << seed << ' ' << cases << ' ' << tolerance << ' ' << limits.call_s << ' ' << limits.total_s << ' ' << limits.memory_bytes << ' ' << limits.output_bytes;
  for (const Check& check : checks()) all << ' ' << check.id << '=' << points_of(check);
  for (const std::string& id : accepted) all << " +" << id;
  std::uint64_t hash = 14695981039346656037u;  // FNV-1a: names a rubric, guards against nothing
  for (const char c : all.str()) hash = (hash ^ std::uint8_t(c)) * 1099511628211u;
  std::ostringstream hex;
  hex << std::hex << hash;
  return hex.str();
}

Outcome<Rubric> parse_rubric(const std::string& text, const std::string& name) {
  try {
    return from_table(toml::parse(text, name), name);
  } catch (const toml::parse_error& error) {
    std::ostringstream where;
    where << name << ": line " << error.source().begin.line;
    return Fault{Kind::malformed, where.str(), std::string(error.description())};
  }
}

Outcome<Rubric> read_rubric(const std::filesystem::path& path) {
  const auto text = read_file(path, 1u << 20);
  if (!text) return text.fault();
  return parse_rubric(*text, path.string());
}

std::string default_rubric_text() {
  const Rubric d;
  std::ostringstream out;
  out << "# The default rubric of rigor. Every key may be left out; these are the values then used.\n"
      << "title = \"" << d.title << "\"      # shown on the report\n"
      << "seed = " << d.seed << "            # of the graded cases: fix one per assignment and keep it to yourself\n"
      << "cases = " << d.cases << "                # random inputs per check; a check is all or nothing\n"
      << "tolerance = " << d.tolerance << "              # multiplies every bound (derivations: docs/grading.md)\n"
      << "accept = []                # misconceptions that count as right, for example [\"plane.printed-restitution\"]\n\n"
      << "[limits]                   # for the student's code\n"
      << "call_seconds = " << d.limits.call_s << "         # processor time of one call\n"
      << "total_seconds = " << d.limits.total_s << "         # of one process\n"
      << "memory_mb = " << (d.limits.memory_bytes >> 20) << "\n\n[points]\n";
  std::string group;
  for (const Check& check : checks()) {
    if (check.group != group) {
      double sum = 0;
      for (const Check& other : checks()) sum += other.group == check.group ? other.points : 0;
      out << "# " << (group = check.group) << ": " << sum << "\n";
    }
    out << "\"" << check.id << "\" = " << check.points << "  # " << check.says << "\n";
  }
  return out.str();
}

}  // namespace rigor::grader
