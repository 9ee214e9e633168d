#include <toml++/toml.h>

#include <algorithm>
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

// The same of whole numbers.
Outcome<bool> take_whole(const toml::node& node, const std::string& where, double low, double high, double& value) {
  if (const auto taken = take(node, where, low, high, value); !taken) return taken;
  if (value != std::floor(value)) return Fault{Kind::out_of_range, where, "is " + number_text(value) + ", must be a whole number"};
  return true;
}

// "; did you mean 'seed'?"
std::string suggestion(const std::string& key, const std::vector<std::string>& known) {
  const std::string meant = did_you_mean(key, known);
  return meant.empty() ? "" : "; " + meant.substr(2, meant.size() - 3);
}

Fault unknown(const std::string& where, const std::string& key, const std::vector<std::string>& known) {
  return {Kind::unknown_key, where + key, "is no key of a rubric" + suggestion(key, known)};
}
Fault unknown_check(const std::string& where, const std::string& id, const std::vector<std::string>& known) {
  return {Kind::unknown_key, where, "there is no check '" + id + "'" + suggestion(id, known)};
}

Outcome<bool> read_limits(const toml::table& table, const std::string& where, Limits& limits) {
  double memory_mb = double(limits.memory_bytes >> 20);
  for (const auto& [key, node] : table) {
    const std::string name(key.str());
    Outcome<bool> ok = name == "call_seconds"    ? take(node, where + "." + name, 0.01, 600, limits.call_s)
                       : name == "total_seconds" ? take(node, where + "." + name, 1, 3600, limits.total_s)
                       : name == "memory_mb"     ? take(node, where + "." + name, 64, 65536, memory_mb)
                                                 : Outcome<bool>(unknown(where + ".", name, {"call_seconds", "total_seconds", "memory_mb"}));
    if (!ok) return ok;
  }
  limits.memory_bytes = std::uint64_t(memory_mb) << 20;
  return true;
}

std::vector<std::string> check_ids() {
  std::vector<std::string> ids;
  for (const Check& check : checks()) ids.push_back(check.id);
  return ids;
}

// A table with a value for each check it names; `read` takes one.
template <class Read>
Outcome<bool> read_by_check(const toml::node& node, const std::string& where, Read read) {
  if (!node.is_table()) return Fault{Kind::wrong_type, where, "must be a table: a line for each check"};
  for (const auto& [key, value] : *node.as_table()) {
    const std::string id(key.str());
    if (find_check(id) == nullptr) return unknown_check(where + ".\"" + id + "\"", id, check_ids());
    if (const Outcome<bool> ok = read(value, where + ".\"" + id + "\"", id); !ok) return ok;
  }
  return true;
}

Outcome<bool> read_visibility(const toml::node& node, const std::string& where, Visibility& visibility) {
  const auto text = node.value<std::string>();
  for (const Visibility v : {Visibility::visible, Visibility::hidden, Visibility::after_due_date, Visibility::after_published})
    if (text && *text == name(v)) {
      visibility = v;
      return true;
    }
  return Fault{Kind::out_of_range, where, "must be \"visible\", \"hidden\", \"after_due_date\" or \"after_published\""};
}

