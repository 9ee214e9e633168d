#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <rigor/grader/build_compile.hpp>
#include <rigor/grader/build_hash.hpp>
#include <rigor/grader/build_text.hpp>
#include <tests/grader/build_samples.hpp>

namespace rigor::grader {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Kind = FunctionStatus::Kind;

// ---- What is handed in

TEST(Submission, FindsFilesAtAnyDepthAndInAnyLetterCase) {
  const Directory dir;
  dir.write("zip/Assignment4/CUBOID.CPP", "\xef\xbb\xbfint a;\r\nint b;\r\n");
  dir.write("zip/Assignment4/collisionplane.h", "x");
  dir.write("zip/Assignment4/helpers.hpp", "x");
  dir.write("zip/Assignment4/PBFApp.cpp", "x");
  dir.write("zip/Assignment4/MAIN.cpp", "x");
  dir.write("zip/Assignment4/Debug/ParticleSystem.cpp", "x");
  dir.write("zip/Assignment4/old/Cuboid.cpp", "an old copy");
  dir.write("zip/report.pdf", "x");
  const auto s = open_submission(dir.path);
  ASSERT_TRUE(s) << s.fault().text();
  std::vector<std::string> names, others;
  for (const auto& f : s->files) names.push_back(f.name);
  for (const auto& f : s->others) others.push_back(f.name);
  EXPECT_THAT(names, ElementsAre("CollisionPlane.h", "Cuboid.cpp"));
  EXPECT_THAT(others, ElementsAre("helpers.hpp"));
  EXPECT_EQ(s->find("Cuboid.cpp")->text, "int a;\nint b;\n");
  EXPECT_EQ(s->find("Cuboid.cpp")->path, "zip/Assignment4/CUBOID.CPP");
  EXPECT_THAT(s->notes, ElementsAre(HasSubstr("old/Cuboid.cpp: not used")));
}

TEST(Submission, LeavesLinksAndStrangeFilesAside) {
  const Directory dir;
  dir.write("Cuboid.cpp", "x");
  fs::create_symlink("/etc/passwd", dir.path / "CollisionPlane.cpp");
  fs::create_directory_symlink("..", dir.path / "loop");
  dir.write("a\n\"quoted\"<b>\x1b[31m.cpp", "x");
  dir.write("binary.cpp", std::string("a\0b", 3));
  dir.write("big.cpp", std::string((1 << 20) + 1, 'x'));
  ASSERT_EQ(::system(("mkfifo " + (dir.path / "ParticleSystem.cpp").string()).c_str()), 0);
  const auto s = open_submission(dir.path);
  ASSERT_TRUE(s);
  EXPECT_EQ(s->files.size(), 1u);
  EXPECT_TRUE(s->others.empty());
  EXPECT_EQ(s->notes.size(), 6u) << "two links, a name, no text, too big, a pipe";
  for (const std::string& note : s->notes) EXPECT_EQ(note.find_first_of("\n\x1b"), note.npos) << note;
}

TEST(Submission, ThatIsNoneIsOneFault) {
  EXPECT_EQ(open_submission("/no/such/place").fault().text(), "/no/such/place does not exist");
  const Directory dir;
  EXPECT_THAT(open_submission(dir.path).fault().text(), HasSubstr("is empty"));
  fs::create_symlink("/etc/passwd", dir.path / "Cuboid.h");
  ASSERT_EQ(::mkfifo((dir.path / "pipe").c_str(), 0600), 0);
  EXPECT_THAT(open_submission(dir.path).fault().text(), HasSubstr("holds no file to grade (Cuboid.h: a symbolic link, not followed; and 1 more)"));
  dir.write("notes.txt", "x");
  EXPECT_THAT(open_submission(dir.path).fault().text(), HasSubstr("holds none of Cuboid, CollisionPlane"));
  dir.write("Cuboid.cpp", std::string("\xff\xfe\0", 3));
  fs::remove(dir.path / "Cuboid.h"), fs::remove(dir.path / "pipe");
  EXPECT_THAT(open_submission(dir.path).fault().text(), HasSubstr("(.h or .cpp) (Cuboid.cpp: not used, it is no text"));
  EXPECT_THAT(open_submission(dir.path / "notes.txt").fault().text(), HasSubstr("is neither a directory nor a .zip"));
}

TEST(Submission, HashFollowsEveryByteAndNothingElse) {
  const Directory a, b;
  a.write("Cuboid.cpp", "int a;\n");
  b.write("Cuboid.cpp", "int a;\r\n");
  EXPECT_EQ(open_submission(a.path)->hash, open_submission(b.path)->hash) << "line ends are no difference";
  b.write("Cuboid.cpp", "int b;\n");
  EXPECT_NE(open_submission(a.path)->hash, open_submission(b.path)->hash);
}

TEST(Hash, IsSha256) {  // examples of FIPS 180-4; the third needs a second block for its padding
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_NE(key_of("ab", "c"), key_of("a", "bc"));
}

// ---- Finding functions

std::vector<std::string> names_in(const std::string& text) {
  std::vector<std::string> names;
  for (const Definition& d : definitions_of(text)) names.push_back(d.name + (d.sound ? "" : "?"));
  return names;
}

TEST(Definitions, AreFoundAmongEverythingElseThatHasBraces) {
  EXPECT_THAT(names_in(R"cpp(
#define BODY {
// void Cuboid::commented() {
/* void Cuboid::commented() { */
const char* text = "void Cuboid::quoted() {";
static const int numbers[] = {1, 2, 3};
enum Colour { red, green };
namespace { struct Helper { int x = f({1}); int twice() const { return 2 * x; } }; }
class Cuboid : public Base {
 public:
  Cuboid() : a(1), b{2} { c = 3; }
  void inside() { if (a) { b = '}'; } }
  void declared(int);
};
Cuboid::Cuboid(double w)
    : width(w), names{"a", "b"}, height{w}
{
}
Cuboid::~Cuboid() {}
template <class T> std::vector<T> helper(const T& t = T{}) noexcept { return {t}; }
void Cuboid::update(double delta)  // the step
{
  const char* raw = R"x( } } )x";
  auto f = [&](int i) { return i; };
}
extern "C" { int c_function(void) { return 0; } }
)cpp"),
              ElementsAre("Helper::twice", "Cuboid::Cuboid", "Cuboid::inside", "Cuboid::Cuboid", "Cuboid::~Cuboid",
                          "helper", "Cuboid::update", "c_function"));
}

TEST(Definitions, OneMistypedBraceCostsOneFunction) {
  const std::string a = "void Cuboid::a() {\n  x;\n}\n", c = "void Cuboid::c() {\n  z;\n}\n";
  EXPECT_THAT(names_in(a + "V3D Cuboid::b(int i) {\n  if (i) {\n}\n" + c),
              ElementsAre("Cuboid::a", "Cuboid::b?", "Cuboid::c"));
  EXPECT_THAT(names_in(a + "V3D Cuboid::b(int i) {\n  if (i) }\n  y = 2;\n  for (;;) { y; }\n}\n" + c),
              ElementsAre("Cuboid::a", "Cuboid::b?", "Cuboid::c"));
  EXPECT_THAT(names_in(a + "V3D Cuboid::b(int i)\n{\n  y = \"no end;\n"), ElementsAre("Cuboid::a", "Cuboid::b?"));
}

TEST(Definitions, KeepTheirLinesWhenABodyIsReplaced) {
  const std::string text = "int a;\nint f() {\n  return\n  1; }\nint b;\n";
  const Definition f = definitions_of(text).at(0);
  EXPECT_EQ(f.first_line, 2);
  EXPECT_EQ(f.last_line, 4);
  EXPECT_EQ(with_body(text, f, "{ return 2; }"), "int a;\nint f() { return 2; }\n\n\nint b;\n");
}

TEST(Definitions, SurviveRubbish) {
  const std::string pieces[] = {"{",      "}",  "(",      ")",     "\"", "'",  "/*", "*/", "//", "\n", "#", "\\", "R\"(", ";",
                                "Cuboid", "::", "update", "class", "=",  "if", ":",  "~",  "[",  "]",  "<", " "};
  std::uint32_t seed = 1;
  for (int i = 0; i < 20000; ++i) {
    std::string text;
    for (int n = 0; n < 40; ++n) text += pieces[((seed = seed * 1664525u + 1013904223u) >> 16) % std::size(pieces)];
    for (const Definition& d : definitions_of(text)) {
      ASSERT_LE(d.begin, d.body) << text;
      ASSERT_LT(d.body, d.end) << text;
      ASSERT_LE(d.end, text.size()) << text;
      ASSERT_EQ(std::ranges::count(text, '\n'), std::ranges::count(with_body(text, d, "{}"), '\n')) << text;
    }
  }
}

TEST(Includes, AreWrittenAsThisMachineCallsTheFiles) {
  const std::vector<std::string> known{"MathLib/V3D.h", "GL/glew.h", "include/glew.h", "Cuboid.h"};
  EXPECT_EQ(with_plain_includes("#include \"..\\src\\mathlib\\v3d.H\"\n  # include <Include\\GLEW.h>\n"
                                "#include <gl/glew.h> // x\n#include <vector>\nx = \"#include <cuboid.h>\";\n"
                                "#include \"Assignment4/cuboid.h\"",
                                known),
            "#include \"MathLib/V3D.h\"\n  # include <include/glew.h>\n"
            "#include <GL/glew.h> // x\n#include <vector>\nx = \"#include <cuboid.h>\";\n"
            "#include \"Cuboid.h\"");
}

TEST(Stubs, AreRecognisedWhateverTheSpacesAndComments) {
  EXPECT_TRUE(is_handed_out(StudentFunction::update, "{\n  // TODO\n  /* later */ }"));
  EXPECT_FALSE(is_handed_out(StudentFunction::update, "{ netForce.zero(); }"));
  EXPECT_TRUE(is_handed_out(StudentFunction::world_inertia, "{ return Matrix3x3 :: Identity( ) ; }"));
  EXPECT_FALSE(is_handed_out(StudentFunction::world_inertia, "{ return bodyCoordsMOI; }"));
  EXPECT_TRUE(is_handed_out(StudentFunction::body_inertia,
                            "{ this->bodyCoordsMOI.setIdentity();\nbodyCoordsInverseMOI = bodyCoordsMOI.inverse(); }"));
}

TEST(Diagnostics, OfATemplateArePutWhereItWasAskedFor) {
  const auto all = diagnostics_of(
      "In file included from kit.hpp:1:\n"
      "/usr/include/eigen3/Eigen/Core:5:  required from 'class Eigen'\n"
      "Cuboid.cpp:45:20:   required from here\n"
      "/usr/include/eigen3/Eigen/Core:7:3: error: static assertion failed: SIZES\n"
      "Cuboid.cpp: In member function 'void Cuboid::update(double)':\n"
      "Cuboid.cpp:47:1: error: expected ';' before '}' token\n"
      "Cuboid.cpp:2:10: fatal error: windows.h: No such file or directory\n"
      "Elsewhere.cpp:9:1: error: not ours\n",
      {{"Cuboid.cpp", ""}});
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all[0].line, 45);
  EXPECT_EQ(all[0].message, "static assertion failed: SIZES");
  EXPECT_EQ(all[1].line, 47);
  EXPECT_EQ(all[2].missing, "windows.h");
  EXPECT_EQ(all[3].file, "");
}

