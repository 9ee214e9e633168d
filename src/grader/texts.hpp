#pragma once
#include <string_view>
#include <vector>

namespace rigor::grader {

/// A file of src/kit (and protocol.hpp, and build*.cpp for their hash) carried inside the program, so that it
/// compiles submissions anywhere.
struct Text {
  std::string_view path;  ///< from the root of the repository, "src/kit/include/MathLib/V3D.h"
  std::string_view content;
};

/// Generated at build time by src/cli/embed.cmake.
const std::vector<Text>& texts();

}  // namespace rigor::grader
