#pragma once
#include <string>

namespace rigor::report {

/// Columns a terminal needs for UTF-8: characters, without the dots and arrows set above another.
std::size_t columns(const std::string& text);

/// Text of a docstring or of Markdown for a terminal: paragraphs, list items and "label   text" lines filled to
/// `width` columns behind `margin` spaces; formulas (four spaces deep) and tables keep their lines, bold marks go.
std::string filled(const std::string& text, std::size_t width, std::size_t margin);

/// Source text: lines stay, what is too long goes on in the next line, four spaces deeper.
std::string folded(const std::string& text, std::size_t width, std::size_t margin);

}  // namespace rigor::report