// ---- Building

TEST(Build, OfAPartlyBrokenSubmissionCostsOnlyWhatIsBroken) {
  for (const std::string& name : samples_in("partial")) {
    const BuildResult b = built(samples() / "partial" / name);
    EXPECT_FALSE(b.executable.empty()) << name;
    std::vector<std::string> found, expected;
    for (const std::string& line : lines_of(samples() / "partial" / name / "EXPECT"))
      if (!line.starts_with('#')) expected.push_back(line);
    for (std::size_t i = 0; i < student_functions; ++i) {
      const FunctionStatus& f = b.functions[i];
      EXPECT_EQ(f.kind == Kind::not_compiled, !f.error.empty()) << name;
      if (f.kind != Kind::compiled)
        found.push_back(std::string(student_function_name(StudentFunction(i))) +
                        (f.kind == Kind::not_compiled ? " not-compiled" : " not-implemented"));
    }
    EXPECT_THAT(found, testing::UnorderedElementsAreArray(expected)) << name;
    Worker worker(b.executable, {});
    EXPECT_EQ(kind_of(worker.call(generic(Function::world_inertia))), "reply") << name;
  }
}

TEST(Build, SaysWhereTheFirstErrorIsAsTheStudentKnowsIt) {
  const BuildResult b = built(samples() / "partial" / "temporary-to-reference");
  const std::string& error = b.of(StudentFunction::plane_response).error;
  EXPECT_THAT(error, HasSubstr("CollisionPlane.cpp:30: cannot bind non-const lvalue reference"));
  EXPECT_THAT(error, HasSubstr("give the value a name first"));
  EXPECT_THAT(built(samples() / "partial" / "semicolon-missing").of(StudentFunction::update).error,
              HasSubstr("Cuboid.cpp:33: expected ';'"));
  EXPECT_THAT(built(samples() / "partial" / "whole-file-broken").of(StudentFunction::update).error, HasSubstr("Cuboid.cpp:1: expected primary-expression"));
}

