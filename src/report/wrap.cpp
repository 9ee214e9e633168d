#include <regex>
#include <rigor/report/wrap.hpp>
#include <sstream>

namespace rigor::report {

// Bytes that begin a character, but for those of U+0300 to U+036F.
std::size_t columns(const std::string& text) {
  std::size_t count = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0) != 0x80 && byte != 0xCC && byte != 0xCD) ++count;
  }
  return count;
}

namespace {

// `text` behind `margin` spaces, broken at spaces from position `from` on; lines after the first start at margin + hang.
void fill(std::string& out, const std::string& text, std::size_t from, std::size_t width, std::size_t margin,
          std::size_t hang) {
  if (text.empty()) return;
  std::string line = std::string(margin, ' ') + text.substr(0, from);
  std::istringstream words(text.substr(from));
  bool empty = true;
  for (std::string word; words >> word; empty = false) {
    if (!empty && columns(line) + 1 + columns(word) > width) {
      out += line + "\n";
      line = std::string(margin + hang, ' ');
      empty = true;
    }
    line += (empty ? "" : " ") + word;
  }
  out += line + "\n";
}

}  // namespace

std::string filled(const std::string& text, std::size_t width, std::size_t margin) {
  static const std::regex item(R"(^(\s*(?:\d+\.|-) +|[a-z]+ {2,}).*)"), bold(R"(\*\*)");
  std::string out, paragraph;
  std::size_t hang = 0;
  const auto end_paragraph = [&] {
    fill(out, paragraph, hang, width, margin, hang);
    paragraph.clear(), hang = 0;
  };
  std::istringstream in(std::regex_replace(text, bold, ""));
  for (std::string line; std::getline(in, line);) {
    const std::size_t depth = line.find_first_not_of(' ');
    std::smatch match;
    if (depth == std::string::npos) {
      end_paragraph();
      out += "\n";
    } else if (std::regex_match(line, match, item)) {
      end_paragraph();
      paragraph = line, hang = static_cast<std::size_t>(match.length(1));
    } else if (line[depth] == '|' || (depth >= 4 && (hang == 0 || depth < hang))) {
      end_paragraph();
      out += folded(line + "\n", width, margin);
    } else {
      paragraph += (paragraph.empty() ? "" : " ") + line.substr(depth);
    }
  }
  end_paragraph();
  return out;
}

std::string folded(const std::string& text, std::size_t width, std::size_t margin) {
  std::string out;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    const std::size_t depth = line.find_first_not_of(' ');
    if (depth == std::string::npos) out += "\n";
    else if (margin + columns(line) <= width) out += std::string(margin, ' ') + line + "\n";
    else fill(out, line, depth, width, margin, depth + 4);
  }
  return out;
}

}  // namespace rigor::report
