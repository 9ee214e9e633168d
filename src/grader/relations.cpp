#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <rigor/grader/relations.hpp>
#include <set>

namespace rigor::grader {
namespace {

using Case = std::vector<Component>;

bool close(double got, double want, double bound) { return std::fabs(got - want) <= bound; }

// Every case's components; empty where cases have different ones, or a number is not finite.
std::vector<Case> table(const Check& check, const std::vector<Record>& records) {
  std::vector<Case> cases;
  for (const Record& r : records) {
    cases.push_back(check.judge(r.inputs, r.replies, false).components);
    if (cases.back().empty() || cases.back().size() != cases.front().size()) return {};
    for (const Component& c : cases.back())
      if (!std::isfinite(c.got)) return {};
  }
  return cases;
}

template <class Holds>
bool everywhere(const std::vector<Case>& cases, Holds holds) {
  return std::all_of(cases.begin(), cases.end(), holds);
}

// What a function that does nothing to its bodies would have given; empty where that has other components.
std::vector<Case> idle_table(const Check& check, const std::vector<Record>& records, const std::vector<Case>& cases) {
  std::vector<Case> all;
  for (const Record& record : records) {
    std::vector<Reply> idle;
    for (const Call& call : check.calls(record.inputs)) {
      Reply r{};
      r.A = call.request.A, r.B = call.request.B;
      idle.push_back(r);
    }
    all.push_back(check.judge(record.inputs, idle, false).components);
    if (all.back().size() != cases[all.size() - 1].size()) return {};
  }
  return all;
}

// As if the student's function did nothing, where that is not right anyway.
bool unchanged(const std::vector<Case>& idle, const std::vector<Case>& cases) {
  bool wrong = false;
  for (std::size_t i = 0; i < idle.size(); ++i) {
    const Case& nothing = idle[i];
    for (std::size_t k = 0; k < nothing.size(); ++k) {
      if (!close(cases[i][k].got, nothing[k].got, nothing[k].bound)) return false;
      wrong = wrong || !close(nothing[k].got, nothing[k].want, nothing[k].bound);
    }
  }
  return wrong;
}

// got = factor * want throughout; NaN when there is no such factor.
double common_factor(const std::vector<Case>& cases) {
  double gw = 0, ww = 0;
  for (const Case& one : cases)
    for (const Component& c : one) gw += c.got * c.want / (c.bound * c.bound), ww += c.want * c.want / (c.bound * c.bound);
  const double factor = gw / ww;
  const bool holds = everywhere(cases, [&](const Case& one) {
    return std::all_of(one.begin(), one.end(), [&](const Component& c) { return close(c.got, factor * c.want, c.bound * std::fmax(1, std::fabs(factor))); });
  });
  return holds ? factor : NAN;
}

// "net force" of "net force, y", "dR/dt" of "dR/dt (1,2)".
std::string stem(const Component& c) {
  std::string name = c.name.substr(0, c.name.find_last_of(c.name.ends_with(')') ? '(' : ','));
  if (name.ends_with(' ')) name.pop_back();
  return name;
}

// "the result is 0.3 times the right one, always"
std::string in_words(const std::string& what, double factor) {
  char text[96];
  if (std::fabs(factor) < 1e-6) return what + " is always zero";
  if (std::fabs(factor + 1) < 1e-4) return what + " has the opposite sign, always";
  std::snprintf(text, sizeof text, std::fabs(factor - 1) < 1e-3 ? " is %.8g times the right one, always" : " is %.4g times the right one, always", factor);
  return what + text;
}

// Some quantities of the answer right on every case, each of the others by a factor of its own.
std::string factor_of_a_part(const std::vector<Case>& cases) {
  std::map<std::string, std::vector<Case>> parts;
  for (const Case& one : cases) {
    std::map<std::string, Case> split;
    for (const Component& c : one) split[stem(c)].push_back(c);
    for (auto& [name, components] : split) parts[name].push_back(std::move(components));
  }
  std::string words;
  bool some_right = false;
  for (const auto& [name, part] : parts) {
    const bool right = everywhere(part, [](const Case& one) { return std::all_of(one.begin(), one.end(), [](const Component& c) { return close(c.got, c.want, c.bound); }); });
    some_right = some_right || right;
    if (right) continue;
    const double factor = common_factor(part);
    if (!std::isfinite(factor)) return "";
    words += (words.empty() ? "" : "; ") + in_words(name, factor);
  }
  return some_right ? words : "";
}

// Got is want with its components at other places, `from[k]` within each group of `size` with one stem.
bool rearranged(const std::vector<Case>& cases, const std::vector<std::size_t>& from) {
  bool different = false;
  const std::size_t size = from.size();
  const bool holds = everywhere(cases, [&](const Case& one) {
    if (one.size() % size != 0) return false;
    for (std::size_t k = 0; k < one.size(); ++k) {
      const Component& there = one[k - k % size + from[k % size]];
      if (stem(there) != stem(one[k]) || !close(one[k].got, there.want, one[k].bound)) return false;
      different = different || !close(one[k].want, there.want, 20 * one[k].bound);
    }
    return true;
  });
  return holds && different;
}

std::string exchanged(const std::vector<Case>& cases) {
  if (rearranged(cases, {0, 3, 6, 1, 4, 7, 2, 5, 8})) return "the result is transposed, always";
  const std::pair<std::vector<std::size_t>, const char*> ways[] = {{{1, 0, 2}, "x and y are exchanged"}, {{2, 1, 0}, "x and z are exchanged"}, {{0, 2, 1}, "y and z are exchanged"},
                                                                   {{1, 2, 0}, "y, z, x stand in place of x, y, z"}, {{2, 0, 1}, "z, x, y stand in place of x, y, z"}};
  for (const auto& [from, words] : ways)
    if (rearranged(cases, from)) return "in the result " + std::string(words) + ", always";
  return "";
}

std::string shifted(const std::vector<Case>& cases) {
  if (cases.size() < 3) return "";
  std::string which;
  for (std::size_t k = 0; k < cases.front().size(); ++k) {
    const Component& first = cases.front()[k];
    const double by = first.got - first.want;
    if (!everywhere(cases, [&](const Case& one) { return close(one[k].got, one[k].want + by, 2 * one[k].bound); })) return "";
    if (close(by, 0, 20 * first.bound)) continue;
    // an answer that is the same on every case (saturated, say) differs from the right one by no constant
    const bool varies = std::any_of(cases.begin(), cases.end(), [&](const Case& one) { return !close(one[k].got, first.got, 20 * first.bound); });
    if (!varies) return "";
    char text[160];
    std::snprintf(text, sizeof text, "%s%s by %.4g %s", which.empty() ? "" : ", ", first.name.c_str(), by, first.unit.c_str());
    which += text;
  }
  return which.empty() ? "" : "the result is off by a constant, always: " + which;
}

// Wrong in components of one axis only, which come in triples "..., x" "..., y" "..., z".
std::string one_axis(const std::vector<Case>& idle, const std::vector<Case>& cases) {
  std::set<char> wrong;
  bool reversed = true, change_reversed = !idle.empty();
  for (std::size_t i = 0; i < cases.size(); ++i)
    for (std::size_t k = 0; k < cases[i].size(); ++k) {
      const Component& c = cases[i][k];
      const bool vector = c.name.size() > 3 && c.name.compare(c.name.size() - 3, 2, ", ") == 0;
      if (close(c.got, c.want, c.bound)) continue;
      if (!vector) return "";
      wrong.insert(c.name.back());
      reversed = reversed && close(c.got, -c.want, c.bound);
      change_reversed = change_reversed && close(c.got - idle[i][k].got, idle[i][k].got - c.want, c.bound);
    }
  if (wrong.size() != 1) return "";
  const std::string axis(1, *wrong.begin());
  if (reversed || change_reversed) return std::string(reversed ? "the " : "what is added to the ") + axis + " component has the opposite sign, always";
  return "only the " + axis + " component is wrong, always";
}

// What a limit is taken of, and how far one step moves it.
struct Quantity {
  const char *limit, *name;
  double (*size)(const BodyRecord&);
  double (*distance)(const BodyRecord&, const BodyRecord&);
};
double apart(const double* a, const double* b, int n) {
  double sum = 0;
  for (int i = 0; i < n; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}
constexpr double nothing[9] = {};
const Quantity quantities[] = {
    {"dv/dt", "velocity", [](const BodyRecord& b) { return apart(b.velocity, nothing, 3); }, [](const BodyRecord& a, const BodyRecord& b) { return apart(a.velocity, b.velocity, 3); }},
    {"dx/dt", "position", [](const BodyRecord& b) { return apart(b.position, nothing, 3); }, [](const BodyRecord& a, const BodyRecord& b) { return apart(a.position, b.position, 3); }},
    {"dw/dt", "angular velocity", [](const BodyRecord& b) { return apart(b.spin, nothing, 3); }, [](const BodyRecord& a, const BodyRecord& b) { return apart(a.spin, b.spin, 3); }},
    {"dR/dt", "rotation", [](const BodyRecord& b) { return apart(b.rotation, nothing, 9); }, [](const BodyRecord& a, const BodyRecord& b) { return apart(a.rotation, b.rotation, 9); }},
};

// The quantities whose limit a check looks at, asked for with steps h, h/2, h/4; none for other checks.
std::vector<Quantity> limits_of(const Check& check, const std::vector<Record>& records, const std::vector<Case>& cases) {
  std::vector<Quantity> list;
  if (check.function != StudentFunction::update || records.front().replies.size() != 3) return list;
  for (const Quantity& q : quantities)
    if (std::any_of(cases.front().begin(), cases.front().end(), [&](const Component& c) { return stem(c) == q.limit; })) list.push_back(q);
  return list;
}

// The change of one step goes with dt to this power, on every case.
bool goes_with(int power, const Quantity& q, const std::vector<Record>& records, double tolerance) {
  return std::all_of(records.begin(), records.end(), [&](const Record& r) {
    const BodyRecord before = record(r.inputs.A);
    const double a = q.distance(r.replies[0].A, before), b = q.distance(r.replies[1].A, before), c = q.distance(r.replies[2].A, before);
    return b > 1e-12 && c > 1e-12 && std::fabs(std::log2(a / b) - power) < tolerance && std::fabs(std::log2(b / c) - power) < tolerance;
  });
}
bool stays(const Quantity& q, const std::vector<Record>& records) {
  return std::all_of(records.begin(), records.end(), [&](const Record& r) {
    return std::all_of(r.replies.begin(), r.replies.end(), [&](const Reply& reply) { return q.distance(reply.A, record(r.inputs.A)) <= 1e-12; });
  });
}
// A change can be told from the answer only where the answer still shows what was there before: not where it is zero, the
// same whatever is given, or so large that what was there is lost in it.
bool tells_a_change(const Quantity& q, const std::vector<Record>& records) {
  const BodyRecord first = records.front().replies[0].A;
  bool varies = false;
  for (const Record& r : records) {
    const BodyRecord after = r.replies[0].A;
    if (!(q.size(after) > 0) || !(q.size(after) <= 1e6 * (1 + q.size(record(r.inputs.A))))) return false;
    varies = varies || q.distance(after, first) > 1e-3 * q.size(first);
  }
  return varies;
}

// What of an answer goes with another power of dt than the first.
std::string power_of_dt(const std::vector<Quantity>& limits, const std::vector<Record>& records) {
  std::string words;
  for (const auto& [power, says] : {std::pair{0, " changes by the same whatever dt is"}, {2, " changes with dt squared: wrong by the order of dt"}})
    for (const Quantity& q : limits)
      if (goes_with(power, q, records, 0.05) && tells_a_change(q, records)) words += (words.empty() ? "in one step the " : "; the ") + std::string(q.name) + says;
  return words;
}

}  // namespace

std::string relation(const Check& check, const std::vector<Record>& records) {
  const std::vector<Case> cases = table(check, records);
  if (cases.empty()) return "";
  const std::vector<Quantity> limits = limits_of(check, records, cases);
  if (const std::string words = power_of_dt(limits, records); !words.empty()) return words;
  // a number extrapolated from steps says nothing where the change does not go with dt
  for (const Quantity& q : limits)
    if (!goes_with(1, q, records, 0.2) && !stays(q, records)) return "";
  const std::vector<Case> idle = idle_table(check, records, cases);
  if (unchanged(idle, cases)) return "the result is the unchanged input, always";
  if (const double factor = common_factor(cases); std::isfinite(factor)) return in_words("the result", factor);
  for (const std::string& words : {exchanged(cases), shifted(cases), one_axis(idle, cases), factor_of_a_part(cases)})
    if (!words.empty()) return words;
  return "";
}

}  // namespace rigor::grader
