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
          agreements(only, std::max(1L, cases / 20), seed), engines(only, std::max(1L, cases / 20), seed)};
}

}  // namespace rigor::verify
