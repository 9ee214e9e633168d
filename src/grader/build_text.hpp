#pragma once
#include <rigor/grader/build.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace rigor::grader {

/// A piece of C++ as far as its braces matter: comments, white space and preprocessor lines are left out.
struct Token {
  std::string_view text;
  std::size_t at;  ///< offset in the text
  int line;        ///< from 1
};
std::vector<Token> tokens_of(std::string_view text);

/// Where a comment begins that never ends; npos when there is none.
std::size_t unclosed_comment(std::string_view text);

/// A function with a body, found by its braces.
struct Definition {
  std::string name;              ///< "Cuboid::update", or "helper"
  std::size_t begin, body, end;  ///< offsets: of the declaration, of the "{", one past the "}"
  int first_line, last_line;
  bool sound = true;  ///< braces match; if not, it reaches to where the next function of a known class begins
};

/// All of a file, in order. A body whose braces do not match ends where a line at column 0 begins the next
/// function "Type Known::name(...)": one mistyped brace costs one function.
std::vector<Definition> definitions_of(std::string_view text);

/// The text with the body of `which` replaced by `body` ("{ ... }"), every line still at its number.
std::string with_body(std::string_view text, const Definition& which, std::string_view body);

/// Include lines as this machine's files are called: backslashes turned, letter case as in `known` (paths as they
/// are included, "GUILib/GLMesh.h", "Cuboid.h"); an unknown path keeps its letters.
std::string with_plain_includes(std::string_view text, const std::vector<std::string>& known);

/// Is the body one the students were handed, that is: nothing done yet? Spaces and comments do not matter.
bool is_handed_out(StudentFunction function, std::string_view body);

/// The body the function is replaced by: what was handed out.
std::string handed_out_body(StudentFunction function);

}  // namespace rigor::grader