TEST(Build, OfTheHandedOutFilesFindsEveryFunctionUnimplemented) {
  const BuildResult b = built(samples() / "kit");
  for (std::size_t i = 0; i < student_functions; ++i)
    EXPECT_EQ(b.functions[i].kind, Kind::not_implemented) << student_function_name(StudentFunction(i));
  EXPECT_FALSE(b.own_constants) << "the handed-out Constants.h is not the student's own";
}

TEST(Build, OfEveryRightAndWrongSampleCompilesEveryFunction) {
  for (const std::string room : {"right", "wrong"})
    for (const std::string& name : samples_in(room)) {
      const BuildResult b = built(samples() / room / name);
      EXPECT_FALSE(b.executable.empty()) << name;
      for (std::size_t i = 0; i < student_functions; ++i)
        EXPECT_EQ(b.functions[i].kind, Kind::compiled) << name << ": " << b.functions[i].error;
    }
}

TEST(Build, CompilesAgainOnlyWhatChanged) {
  // wrong/torque-kept differs from right/expressions in Cuboid.cpp alone, under the same headers
  const Directory cache;
  const BuildResult first = built(samples() / "right" / "expressions", {.cache = cache.path, .jobs = 2});
  const BuildResult second = built(samples() / "wrong" / "torque-kept", {.cache = cache.path});
  const BuildResult again = built(samples() / "right" / "expressions", {.cache = cache.path});
  EXPECT_EQ(first.compiled, 6) << "four files, the driver, the constants";
  EXPECT_EQ(second.compiled, 1);
  EXPECT_NE(first.executable, second.executable);
  EXPECT_EQ(again.compiled, 0);
  EXPECT_EQ(again.executable, first.executable);
}

