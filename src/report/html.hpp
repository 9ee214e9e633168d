#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace rigor::report {

/// Text that a terminal, too, may be shown: control characters (ANSI escapes among them), marks that turn the direction
/// of writing, and bytes that are not UTF-8 become U+FFFD. Newlines and tabs stay.
std::string clean(std::string_view text);

/// The same for HTML element content and quoted attributes: & < > " ' become entities, so nothing a student wrote is
/// interpreted.
std::string escape(std::string_view text);

/// A page of rigor: one file, no network, no script but the one that shows plots under the pointer, where there are
/// plots; light and dark, phone, print, keyboard.
struct Page {
  std::string title;   ///< plain text, escaped by render()
  std::string lead;    ///< one plain sentence under the title, escaped by render()
  std::string body;    ///< HTML, already escaped by whoever made it
  std::string footer;  ///< plain text: versions, command, seed
  std::string style;   ///< more CSS, ours alone
};

/// The whole document, with a Content-Security-Policy that lets it load nothing and run nothing but that script.
std::string render(const Page& page);

/// <table> with a header row. Cells are plain text, escaped; columns named in `numbers` are right-aligned.
std::string table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows,
                  const std::vector<std::size_t>& numbers = {}, const std::string& caption = "");

}  // namespace rigor::report
