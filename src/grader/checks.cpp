#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <rigor/base/promise.hpp>
#include <rigor/grader/check.hpp>
#include <rigor/grader/misconceptions.hpp>
#include <tuple>

namespace rigor::grader {

double Judgement::ratio() const {
  double worst = 0;
  for (const Component& c : components) {
    const double r = c.got == c.want ? 0 : std::fabs(c.got - c.want) / c.bound;
    if (!(r <= worst)) worst = std::isnan(r) ? std::numeric_limits<double>::infinity() : r;
  }
  return worst;
}

const std::vector<Check>& checks() {
  static const std::vector<Check> all = [] {
    std::vector<Check> list;
    for (auto part : {inertia_checks, force_checks, update_checks, plane_checks, friction_checks, pair_checks, own_checks})
      for (Check& check : part()) list.push_back(std::move(check));
    return list;
  }();
  return all;
}

const Check* find_check(const std::string& id) {
  const auto& all = checks();
  const auto it = std::find_if(all.begin(), all.end(), [&](const Check& c) { return c.id == id; });
  return it == all.end() ? nullptr : &*it;
}

namespace {

double model_ratio(const Check& check, const Scenario& s, const Habits& habits) {
  std::vector<Reply> replies;
  for (const Call& call : check.calls(s)) replies.push_back(model_answer(habits, call.constants, call.request));
  return check.judge(s, replies, false).ratio();
}

// A hash that is the same on every platform, as std::hash need not be.
std::uint32_t fnv1a(const std::string& text) {
  std::uint32_t hash = 2166136261u;
  for (const char c : text) hash = (hash ^ std::uint8_t(c)) * 16777619u;
  return hash;
}

}  // namespace

bool usable(const Check& check, const Scenario& s) {
  return check.sound(s) && model_ratio(check, s, Habits{}) <= 0.5;
}

bool admitted(const Check& check, const Scenario& s) {
  if (!usable(check, s)) return false;
  return std::all_of(check.claims.begin(), check.claims.end(),
                     [&](const std::string& id) { return model_ratio(check, s, habits_with(id)) >= 20; });
}

namespace {

Scenario drawn(const Check& check, std::uint64_t seed, int number) {
  std::seed_seq mixed{std::uint32_t(seed), std::uint32_t(seed >> 32), std::uint32_t(number),
                      fnv1a(check.id)};
  Random random(mixed);
  for (int attempt = 0; attempt < 5000; ++attempt) {
    const Scenario s = check.draw(random, number);
    if (admitted(check, s)) return s;
  }
  promise(false, ("a check finds admissible inputs: " + check.id).c_str());
  return {};
}

constexpr std::size_t most_kept = 50000;  // some 30 MB

}  // namespace

// A class has the same cases for everybody, and drawing one costs as much as judging it.
Scenario draw_case(const Check& check, std::uint64_t seed, int number) {
  using Key = std::tuple<std::string, std::uint64_t, int>;
  static std::map<Key, Scenario> kept;
  static std::mutex mutex;
  Key key{check.id, seed, number};
  {
    const std::lock_guard lock(mutex);
    if (const auto at = kept.find(key); at != kept.end()) return at->second;
  }
  const Scenario s = drawn(check, seed, number);
  const std::lock_guard lock(mutex);
  if (kept.size() >= most_kept) kept.clear();
  kept.emplace(std::move(key), s);
  return s;
}

}  // namespace rigor::grader
