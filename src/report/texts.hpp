#pragma once
#include <rigor/base/text.hpp>

namespace rigor::report {

/// What src/view/web/bundle.cmake makes for reports, src/formulas/typeset.tsv and src/studies/problems.tsv.
const std::vector<Text>& texts();

}  // namespace rigor::report
