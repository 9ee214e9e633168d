#pragma once
#include <rigor/base/text.hpp>

namespace rigor::cli {

/// Formulas, derivations, theorems, exact tests, errata, tables, sample submissions.
const std::vector<Text>& texts();

}  // namespace rigor::cli
