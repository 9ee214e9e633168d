#pragma once
#include <rigor/base/text.hpp>

namespace rigor::report {

/// What src/view/web/bundle.cmake makes for reports, and src/formulas/typeset.tsv.
const std::vector<Text>& texts();

}  // namespace rigor::report
