#include <rigor/grader/build_sources.hpp>

#include <algorithm>
#include <rigor/base/promise.hpp>
#include <rigor/grader/build_hash.hpp>
#include <rigor/grader/build_text.hpp>
#include <rigor/grader/texts.hpp>

namespace rigor::grader {
namespace {

using Kind = FunctionStatus::Kind;

constexpr std::size_t longest_error = 400;
constexpr const char* class_names[] = {"Cuboid", "CollisionPlane", "ParticleSystem", "MatrixUtils"};

/// What Visual C++ lets pass and the standard does not, said in the student's terms.
std::string with_hint(const std::string& message) {
  if (message.find("cannot bind non-const lvalue reference") != message.npos)
    return message + " (Visual C++ lets a temporary bind to a reference; standard C++ does not: give the value a name "
                     "first, P3D p = ...; and pass p)";
  return message;
}

std::string kit_text(const std::string& path) {
  for (const Text& text : texts())
    if (text.path == "src/kit/" + path) return std::string(text.content);
  promise(false, "the kit has every file the build asks for");
  return "";
}

std::string tokens_in_line(std::string_view text) {
  std::string s;
  for (const Token& t : tokens_of(text)) (s += t.text) += ' ';
  return s;
}

Source from_kit(const std::string& name) { return {name, kit_text("handout/" + name), false}; }

std::string kit_body(const std::string& function) {
  for (const std::string c : class_names) {
    const std::string text = kit_text("handout/" + c + ".cpp");
    for (const Definition& d : definitions_of(text))
      if (d.name == function) return text.substr(d.body, d.end - d.body);
  }
  return "";
}

std::string first_link_error(const std::string& output) {
  for (const char* sign : {"undefined reference", "multiple definition"})
    if (const std::size_t at = output.find(sign); at != output.npos)
      return "the linker: " + output.substr(at, output.find('\n', at) - at);
  return "the linker: " + output.substr(0, longest_error);
}

}  // namespace

std::string clipped(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 32) c = ' ';
  if (text.size() > longest_error) text.resize(longest_error), text += " ...";
  return text;
}

bool is_source(const std::string& name) {
  const std::string ending = name.substr(std::min(name.size(), name.rfind('.')));
  return ending == ".cpp" || ending == ".cc" || ending == ".cxx" || ending == ".c" || ending == ".CPP" || ending == ".C";
}

// ---- What is there

Sources::Sources(const Submission& submission, const std::set<StudentFunction>& replaced) {
  bring_in(submission);
  look_at_functions(replaced);
}

void Sources::bring_in(const Submission& s) {
  for (const std::string c : class_names)
    for (const std::string ending : {".h", ".cpp"}) {
      const SourceFile* file = s.find(c + ending);
      sources_[c + ending] = file ? Source{file->path, file->text} : from_kit(c + ending);
    }
  if (const SourceFile* file = s.find("Constants.h");
      file && tokens_in_line(file->text) != tokens_in_line(kit_text("handout/Constants.h"))) {
    std::string text = file->text;
    for (const char* name : {"COEFF_RESITUTION", "COEFF_STATIC_FRICTION", "COEFF_DYNAMIC_FRICTION", "DELTA_T"})
      if (text.find(name) == text.npos) text += std::string("extern const double ") + name + ";\n";
    sources_["Constants.h"] = {file->path, text};
    own_constants_ = true;
  }
  for (const SourceFile& file : s.others) {
    if (sources_.contains(file.name)) {
      note(file.path + ": not used, another file has the same name");
      continue;
    }
    sources_[file.name] = {file.path, file.text};
    sources_[file.name].expected = false;
  }
  std::vector<std::string> known;
  for (const Text& text : texts())
    if (text.path.starts_with("src/kit/include/")) known.emplace_back(text.path.substr(16));
  for (const char* name : {"Core", "Dense", "Eigen", "Geometry", "LU", "QR", "SVD", "Cholesky", "Eigenvalues",
                           "StdVector", "Sparse"})
    known.push_back(std::string("Eigen/") + name);
  for (const auto& [name, source] : sources_) known.push_back(name);
  for (auto& [name, source] : sources_) source.text = with_plain_includes(source.text, known);
}

void Sources::note(std::string text) {
  text = clipped(std::move(text));
  if (std::find(notes_.begin(), notes_.end(), text) == notes_.end())
    notes_.push_back(std::move(text));
}

std::pair<Source*, Definition> Sources::find(const std::string& function) {
  for (auto& [name, source] : sources_)
    for (const Definition& d : definitions_of(source.text))
      if (d.name == function) return {&source, d};
  return {nullptr, {}};
}