TEST(Build, LeavesOutAFunctionOnRequest) {
  BuildOptions options;
  options.replaced = {StudentFunction::body_inertia};
  const BuildResult b = built(samples() / "right" / "expressions", options);
  EXPECT_EQ(b.of(StudentFunction::body_inertia).kind, Kind::not_compiled);
  Worker worker(b.executable, {});
  const Answer answer = worker.call(generic(Function::body_inertia));
  ASSERT_EQ(kind_of(answer), "reply");
  EXPECT_EQ(std::get<Reply>(answer).A.body_inertia[0], 1) << "the handed-out one gives the identity";
}

TEST(Build, KeepsASubmissionsOwnConstants) {
  const BuildResult b = built(samples() / "partial" / "own-constants");
  EXPECT_TRUE(b.own_constants);
  Constants constants;
  constants.restitution = 0.125;
  constants.delta_t = 0.5;
  Worker worker(b.executable, constants);
  const Answer answer = worker.call(generic(Function::constants));
  ASSERT_EQ(kind_of(answer), "reply");
  EXPECT_THAT(std::get<Reply>(answer).constants, ElementsAre(0.75, 0.6, 0.4, 0.5)) << "DELTA_T is not in theirs";
}

TEST(Build, NamesATemporaryDirectoryItCannotUse) {
  const char* before = std::getenv("TMPDIR");
  const std::string kept = before != nullptr ? before : "";
  setenv("TMPDIR", "/nonexist", 1);
  const auto result = build(*open_submission(samples() / "kit"), {});
  before != nullptr ? setenv("TMPDIR", kept.c_str(), 1) : unsetenv("TMPDIR");
  ASSERT_FALSE(result);
  EXPECT_EQ(result.fault().text(), "TMPDIR is /nonexist, must be a directory that can be written to");
}

TEST(Build, NamesACacheItCannotUse) {
  BuildOptions options;
  options.cache = "/proc/rigor";
  const auto result = build(*open_submission(samples() / "kit"), options);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.fault().kind, Fault::Kind::unwritable);
  EXPECT_THAT(result.fault().text(), HasSubstr("/proc/rigor cannot be used as a cache"));
}

}  // namespace
}  // namespace rigor::grader
