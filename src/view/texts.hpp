#pragma once
#include <rigor/base/text.hpp>

namespace rigor::view {

/// What src/view/web/bundle.cmake makes for the interactive pages.
const std::vector<Text>& texts();

}  // namespace rigor::view
