#include <algorithm>
#include <array>
#include <cctype>
#include <rigor/grader/build_text.hpp>

namespace rigor::grader {
namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }
bool is_word(std::string_view t) { return is_word(t[0]) && !std::isdigit(static_cast<unsigned char>(t[0])); }

constexpr std::array known_classes{"Cuboid", "CollisionPlane", "ParticleSystem", "MatrixUtils"};
constexpr std::array statements{"if", "for", "while", "switch", "do", "else", "return", "catch", "try", "case"};

bool is_known_class(std::string_view t) {
  return std::find(known_classes.begin(), known_classes.end(), t) != known_classes.end();
}

/// One past the end of a quoted text that begins at `at`; an unclosed one ends with its line.
std::size_t past_quote(std::string_view s, std::size_t at) {
  const char quote = s[at];
  for (++at; at < s.size() && s[at] != '\n'; ++at) {
    if (s[at] == '\\') ++at;
    else if (s[at] == quote) return at + 1;
  }
  return std::min(at, s.size());
}

std::size_t past_raw_string(std::string_view s, std::size_t quote) {
  const std::size_t open = s.find('(', quote);
  if (open == s.npos || open - quote > 17) return past_quote(s, quote);
  const std::string close = ")" + std::string(s.substr(quote + 1, open - quote - 1)) + "\"";
  const std::size_t at = s.find(close, open);
  return at == s.npos ? s.size() : at + close.size();
}

/// The index of the token that closes the bracket at `open`, or the number of tokens.
std::size_t closing(const std::vector<Token>& t, std::size_t open) {
  const std::string_view opens = t[open].text, closes = opens == "(" ? ")" : opens == "[" ? "]" : "}";
  int depth = 0;
  for (std::size_t i = open; i < t.size(); ++i) {
    if (t[i].text == opens) ++depth;
    if (t[i].text == closes && --depth == 0) return i;
  }
  return t.size();
}

class Finder {
 public:
  explicit Finder(std::string_view text) : text_(text), tokens_(tokens_of(text)) {}

  std::vector<Definition> run() {
    declarations(0, "", false);
    return std::move(found_);
  }

 private:
  std::string_view at(std::size_t i) const { return i < tokens_.size() ? tokens_[i].text : std::string_view(); }
  bool starts_line(std::size_t i) const {
    return tokens_[i].at == 0 || text_[tokens_[i].at - 1] == '\n';
  }

  /// Does a line at column 0 begin "Type Known::name(...) {" here (or "Known::Known(...)")?
  bool begins_known_function(std::size_t i) const {
    if (!starts_line(i) || !is_word(at(i))) return false;
    std::size_t j = i;
    for (const int line = tokens_[i].line; j < tokens_.size() && tokens_[j].line <= line + 1; ++j) {
      if (is_known_class(at(j)) && at(j + 1) == "::") break;
      if (!is_word(at(j)) && at(j) != "*" && at(j) != "&" && at(j) != "<" && at(j) != ">" && at(j) != "::" &&
          at(j) != ",")
        return false;
    }
    if (!is_known_class(at(j)) || at(j + 1) != "::") return false;
    const std::size_t name = at(j + 2) == "~" ? j + 3 : j + 2;
    if (name + 1 >= tokens_.size() || !is_word(at(name)) || at(name + 1) != "(") return false;
    const std::string_view next = at(closing(tokens_, name + 1) + 1);
    return next == "{" || next == "const" || next == ":" || next == "noexcept";
  }

  /// Where the body that opens at `open` ends: one past its "}" or at the next known function.
  std::size_t past_body(std::size_t open, bool& sound) const {
    int depth = 0;
    for (std::size_t i = open; i < tokens_.size(); ++i) {
      if (at(i) == "{") ++depth;
      if (at(i) == "}" && --depth == 0) return i + 1;
      if (i > open && begins_known_function(i)) break_at_ = i, i = tokens_.size();
    }
    sound = false;
    return std::exchange(break_at_, tokens_.size());
  }

  std::size_t offset(std::size_t i) const { return i < tokens_.size() ? tokens_[i].at : text_.size(); }

  /// What was left over between two functions (a brace too many ended the first too early) belongs to the first.
  void leftover(std::size_t i) {
    if (found_.empty()) return;
    Definition& last = found_.back();
    last.sound = false;
    last.end = std::max(last.end, i < tokens_.size() ? tokens_[i].at + tokens_[i].text.size() : text_.size());
    last.last_line = i < tokens_.size() ? tokens_[i].line : last.last_line;
  }

  void add(std::size_t first, std::size_t name, std::size_t body, std::size_t past, const std::string& scope,
           bool sound) {
    std::string full(at(name));
    if (name > 0 && at(name - 1) == "~") --name, full = "~" + full;
    if (name > 1 && at(name - 1) == "::")
      full = std::string(at(name - 2)) + "::" + full;
    else if (!scope.empty())
      full = scope + "::" + full;
    const std::size_t end = sound ? tokens_[past - 1].at + 1 : offset(past);
    found_.push_back({full, tokens_[first].at, tokens_[body].at, end, tokens_[first].line,
                      past < tokens_.size() && !sound ? tokens_[past].line - 1 : tokens_[past - 1].line, sound});
  }

