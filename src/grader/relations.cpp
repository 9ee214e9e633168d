#include <algorithm>
#include <array>
#include <cmath>
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

// As if the student's function did nothing to its bodies, where that is not right anyway.
bool unchanged(const Check& check, const std::vector<Record>& records, const std::vector<Case>& cases) {
  bool wrong = false;
  for (std::size_t i = 0; i < records.size(); ++i) {
    std::vector<Reply> idle;
    for (const Call& call : check.calls(records[i].inputs)) {
      Reply r{};
      r.A = call.request.A, r.B = call.request.B;
      idle.push_back(r);
    }
    const Case nothing = check.judge(records[i].inputs, idle, false).components;
    if (nothing.size() != cases[i].size()) return false;
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
std::string stem(const Component& c) { return c.name.substr(0, c.name.find_last_of(c.name.ends_with(')') ? '(' : ',')); }

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
    char text[160];
    std::snprintf(text, sizeof text, "%s%s by %.4g %s", which.empty() ? "" : ", ", first.name.c_str(), by, first.unit.c_str());
    which += text;
  }
  return which.empty() ? "" : "the result is off by a constant, always: " + which;
}

// Wrong in components of one axis only, which come in triples "..., x" "..., y" "..., z".
std::string one_axis(const std::vector<Case>& cases) {
  std::set<char> wrong;
  for (const Case& one : cases)
    for (const Component& c : one) {
      const bool vector = c.name.size() > 3 && c.name.compare(c.name.size() - 3, 2, ", ") == 0;
      if (close(c.got, c.want, c.bound)) continue;
      if (!vector) return "";
      wrong.insert(c.name.back());
    }
  if (wrong.size() != 1) return "";
  return std::string("only the ") + *wrong.begin() + " component is wrong, always";
}

// update() is asked with h, h/2, h/4: the change of one step must go with h.
std::string power_of_dt(const Check& check, const std::vector<Record>& records) {
  if (check.function != StudentFunction::update || records.empty() || records.front().replies.size() != 3) return "";
  const auto change = [&](const Record& r, std::size_t k, int what) {
    const BodyRecord before = record(r.inputs.A), after = r.replies[k].A;
    double sum = 0;
    const auto add = [&](const double* a, const double* b, int n) {
      for (int i = 0; i < n; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    };
    if (what == 0) add(after.velocity, before.velocity, 3);
    if (what == 1) add(after.position, before.position, 3);
    if (what == 2) add(after.spin, before.spin, 3);
    if (what == 3) add(after.rotation, before.rotation, 9);
    return std::sqrt(sum);
  };
  static const char* const names[] = {"velocity", "position", "angular velocity", "rotation"};
  for (int what = 0; what < 4; ++what)
    for (const int power : {0, 2}) {
      const bool holds = std::all_of(records.begin(), records.end(), [&](const Record& r) {
        if (r.replies.size() != 3) return false;
        const double a = change(r, 0, what), b = change(r, 1, what), c = change(r, 2, what);
        return b > 1e-12 && c > 1e-12 && std::fabs(std::log2(a / b) - power) < 0.05 && std::fabs(std::log2(b / c) - power) < 0.05;
      });
      if (holds)
        return std::string("in one step the ") + names[what] + (power == 0 ? " changes by the same whatever dt is: dt is missing" : " changes with dt squared: wrong by the order of dt");
    }
  return "";
}

}  // namespace

std::string relation(const Check& check, const std::vector<Record>& records) {
  const std::vector<Case> cases = table(check, records);
  if (cases.empty()) return "";
  if (unchanged(check, records, cases)) return "the result is the unchanged input, always";
  if (const double factor = common_factor(cases); std::isfinite(factor)) {
    char text[96];
    if (std::fabs(factor) < 1e-6) return "the result is always zero";
    if (std::fabs(factor + 1) < 1e-4) return "the result has the opposite sign, always";
    std::snprintf(text, sizeof text, std::fabs(factor - 1) < 1e-3 ? "the result is %.8g times the right one, always" : "the result is %.4g times the right one, always", factor);
    return text;
  }
  for (const std::string& words : {exchanged(cases), shifted(cases), one_axis(cases), power_of_dt(check, records)})
    if (!words.empty()) return words;
  return "";
}

}  // namespace rigor::grader
