#include <algorithm>
#include <rigor/verify/verify.hpp>

namespace rigor::verify {

bool Result::ok() const {
  const auto fine = [](const auto& row) { return row.ok(); };
  return std::all_of(identities.begin(), identities.end(), fine) &&
         std::all_of(roundings.begin(), roundings.end(), fine) &&
         std::all_of(agreements.begin(), agreements.end(), fine) && std::all_of(engines.begin(), engines.end(), fine);
}

Result run(const std::string& only, long cases, std::uint64_t seed) {
  return {identities(only, std::max(1L, cases / 20), seed), roundings(only, cases, seed),
          agreements(only, std::max(1L, cases / 20), seed), engines(only, std::max(1L, cases / 20), seed), absent(only)};
}

std::vector<Absent> absent(const std::string& only) {
  std::vector<Absent> rows{
      {"friction.coulomb", "rounding", "the condition of K enters: the oracle's row is relative to it"},
      {"friction.stronge", "exact identity", "an adaptive method in double: held to Routh's closed form instead"},
      {"friction.stronge", "rounding", "an adaptive method with tolerance 1e-13 a step: the oracle's row is its error"},
      {"friction.stronge_planar", "rounding", "roots of rounded discriminants decide where a leg ends: measured by the oracle's row, not counted"},
  };
  std::erase_if(rows, [&](const Absent& row) { return !only.empty() && row.id != only; });
  return rows;
}

}  // namespace rigor::verify
