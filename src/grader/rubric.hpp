#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <rigor/base/outcome.hpp>
#include <rigor/grader/check.hpp>
#include <set>
#include <string>

namespace rigor::grader {

/// What an instructor decides: points, accepted readings, how many cases, which seed, limits. docs/rubric.md goes
/// through the default line by line.
struct Rubric {
  std::string title = "Rigid body dynamics";
  std::uint64_t seed = 20260414;
  int cases = 200;
  double tolerance = 1;                    ///< multiplies every derived bound
  Limits limits;
  std::map<std::string, double> points;    ///< by check id
  std::set<std::string> accepted;          ///< misconceptions that count as right: "plane.printed-restitution"

  /// Changes with everything that could change a grade.
  std::string hash() const;
  double points_of(const Check& check) const {
    const auto it = points.find(check.id);
    return it == points.end() ? check.points : it->second;
  }
};

/// Reads a TOML rubric. Faults name the file and key; unknown keys and ids come with a suggestion.
Outcome<Rubric> read_rubric(const std::filesystem::path& path);
Outcome<Rubric> parse_rubric(const std::string& text, const std::string& name);

/// The default rubric as TOML, with a comment on every line: what `read_rubric` of it gives is `Rubric{}`.
std::string default_rubric_text();

}  // namespace rigor::grader