  /// Declarations from token i on; returns one past the "}" that ends the scope. One scope is a class or namespace.
  std::size_t declarations(std::size_t i, const std::string& scope, bool inside) {
    std::size_t first = i;
    while (i < tokens_.size()) {
      const std::string_view t = at(i);
      if (t == "}") {
        if (inside) return i + 1;
        leftover(i);
        first = ++i;
      } else if (t == ";" || (t == ":" && i == first + 1 && is_word(at(first)))) {  // end, or "public:"
        first = ++i;
      } else if (t == "(" || t == "[") {
        i = closing(tokens_, i) + 1;
      } else if (t == "{") {
        i = brace(first, i, scope);
        first = i;
      } else {
        ++i;
      }
    }
    return i;
  }

  std::size_t brace(std::size_t first, std::size_t open, const std::string& scope) {
    std::size_t name = tokens_.size(), parenthesis = tokens_.size();
    bool assigned = false, scoped = false;
    std::string inner = scope;
    for (std::size_t i = first; i < open; ++i) {
      const std::string_view t = at(i);
      if (t == "(" && parenthesis == tokens_.size()) {
        parenthesis = i;
        if (i > first && is_word(at(i - 1))) name = i - 1;
      }
      if (t == "(" || t == "[") {
        i = closing(tokens_, i);
        continue;
      }
      if (t == "=" && parenthesis == tokens_.size()) assigned = true;
      if ((t == "class" || t == "struct" || t == "namespace") && parenthesis == tokens_.size()) {
        scoped = true;
        if (t != "namespace" && i + 1 < open && is_word(at(i + 1))) inner = at(i + 1);
      }
      if (t == "extern" && at(i + 1).starts_with('"')) scoped = true;
    }
    if (name < tokens_.size() && !assigned) {
      bool sound = true;
      if (std::find(statements.begin(), statements.end(), at(name)) != statements.end()) {
        const std::size_t past = past_body(open, sound);  // a statement outside every function
        leftover(past - 1);
        return past;
      }
      // "Type::Type(...) : a{x}, b(y) {": the body is the brace that no name stands before
      if (at(closing(tokens_, parenthesis) + 1) == ":")
        while (is_word(at(open - 1)) && closing(tokens_, open) + 2 < tokens_.size()) {
          std::size_t next = closing(tokens_, open) + 1;
          while (next < tokens_.size() && at(next) != "{") next = at(next) == "(" ? closing(tokens_, next) + 1 : next + 1;
          if (next >= tokens_.size()) break;
          open = next;
        }
      const std::size_t past = past_body(open, sound);
      add(first, name, open, past, scope, sound);
      return past;
    }
    if (scoped) return declarations(open + 1, inner, true);
    return std::min(closing(tokens_, open) + 1, tokens_.size());
  }

  std::string_view text_;
  std::vector<Token> tokens_;
  std::vector<Definition> found_;
  mutable std::size_t break_at_ = tokens_.size();
};

std::string lower(std::string_view s) {
  std::string t(s);
  for (char& c : t) c = char(std::tolower(static_cast<unsigned char>(c)));
  return t;
}

std::string base_name(const std::string& path) { return path.substr(path.rfind('/') + 1); }

/// The words of a body without spaces, comments, braces around it and "this->".
std::string squeezed(std::string_view body) {
  std::string s;
  for (const Token& t : tokens_of(body)) s += t.text;
  if (s.size() >= 2 && s.front() == '{' && s.back() == '}') s = s.substr(1, s.size() - 2);
  for (std::size_t i; (i = s.find("this->")) != s.npos;) s.erase(i, 6);
  return s;
}

}  // namespace

namespace {

std::vector<Token> scan(std::string_view s, std::size_t& unclosed) {
  std::vector<Token> tokens;
  int line = 1;
  std::size_t i = 0;
  const auto skip_to = [&](std::size_t end) {
    for (; i < end && i < s.size(); ++i) line += s[i] == '\n';
  };
  bool line_begins = true;
  while (i < s.size()) {
    const char c = s[i];
    if (c == '\n') {
      ++line, ++i;
      line_begins = true;
    } else if (std::isspace(static_cast<unsigned char>(c))) {
      ++i;
    } else if (s.substr(i, 2) == "//") {
      while (i < s.size() && s[i] != '\n') {
        if (s[i] == '\\' && i + 1 < s.size()) skip_to(i + 1);
        skip_to(i + 1);
      }
    } else if (s.substr(i, 2) == "/*") {
      const std::size_t end = s.find("*/", i + 2);
      if (end == s.npos) unclosed = i;
      skip_to(end == s.npos ? s.size() : end + 2);
    } else if (c == '#' && line_begins) {
      while (i < s.size() && s[i] != '\n') {
        if (s[i] == '\\' && i + 1 < s.size()) skip_to(i + 1);
        skip_to(i + 1);
      }
    } else {
      line_begins = false;
      std::size_t end = i + 1;
      if (c == 'R' && s.substr(i, 2) == "R\"") {
        end = past_raw_string(s, i + 1);
      } else if (c == '"' || c == '\'') {
        end = past_quote(s, i);
      } else if (is_word(c)) {
        const bool number = std::isdigit(static_cast<unsigned char>(c));
        while (end < s.size() && (is_word(s[end]) || (number && s[end] == '\''))) ++end;
      } else if (s.substr(i, 2) == "::" || s.substr(i, 2) == "->") {
        end = i + 2;
      }
      tokens.push_back({s.substr(i, end - i), i, line});
      skip_to(end);
    }
  }
  return tokens;
}

}  // namespace