// "Collision" = ["plane.impulse", ...]: every check at most once, no empty heading, names that every platform takes.
Outcome<bool> read_groups(const toml::node& node, const std::string& where, Rubric& rubric) {
  if (!node.is_table()) return Fault{Kind::wrong_type, where, "must be a table: [groups]"};
  std::map<std::size_t, std::string> order;  // TOML tables are sorted by name: the file's order is that of the lines
  for (const auto& [key, list] : *node.as_table()) {
    const std::string group(key.str()), at = where + ".\"" + group + "\"";
    if (group.empty() || group.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789 _-") != std::string::npos)
      return Fault{Kind::out_of_range, at, "must be of letters, digits, blanks, _ and - (Autolab takes no others)"};
    if (!list.is_array() || list.as_array()->empty()) return Fault{Kind::wrong_type, at, "must be a list of at least one check id"};
    for (const toml::node& item : *list.as_array()) {
      const auto id = item.value<std::string>();
      if (!id) return Fault{Kind::wrong_type, at, "must be a list of check ids in quotes"};
      if (find_check(*id) == nullptr) return unknown_check(at, *id, check_ids());
      if (!rubric.groups.emplace(*id, group).second) return Fault{Kind::out_of_range, at, "'" + *id + "' is in '" + rubric.groups[*id] + "' already"};
    }
    order[(std::size_t(key.source().begin.line) << 16) + key.source().begin.column] = group;
  }
  for (const auto& [line, group] : order) rubric.group_order.push_back(group);
  return true;
}

Outcome<bool> read_refused(const toml::node& node, const std::string& where, std::set<std::string>& refused) {
  if (!node.is_array()) return Fault{Kind::wrong_type, where, "must be a list of readings"};
  for (const toml::node& item : *node.as_array()) {
    const auto id = item.value<std::string>();
    const auto& known = refusable_readings();
    if (!id || std::find(known.begin(), known.end(), *id) == known.end())
      return Fault{Kind::unknown_key, where, "must be readings a check can tell: friction-literal, friction-effective-mass, tangent-against-slip"};
    refused.insert(*id);
  }
  return true;
}

Outcome<bool> read_practised(const toml::node& node, const std::string& where, std::set<std::string>& practised) {
  if (!node.is_array() || node.as_array()->empty()) return Fault{Kind::wrong_type, where, "must be a list of at least one check id"};
  for (const toml::node& item : *node.as_array()) {
    const auto id = item.value<std::string>();
    if (!id) return Fault{Kind::wrong_type, where, "must be a list of check ids in quotes"};
    if (find_check(*id) == nullptr) return unknown_check(where, *id, check_ids());
    practised.insert(*id);
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
      return Fault{Kind::unknown_key, where, "there is no misconception '" + *id + "'" + suggestion(*id, ids)};
    const bool reading = std::any_of(variants().begin(), variants().end(), [&](const Misconception& v) { return v.id == *id; });
    if (reading) return Fault{Kind::out_of_range, where, "'" + *id + "' is a reading that counts as right without it; refuse = [...] takes one away"};
    accepted.insert(found->same_as.empty() ? *id : found->same_as);
  }
  return true;
}

// "FILE:LINE: KEY:", where a key inside the table says its own line.
Fault placed(Fault fault, const std::string& file, const toml::node& node, const toml::key& key) {
  auto line = key.source().begin.line;
  const std::string path = fault.where.substr(file.size() + 2);
  if (const toml::table* table = node.as_table())
    for (const auto& [inner, value] : *table)
      if (path.ends_with("." + std::string(inner.str())) || path.ends_with("\"" + std::string(inner.str()) + "\"")) line = inner.source().begin.line;
  fault.where = file + ":" + std::to_string(line) + ": " + path + ":";
  return fault;
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
      ok = take_whole(node, where, 0, 9007199254740992.0, number);
      rubric.seed = std::uint64_t(number);
    } else if (name == "practice_seed") {
      ok = take_whole(node, where, 0, 9007199254740992.0, number);
      rubric.practice_seed = std::uint64_t(number);
    } else if (name == "cases") {
      ok = take_whole(node, where, 1, 100000, number);
      rubric.cases = int(number);
    } else if (name == "tolerance") {
      ok = take(node, where, 0.01, 1000, rubric.tolerance);
    } else if (name == "limits") {
      if (!node.is_table()) ok = Fault{Kind::wrong_type, where, "must be a table: [limits]"};
      else ok = read_limits(*node.as_table(), where, rubric.limits);
    } else if (name == "points") {
      ok = read_by_check(node, where, [&](const toml::node& value, const std::string& at, const std::string& id) { return take(value, at, 0, 1e6, rubric.points[id]); });
    } else if (name == "tolerances") {
      ok = read_by_check(node, where, [&](const toml::node& value, const std::string& at, const std::string& id) { return take(value, at, 0.01, 1000, rubric.tolerances[id]); });
    } else if (name == "case_counts") {
      ok = read_by_check(node, where, [&](const toml::node& value, const std::string& at, const std::string& id) {
        double count = 0;
        const int most = find_check(id)->cases;
        const auto taken = take_whole(value, at, 1, most != 0 ? most : 100000, count);
        rubric.case_counts[id] = int(count);
        return taken;
      });
    } else if (name == "visibility") {
      ok = read_by_check(node, where, [&](const toml::node& value, const std::string& at, const std::string& id) { return read_visibility(value, at, rubric.visibilities[id]); });
    } else if (name == "groups") {
      ok = read_groups(node, where, rubric);
    } else if (name == "accept") {
      ok = read_accepted(node, where, rubric.accepted);
    } else if (name == "refuse") {
      ok = read_refused(node, where, rubric.refused);
    } else if (name == "practice") {
      ok = read_practised(node, where, rubric.practised);
    } else {
      ok = unknown(file + ": ", name, {"title", "seed", "practice_seed", "cases", "tolerance", "accept", "refuse", "practice", "limits", "groups", "points", "tolerances", "case_counts", "visibility"});
    }
    if (!ok) return placed(ok.fault(), file, node, key);
  }
  if (rubric.seed == rubric.practice_seed) {
    if (root.contains("practice_seed"))
      return placed({Kind::out_of_range, file + ": practice_seed", "is the seed of the graded cases, must be another"}, file, *root.get("practice_seed"), root.find("practice_seed")->first);
    ++rubric.practice_seed;
  }
  if (!(rubric.total_points() > 0)) return placed({Kind::out_of_range, file + ": points", "add up to 0, must be > 0"}, file, *root.get("points"), root.find("points")->first);
  return rubric;
}

}  // namespace

