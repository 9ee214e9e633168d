#pragma once
#include <rigor/base/text.hpp>

namespace rigor::grader {

/// The files of src/kit (and protocol.hpp, and build*.cpp for their hash), so that it compiles submissions anywhere.
const std::vector<Text>& texts();

}  // namespace rigor::grader