std::vector<Token> tokens_of(std::string_view text) {
  std::size_t unclosed = text.npos;
  return scan(text, unclosed);
}

std::size_t unclosed_comment(std::string_view text) {
  std::size_t unclosed = text.npos;
  scan(text, unclosed);
  return unclosed;
}

std::vector<Definition> definitions_of(std::string_view text) { return Finder(text).run(); }

std::string with_body(std::string_view text, const Definition& which, std::string_view body) {
  const std::string_view old = text.substr(which.body, which.end - which.body);
  std::string result(text.substr(0, which.body));
  for (const char c : body) result += c == '\n' ? ' ' : c;
  result.append(std::size_t(std::count(old.begin(), old.end(), '\n')), '\n');
  result += text.substr(which.end);
  return result;
}

std::string with_plain_includes(std::string_view text, const std::vector<std::string>& known) {
  const auto plain = [&known](std::string path) {
    std::replace(path.begin(), path.end(), '\\', '/');
    const std::string wanted = lower(path);
    // the longest known path that is the end of the one written ("../src/MathLib/v3d.h"), else by base name
    const std::string* best = nullptr;
    for (const std::string& k : known) {
      const std::string candidate = lower(k);
      const bool ends = wanted == candidate || wanted.ends_with("/" + candidate);
      if (ends && (best == nullptr || k.size() > best->size())) best = &k;
    }
    if (best == nullptr)
      for (const std::string& k : known)
        if (lower(base_name(k)) == base_name(wanted)) best = &k;
    return best != nullptr ? *best : path;
  };
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, end - at);
    std::size_t i = line.find_first_not_of(" \t");
    std::size_t open = line.npos, close = line.npos;
    if (i != line.npos && line[i] == '#') {
      i = line.find_first_not_of(" \t", i + 1);
      if (i != line.npos && line.substr(i, 7) == "include") {
        open = line.find_first_of("\"<", i);
        if (open != line.npos) close = line.find(line[open] == '<' ? '>' : '"', open + 1);
      }
    }
    if (close != line.npos) {
      const std::string path = plain(std::string(line.substr(open + 1, close - open - 1)));
      (result += line.substr(0, open + 1)) += path;
      result += line.substr(close);
    } else {
      result += line;
    }
    if (end < text.size()) result += '\n';
    at = end + 1;
  }
  return result;
}

bool is_handed_out(StudentFunction function, std::string_view body) {
  static const std::set<std::string> untouched_inertia{
      "",
      "bodyCoordsMOI.setIdentity();bodyCoordsInverseMOI=bodyCoordsMOI.inverse();",
      "bodyCoordsMOI.setIdentity();bodyCoordsInverseMOI.setIdentity();",
      "bodyCoordsMOI=Matrix3x3::Identity();bodyCoordsInverseMOI=bodyCoordsMOI.inverse();",
      "bodyCoordsMOI=Matrix3x3::Identity();bodyCoordsInverseMOI=Matrix3x3::Identity();"};
  static const std::set<std::string> untouched_matrix{"returnMatrix3x3::Identity();", "returnMatrix3x3();"};
  static const std::set<std::string> untouched_vector{"returnV3D();", "returnV3D(0,0,0);", "returnV3D(0.0,0.0,0.0);"};
  const std::string words = squeezed(body);
  switch (function) {
    case StudentFunction::body_inertia: return untouched_inertia.contains(words);
    case StudentFunction::world_inertia:
    case StudentFunction::world_inverse_inertia: return untouched_matrix.contains(words);
    case StudentFunction::friction_tangent: return untouched_vector.contains(words);
    default: return words.empty();
  }
}

std::string handed_out_body(StudentFunction function) {
  switch (function) {
    case StudentFunction::body_inertia:
      return "{ bodyCoordsMOI.setIdentity(); bodyCoordsInverseMOI = bodyCoordsMOI.inverse(); }";
    case StudentFunction::world_inertia:
    case StudentFunction::world_inverse_inertia: return "{ return Matrix3x3::Identity(); }";
    case StudentFunction::friction_tangent: return "{ return V3D(0, 0, 0); }";
    default: return "{}";
  }
}

}  // namespace rigor::grader
