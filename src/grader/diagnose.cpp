#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <rigor/grader/diagnose.hpp>
#include <rigor/grader/misconceptions.hpp>
#include <rigor/grader/relations.hpp>

namespace rigor::grader {
namespace {

// Same numbers on one case: every component within its bound of the model's.
bool agrees(const Check& check, const Record& record, const Habits& habits) {
  std::vector<Reply> model;
  for (const Call& call : check.calls(record.inputs)) model.push_back(model_answer(habits, call.constants, call.request));
  const Judgement got = check.judge(record.inputs, record.replies, false), theirs = check.judge(record.inputs, model, false);
  if (got.components.size() != theirs.components.size()) return false;
  for (std::size_t i = 0; i < got.components.size(); ++i) {
    const double a = got.components[i].got, b = theirs.components[i].got;
    if (a != b && !(std::fabs(a - b) <= got.components[i].bound)) return false;
  }
  return true;
}

// Not where the numbers depend on what is left to the student: the scheme (order, error), the order of corners, and
// whatever is only advice.
bool comparable(const Check& check) {
  return check.points > 0 && check.id != "update.convergence" && check.id != "scene.runs" && check.id != "plane.energy";
}

using Group = std::vector<History*>;

bool explains(const Group& group, const Habits& habits, bool everything = false) {
  return std::all_of(group.begin(), group.end(), [&](const History* h) {
    const Check& check = *h->result->check;
    return !(comparable(check) || (everything && check.points > 0)) || std::all_of(h->records.begin(), h->records.end(), [&](const Record& r) {
      return agrees(check, r, habits);
    });
  });
}
int cases_of(const Group& group) {
  int sum = 0;
  for (const History* h : group) sum += comparable(*h->result->check) ? int(h->records.size()) : 0;
  return sum;
}
bool failed(const History& h) { return h.result->verdict == Verdict::fail && h.result->diagnosis.empty(); }

// Within the derived bounds on every case: it fails by a tolerance below what a float keeps, and no mistake explains that.
bool only_rounds(const History& h) {
  return std::all_of(h.records.begin(), h.records.end(), [&](const Record& r) { return h.result->check->judge(r.inputs, r.replies, false).ratio() <= 1; });
}

// Legitimate readings that change numbers of this function, to be tried together with each mistake.
std::vector<std::string> readings(StudentFunction f) {
  if (f == StudentFunction::plane_response)
    return {"", "friction-effective-mass", "friction-literal", "friction-before", "no-approach-test", "correction-each-corner"};
  if (f == StudentFunction::friction_tangent) return {"", "tangent-against-slip"};
  if (f == StudentFunction::pair_response) return {"", "no-approach-test"};
  return {""};
}
std::string joined(const std::string& a, const std::string& b) { return a.empty() ? b : b.empty() ? a : a + "+" + b; }

// Two mistakes that are one function of every input seen (both signs reversed, say) are one explanation.
bool same_on(const Group& group, const std::string& a, const std::string& b) {
  const Habits one = habits_with(a), two = habits_with(b);
  for (const History* h : group)
    for (const Record& r : h->records) {
      if (!comparable(*h->result->check)) break;
      Record as_one{r.inputs, {}};
      for (const Call& call : h->result->check->calls(r.inputs)) as_one.replies.push_back(model_answer(one, call.constants, call.request));
      if (!agrees(*h->result->check, as_one, two)) return false;
    }
  return true;
}

// The explanations of a function's numbers, each id once whatever the reading; pairs only when no single mistake fits.
std::vector<std::string> explanations(StudentFunction f, const Group& group, const std::string& upstream) {
  std::vector<std::string> found;
  const auto attempt = [&](const std::string& ids) {
    for (const std::string& reading : readings(f))
      if (explains(group, habits_with(joined(joined(upstream, reading), ids)))) return found.push_back(ids), true;
    return false;
  };
  std::vector<std::string> own;
  for (const Misconception& m : misconceptions())
    if (m.function == f && m.same_as.empty()) own.push_back(m.id);
  for (const std::string& id : own) attempt(id);
  if (!found.empty()) return found;
  for (std::size_t i = 0; i < own.size(); ++i)
    for (std::size_t k = i + 1; k < own.size(); ++k) attempt(own[i] + "+" + own[k]);
  return found;
}

std::string sentence(const std::string& ids) {
  std::string text;
  for (std::size_t start = 0; start < ids.size();) {
    const std::size_t end = std::min(ids.find('+', start), ids.size());
    if (start > 0) text += "; and ";
    text += find_misconception(ids.substr(start, end - start))->text;
    start = end + 1;
  }
  return text;
}

void add_relation(History& h) {
  if (h.records.empty() || !comparable(*h.result->check)) return;
  const std::string words = relation(*h.result->check, h.records);
  const int n = int(h.records.size());
  if (!words.empty()) h.result->diagnosis.push_back({"relation", words, n, n});
}

}  // namespace

void diagnose(std::vector<History>& histories) {
  std::map<StudentFunction, Group> groups;
  for (History& h : histories) groups[h.result->check->function].push_back(&h);

  std::string upstream;  // mistakes found in functions that later ones call
  for (auto& entry : groups) {  // in the order of the assignment: helpers first
    const StudentFunction function = entry.first;
    Group& group = entry.second;  // no structured binding: clang 14 cannot capture one
    for (History* h : group)
      if (failed(*h) && only_rounds(*h)) {
        char words[80];
        std::snprintf(words, sizeof words, "right but for rounding: %.2g times the allowed error", h->result->worst_ratio);
        h->result->diagnosis.push_back({"relation", words, int(h->records.size()), int(h->records.size())});
      }
    if (std::none_of(group.begin(), group.end(), [](const History* h) { return failed(*h); })) continue;

    // right given the mistakes found in what it calls?
    if (!upstream.empty())
      for (History* h : group)
        if (failed(*h) && comparable(*h->result->check) && explains({h}, habits_with(upstream))) {
          h->result->verdict = Verdict::pass;
          h->result->points = h->result->max_points;
          h->result->notes.push_back("follows from " + upstream);
          h->result->counterexample.reset();
        }
    if (std::none_of(group.begin(), group.end(), [](const History* h) { return failed(*h); })) continue;

    std::vector<std::string> found = explanations(function, group, "");
    if (found.empty() && !upstream.empty()) found = explanations(function, group, upstream);
    // Some differ only in what a limit cannot see (not moving, or moving by dt squared): then the scheme-dependent
    // numbers decide, where they fit a model student's.
    if (found.size() > 1) {
      std::vector<std::string> exact;
      for (const std::string& ids : found)
        if (explains(group, habits_with(joined(upstream, ids)), true)) exact.push_back(ids);
      if (!exact.empty()) found = exact;
    }
    const bool one = !found.empty() && std::all_of(found.begin() + 1, found.end(), [&](const std::string& other) {
      return same_on(group, found.front(), other);
    });
    for (History* h : group) {
      if (!failed(*h)) continue;
      if (one) h->result->diagnosis.push_back({found.front(), sentence(found.front()), cases_of(group), cases_of(group)});
      else add_relation(*h);
    }
    if (one) upstream = joined(upstream, found.front());
  }
}

}  // namespace rigor::grader
