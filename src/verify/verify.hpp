#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace rigor::verify {

/// An identity over ℚ, checked with ==.
struct Identity {
  std::string id;
  std::string says;  ///< "v_n' = -e v_n"
  long cases = 0, held = 0;
  bool ok() const { return cases > 0 && held == cases; }
};

/// Double against exact (or long double, where roots occur) on the same inputs.
struct Rounding {
  std::string id;
  std::string bound;  ///< "gamma(4) x absolute sum"
  long cases = 0;
  double worst = 0;  ///< largest |double - exact| / bound; must stay <= 1
  bool ok() const { return cases > 0 && worst <= 1; }
};

/// A second method that does not share the formula.
struct Agreement {
  std::string id;
  std::string oracle;  ///< "Gauss product rule", "CVODE Adams, tolerance 1e-13"
  double worst = 0, bound = 0;  ///< same unit
  long cases = 0;
  bool ok() const { return cases > 0 && worst <= bound; }
};

/// What a formula has no row of, and why.
struct Absent {
  std::string id;
  std::string part;  ///< "exact identity", "rounding"
  std::string why;
};

struct Result {
  std::vector<Identity> identities;
  std::vector<Rounding> roundings;
  std::vector<Agreement> agreements;
  std::vector<Agreement> engines;  ///< the fast paths, each against a plain one or another author
  std::vector<Absent> absent;
  bool ok() const;
};

/// Runs what is known of the formula or engine whose id is `only`, or of all when it is empty. Same seed, same
/// numbers. Stops early, with fewer cases, when the program is interrupted.
Result run(const std::string& only, long cases, std::uint64_t seed);

/// What is no formula but has a row in `engines`: "engine.batch" and so on.
std::vector<std::string> engine_ids();

/// The parts of run().
std::vector<Identity> identities(const std::string& only, long cases, std::uint64_t seed);
std::vector<Rounding> roundings(const std::string& only, long cases, std::uint64_t seed);
std::vector<Agreement> agreements(const std::string& only, long cases, std::uint64_t seed);
std::vector<Agreement> engines(const std::string& only, long cases, std::uint64_t seed);
std::vector<Absent> absent(const std::string& only);

}  // namespace rigor::verify