void Sources::look_at_functions(const std::set<StudentFunction>& replaced) {
  std::map<std::string, std::string> cut;  // by class: where a comment begins that never ends
  for (auto& [name, source] : sources_)
    if (const std::size_t at = unclosed_comment(source.text); at != source.text.npos) {
      const auto line = 1 + std::count(source.text.begin(), source.text.begin() + std::ptrdiff_t(at), '\n');
      const std::string where = source.path + ":" + std::to_string(line) + ": the comment that begins here never ends";
      cut[name.substr(0, name.rfind('.'))] = where;
      note(where);
      source.text.erase(at);
    }
  for (std::size_t i = 0; i < student_functions; ++i) {
    const StudentFunction f = StudentFunction(i);
    const std::string full = student_function_name(f);
    const auto [source, definition] = find(full);
    if (const auto begun = cut.find(full.substr(0, full.find(':'))); source == nullptr && begun != cut.end()) {
      status(f) = {Kind::not_compiled, begun->second};
    } else if (source == nullptr) {
      status(f) = {Kind::not_implemented, ""};
      absent_.insert(f);
      note(full + " is not there");
    } else if (is_handed_out(f, std::string_view(source->text).substr(definition.body,
                                                                      definition.end - definition.body))) {
      status(f) = {Kind::not_implemented, ""};
    } else if (replaced.contains(f)) {
      status(f) = {Kind::not_compiled, "replaced by the handed-out one on request"};
      source->text = with_body(source->text, definition, handed_out_body(f));
    }
  }
  for (const std::string c : class_names) complete(c);
}

void Sources::complete(const std::string& c) {
  Source& source = sources_[c + ".cpp"];
  if (!source.own) return;
  std::set<std::string> there, declared;
  for (const auto& [name, other] : sources_)
    for (const Definition& d : definitions_of(other.text)) there.insert(d.name);
  for (const Token& t : tokens_of(sources_[c + ".h"].text)) declared.insert(std::string(t.text));
  const std::string kit = kit_text("handout/" + c + ".cpp");
  std::string members, helpers, includes;
  std::vector<std::string> called;
  for (const Definition& d : definitions_of(kit)) {
    const std::string text = kit.substr(d.begin, d.end - d.begin) + "\n";
    const std::size_t scope = d.name.rfind("::");
    if (there.contains(d.name)) continue;
    if (scope == d.name.npos) called.push_back(text);
    else if (declared.contains(d.name.substr(d.name.find_first_not_of("~", scope + 2)))) members += text;
  }
  for (std::size_t at = 0, end; at < kit.size(); at = end + 1) {
    end = std::min(kit.find('\n', at), kit.size());
    const std::string line = kit.substr(at, end - at);
    if (line.starts_with("#include")) includes += line + "\n";
    // "bool ParticleSystem::drawParticles = true;"
    const std::size_t scope = line.find(c + "::"), equals = line.find(" = ");
    if (equals != line.npos && scope < equals && line.find('(') > equals && !line.starts_with(' ') &&
        source.text.find(line.substr(scope, equals - scope)) == std::string::npos)
      members += line + "\n";
  }
  if (members.empty()) return;
  for (const std::string& helper : called) helpers += helper;
  source.text += includes + helpers + members;
}

std::string Sources::headers_key() const {
  std::string all;
  for (const auto& [name, source] : sources_)
    if (!is_source(name)) all += key_of(name, source.text);
  return sha256(all);
}

void Sources::report_to(BuildResult& result, bool complete) const {
  result.functions = functions_;
  result.own_constants = own_constants_;
  result.notes = notes_;
  if (!complete)
    for (FunctionStatus& f : result.functions)
      if (f.kind == Kind::compiled) f = {Kind::not_compiled, last_error_};
}

// ---- Repairing

bool Sources::repair(const std::string& name, const Compilation& c) {
  std::map<std::string, std::string> files;
  for (const auto& [file, source] : sources_) files[file];
  const std::vector<Diagnostic> errors = diagnostics_of(c.output, files);
  last_error_ = !c.stopped.empty() ? c.stopped : errors.empty() ? clipped(c.output) : shown(errors.front());
  return repair_at(name, errors) || repair_headers(c.output);
}

bool Sources::repair_at(const std::string& name, const std::vector<Diagnostic>& errors) {
  if (!sources_.contains(name)) return false;
  for (const Diagnostic& e : errors)
    if (!e.missing.empty() && !e.file.empty() && leave_out_include(e)) return true;
  // Braces that do not match, and a broken header, make errors everywhere else: these first.
  bool replaced = false;
  for (const Diagnostic& e : errors)
    if (!e.file.empty()) replaced |= replace_unsound(sources_[e.file], e);
  if (replaced) return true;
  for (const Diagnostic& e : errors)
    if (!e.file.empty() && !is_source(e.file) && (replace_function_at(e) || give_up(e.file, e))) return true;
  for (const Diagnostic& e : errors)
    if (!e.file.empty()) replaced |= replace_function_at(e);
  if (replaced) return true;
  if (errors.empty() || errors.front().file.empty()) return give_up(name, {name, 0, last_error_, ""});
  return give_up(name, errors.front());
}

