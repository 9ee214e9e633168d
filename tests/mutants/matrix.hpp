#pragma once
#include <gtest/gtest.h>

#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace rigor {

/// What the oracles said of one variant: oracle -> cases it flagged. An oracle that does not apply is absent.
using Verdict = std::map<std::string, int>;

/// One row a variant, one column an oracle; "." is 0 flagged, "-" does not apply.
inline void print_matrix(const char* title, const std::vector<std::string>& oracles,
                         const std::vector<std::pair<std::string, Verdict>>& rows) {
  std::printf("\n%s\n%-58s", title, "");
  for (const std::string& oracle : oracles) std::printf("  %12s", oracle.c_str());
  for (const auto& [name, verdict] : rows) {
    std::printf("\n%-58s", name.c_str());
    for (const std::string& oracle : oracles) {
      const auto found = verdict.find(oracle);
      std::printf("  %12s", found == verdict.end() ? "-"
                            : found->second == 0   ? "."
                                                   : std::to_string(found->second).c_str());
    }
  }
  std::printf("\n\n");
}

inline bool killed(const Verdict& verdict) {
  for (const auto& [oracle, flagged] : verdict)
    if (flagged > 0) return true;
  return false;
}

}  // namespace rigor
