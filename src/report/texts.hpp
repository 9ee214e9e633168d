#pragma once
#include <string_view>
#include <vector>

namespace rigor::report {

/// A file carried inside the program: what src/view/web/bundle.cmake makes for reports, and src/formulas/typeset.tsv.
struct Text {
  std::string_view path, content;
};
const std::vector<Text>& texts();

/// By file name. Precondition: CMakeLists.txt embeds it.
std::string_view text(std::string_view name);

}  // namespace rigor::report
