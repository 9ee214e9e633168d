#pragma once
#include <string_view>
#include <vector>

namespace rigor::cli {

/// A file of the source tree carried inside the program: formulas, derivations, theorems, exact tests,
/// errata.
struct Text {
  std::string_view path;  ///< from the root of the repository, "proofs/impulse.md"
  std::string_view content;
};

/// Generated at build time by embed.cmake.
const std::vector<Text>& texts();

}  // namespace rigor::cli
