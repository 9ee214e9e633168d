#pragma once
#include <rigor/base/promise.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// A file carried inside the program; each layer that has some generates its texts() at build time.
struct Text {
  std::string_view path;  ///< from the root of the repository, "proofs/impulse.md"
  std::string_view content;
};

/// The content of the one with this file name. Precondition: it is there.
inline std::string_view text_named(std::string_view name, const std::vector<Text>& texts) {
  for (const Text& text : texts)
    if (text.path.ends_with("/" + std::string(name))) return text.content;
  promise(false, "a text is asked for by the name of an embedded file");
  return {};
}

}  // namespace rigor