const char* name(Visibility visibility) {
  switch (visibility) {
    case Visibility::visible: return "visible";
    case Visibility::hidden: return "hidden";
    case Visibility::after_due_date: return "after_due_date";
    case Visibility::after_published: return "after_published";
  }
  return "";
}

double Rubric::total_points() const {
  double total = 0;
  for (const Check& check : checks()) total += points_of(check);
  return total;
}

std::vector<std::string> warnings(const Rubric& rubric, bool secret_seed) {
  std::vector<std::string> all;
  const std::string file = rubric.path.empty() ? "the default rubric" : rubric.path;
  if (std::fabs(rubric.total_points() - 100) > 1e-9) all.push_back(file + ": the points add up to " + number_text(rubric.total_points()) + ", not 100");
  if (secret_seed && rubric.seed == Rubric{}.seed)
    all.push_back(file + ": seed is " + std::to_string(rubric.seed) + ", the public default,\n  with which everybody can draw the graded cases;\n  set one of your own: seed = NUMBER in the file of --rubric");
  return all;
}

std::vector<std::string> Rubric::group_names() const {
  std::vector<std::string> names = group_order;
  for (const Check& check : checks())
    if (points_of(check) > 0 && std::find(names.begin(), names.end(), group_of(check)) == names.end()) names.push_back(group_of(check));
  return names;
}

std::string Rubric::hash() const {
  std::ostringstream all;
  all.precision(17);
  all << seed << ' ' << cases << ' ' << tolerance << ' ' << limits.call_s << ' ' << limits.total_s << ' ' << limits.memory_bytes << ' ' << limits.output_bytes;
  for (const Check& check : checks())
    all << ' ' << check.id << '=' << points_of(check) << '/' << tolerance_of(check) << '/' << cases_of(check) << '/' << name(visibility_of(check)) << '/' << group_of(check);
  for (const std::string& id : accepted) all << " +" << id;
  for (const std::string& id : refused) all << " -" << id;
  std::uint64_t hash = 14695981039346656037u;  // FNV-1a: names a rubric, guards against nothing
  for (const char c : all.str()) hash = (hash ^ std::uint8_t(c)) * 1099511628211u;
  std::ostringstream hex;
  hex << std::hex << hash;
  return hex.str();
}

Outcome<Rubric> parse_rubric(const std::string& text, const std::string& name) {
  try {
    auto rubric = from_table(toml::parse(text, name), name);
    if (!rubric) return rubric;
    Rubric read = std::move(rubric).value();
    read.path = name;
    return read;
  } catch (const toml::parse_error& error) {
    std::ostringstream where;
    where << name << ":" << error.source().begin.line << ":";
    return Fault{Kind::malformed, where.str(), std::string(error.description())};
  }
}

Outcome<Rubric> read_rubric(const std::filesystem::path& path) {
  const auto text = read_file(path, 1u << 20);
  if (!text) return text.fault();
  return parse_rubric(*text, path.string());
}

}  // namespace rigor::grader
