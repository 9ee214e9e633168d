#pragma once
#include <string_view>
#include <vector>

namespace rigor::view {

/// A file made by src/view/web/bundle.cmake, carried inside the program.
struct Text {
  std::string_view path, content;
};
const std::vector<Text>& texts();

/// By file name. Precondition: bundle.cmake makes it.
std::string_view web_file(std::string_view name);

}  // namespace rigor::view
