#pragma once
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <rigor/base/outcome.hpp>
#include <rigor/grader/check.hpp>
#include <set>
#include <string>

namespace rigor::grader {

/// When students see a check's result. Gradescope knows all four; elsewhere students see what is visible.
enum class Visibility { visible, hidden, after_due_date, after_published };
const char* name(Visibility visibility);

/// What an instructor decides: points, accepted readings, how many cases, which seed, limits. docs/rubric.md goes
/// through the default line by line.
struct Rubric {
  std::string title = "Rigid body dynamics";
  std::string path;                        ///< it was read from; empty: the default
  std::uint64_t seed = 20260414;           ///< of the graded cases
  std::uint64_t practice_seed = 1;         ///< of the cases students practise on (the exported kit)
  int cases = 200;
  double tolerance = 1;                    ///< multiplies every derived bound
  Limits limits;
  std::set<std::string> accepted;          ///< misconceptions that count as right: "plane.printed-restitution"
  std::set<std::string> refused;           ///< readings that do not: "friction-literal"
  std::set<std::string> practised;         ///< checks that ./practice runs; empty: those visible to students

  // by check id, where they differ from the default
  std::map<std::string, double> points;
  std::map<std::string, double> tolerances;  ///< on top of `tolerance`
  std::map<std::string, int> case_counts;
  std::map<std::string, Visibility> visibilities;
  std::map<std::string, std::string> groups;  ///< the heading it stands under
  std::vector<std::string> group_order;       ///< of the headings named in the file; others follow

  /// Changes with everything that could change a grade.
  std::string hash() const;
  double points_of(const Check& check) const {
    const auto it = points.find(check.id);
    return it == points.end() ? check.points : it->second;
  }
  double tolerance_of(const Check& check) const {
    const auto it = tolerances.find(check.id);
    return tolerance * (it == tolerances.end() ? 1 : it->second);
  }
  /// Some checks take long and have a number of their own, which a rubric may only lower.
  int cases_of(const Check& check) const {
    const auto it = case_counts.find(check.id);
    const int asked = it == case_counts.end() ? cases : it->second;
    return check.cases != 0 ? std::min(check.cases, asked) : asked;
  }
  Visibility visibility_of(const Check& check) const {
    const auto it = visibilities.find(check.id);
    return it == visibilities.end() ? Visibility::visible : it->second;
  }
  bool practises(const Check& check) const { return practised.empty() ? visibility_of(check) == Visibility::visible : practised.count(check.id) != 0; }
  const std::string& group_of(const Check& check) const {
    const auto it = groups.find(check.id);
    return it == groups.end() ? check.group : it->second;
  }
  double total_points() const;
  /// The headings with points, in the order of the report.
  std::vector<std::string> group_names() const;
};

/// Reads a TOML rubric. Faults name the file and key; unknown keys and ids come with a suggestion.
Outcome<Rubric> read_rubric(const std::filesystem::path& path);
Outcome<Rubric> parse_rubric(const std::string& text, const std::string& name);

/// What an instructor should know before grading with it, one sentence each: points that do not add up to 100, the
/// public default as the seed of the graded cases (where that should be a `secret_seed`: marks are to come of it).
std::vector<std::string> warnings(const Rubric& rubric, bool secret_seed);

/// What goes out with the kit, as TOML: the seed for practice, and of the checks those that students are to see. No other
/// is named, and no comment of the instructor's.
std::string practice_rubric_text(const Rubric& rubric);
/// The default rubric as TOML, with a comment on every line: what `read_rubric` of it gives is `Rubric{}`.
std::string default_rubric_text();

}  // namespace rigor::grader