std::string Sources::shown(const Diagnostic& e) const {
  const auto at = sources_.find(e.file);
  const std::string where =
      at == sources_.end() ? "" : at->second.path + (e.line > 0 ? ":" + std::to_string(e.line) : "") + ": ";
  return clipped(where + with_hint(e.message));
}

bool Sources::leave_out_include(const Diagnostic& e) {
  std::string& text = sources_[e.file].text;
  std::size_t at = 0;
  for (int line = 1; line < e.line && at != text.npos; ++line) at = text.find('\n', at) + 1;
  const std::size_t end = std::min(text.find('\n', at), text.size());
  if (text.substr(at, end - at).find("include") == text.npos) return false;
  text.erase(at, end - at);
  note(sources_[e.file].path + ":" + std::to_string(e.line) + ": left out an include of " + e.missing +
       ", which is neither in the submission nor in the kit");
  return true;
}

bool Sources::replace_function_at(const Diagnostic& e) {
  Source& source = sources_[e.file];
  for (const Definition& d : definitions_of(source.text))
    if (e.line >= d.first_line && e.line <= d.last_line) return replace(source, d, e);
  return false;
}

bool Sources::replace_unsound(Source& source, const Diagnostic& e) {
  bool replaced = false;
  const std::vector<Definition> all = definitions_of(source.text);
  for (auto d = all.rbegin(); d != all.rend(); ++d)  // from the end: the offsets before stay as they are
    if (!d->sound) replaced |= replace(source, *d, e);
  return replaced;
}

bool Sources::replace(Source& source, const Definition& d, const Diagnostic& e) {
  if (!source.replaced.insert(d.name).second) return false;
  std::string body = "{ throw \"" + d.name + " does not compile\"; }";
  bool graded = false;
  for (std::size_t i = 0; i < student_functions; ++i)
    if (student_function_name(StudentFunction(i)) == d.name) {
      status(StudentFunction(i)) = {Kind::not_compiled, shown(e)};
      body = handed_out_body(StudentFunction(i));
      graded = true;
    }
  if (!graded) {
    const std::string kit = kit_body(d.name);
    note(d.name + " does not compile, " + (kit.empty() ? "what calls it fails" : "the handed-out one is used") + ": " +
         shown(e));
    if (!kit.empty()) body = kit;
  }
  source.text = with_body(source.text, d, body);
  return true;
}

bool Sources::give_up(const std::string& name, const Diagnostic& e) {
  Source& source = sources_[name];
  if (!source.own || (!source.expected && !is_source(name))) return false;
  if (name == "Constants.h") {
    sources_.erase(name);
    own_constants_ = false;
    note("Constants.h does not compile, the grader's is used: " + shown(e));
    return true;
  }
  for (const Definition& d : definitions_of(source.text))
    for (std::size_t i = 0; i < student_functions; ++i)
      if (d.name == student_function_name(StudentFunction(i)) && status(StudentFunction(i)).kind == Kind::compiled)
        status(StudentFunction(i)) = {Kind::not_compiled, shown(e)};
  for (const StudentFunction f : absent_)  // a file that is no C++ at all may have been meant to hold them
    if (name == std::string(student_function_name(f)).substr(0, std::string(student_function_name(f)).find(':')) + ".cpp" && status(f).kind == Kind::not_implemented)
      status(f) = {Kind::not_compiled, shown(e)};
  note(source.path + " does not compile, the handed-out file is used: " + shown(e));
  if (source.expected)
    source = from_kit(name);
  else
    sources_.erase(name);
  for (const std::string c : class_names)
    if (name == c + ".h") complete(c);
  return true;
}

bool Sources::repair_headers(const std::string& output) {
  for (const bool all : {false, true}) {
    bool changed = false;
    for (const std::string c : class_names) {
      const bool named = output.find("class " + c + "'") != output.npos || output.find(c + "::") != output.npos ||
                         output.find(c + ".h") != output.npos;
      if (named || all) changed |= give_up(c + ".h", {c + ".h", 0, last_error_, ""});
    }
    if (changed) return true;
  }
  return false;
}

bool Sources::repair_linking(const Compilation& c) {
  last_error_ = clipped(c.stopped.empty() ? first_link_error(c.output) : c.stopped);
  const std::string& output = c.output;
  bool changed = false;
  for (std::size_t at = 0; (at = output.find("in function `", at)) != output.npos;) {
    at += 13;
    const std::string function = output.substr(at, output.find_first_of("('\n", at) - at);
    const std::size_t missing = output.find("undefined reference to", at);
    const std::string what = missing == output.npos
                                 ? last_error_ : output.substr(missing, output.find('\n', missing) - missing);
    const auto [source, definition] = find(function);
    if (source == nullptr) continue;
    for (auto& [name, candidate] : sources_)
      if (&candidate == source) changed |= replace(*source, definition, {name, definition.first_line, what, ""});
  }
  return changed;
}

}  // namespace rigor::grader
