#include <gtest/gtest.h>

#include <cstdlib>
#include <future>
#include <regex>
#include <set>
#include <tests/layout/formulas.hpp>
#include <thread>

namespace rigor::layout {
namespace {

#ifdef __clang__
const std::string compiler = "clang++-14";
#else
const std::string compiler = "g++";
#endif

// src/contact/friction.hpp is <rigor/contact/friction.hpp>, reference/top.hpp is itself.
std::string spelling(const std::string& file) {
  return starts(file, "src/") ? "rigor/" + file.substr(4) : file;
}

/// An empty string, or what the compiler said.
std::string compile_alone(const std::string& file) {
  const std::filesystem::path log =
      std::filesystem::temp_directory_path() /
      ("rigor-header-" + std::to_string(std::hash<std::string>{}((binary / file).string())) + ".log");
  const std::string command =
      "echo '#include <" + spelling(file) + ">' | " + compiler +
      " -std=c++20 -fsyntax-only -Wall -Wextra -Wpedantic -Werror -DEIGEN_DONT_VECTORIZE -I '" +
      (binary / "include").string() + "' -I '" + source.string() +
      "' -isystem /usr/include/eigen3 -x c++ - >'" + log.string() + "' 2>&1";
  const int status = std::system(command.c_str());
  const std::string said = status == 0 ? "" : file + " does not compile alone:\n" + read(log).substr(0, 2000);
  std::filesystem::remove(log);
  return said;
}

/// Comments and string literals blanked out.
std::string code_of(const std::string& text) {
  return std::regex_replace(text, std::regex(R"(//[^\n]*|"(?:[^"\\\n]|\\.)*")"), " ");
}

bool has_decimal_literal(const std::string& text) {
  static const std::regex literal(R"((^|[^\w.])(\d+\.\d*|\.\d+|\d+[eE][-+]?\d+)(?![\w.]*\.hpp))");
  return std::regex_search(code_of(text), literal);
}

bool has_using_namespace(const std::string& text) {
  return std::regex_search(code_of(text), std::regex(R"(\busing\s+namespace\b)"));
}

std::vector<std::string> our_headers() {
  std::vector<std::string> headers = files_below("src", {".hpp"});
  for (const std::string& file : files_below("reference", {".hpp"})) headers.push_back(file);
  const auto students = [](const std::string& file) {
    return starts(file, "src/kit/");
  };  // written as they write
  headers.erase(std::remove_if(headers.begin(), headers.end(), students), headers.end());
  return headers;
}

}  // namespace

#ifdef __SANITIZE_ADDRESS__  // the release build's run has already asked the same compiler
constexpr bool may_try_all = false;
#else
constexpr bool may_try_all = true;
#endif

// Ten of them by default, evenly spread; all of them with RIGOR_ALL=1.
TEST(Headers, CompileAlone) {
  const std::vector<std::string> headers = our_headers();
  const std::size_t stride =
      may_try_all && std::getenv("RIGOR_ALL") ? 1 : std::max<std::size_t>(1, headers.size() / 10);
  const std::size_t at_once = std::max(1u, std::thread::hardware_concurrency());
  for (std::size_t i = 0; i < headers.size(); i += stride * at_once) {
    std::vector<std::future<std::string>> running;
    for (std::size_t k = i; k < headers.size() && running.size() < at_once; k += stride)
      running.push_back(std::async(std::launch::async, compile_alone, headers[k]));
    for (auto& result : running) EXPECT_EQ(result.get(), "");
  }
}

TEST(Headers, OpenNoNamespace) {
  for (const std::string& file : our_headers())
    EXPECT_FALSE(has_using_namespace(read(source / file))) << file;
  EXPECT_TRUE(has_using_namespace("#pragma once\nusing namespace std;\n"));
  EXPECT_FALSE(has_using_namespace("// using namespace is for .cpp files\n"));
}

// A formula for any scalar must not name a double. (A method that is one in double only may.)
TEST(Formulas, ForAnyScalarHaveNoDecimalLiteral) {
  std::set<std::string> generic;
  for (const Formula& f : all_formulas())
    if (!f.scalar.empty()) generic.insert(f.file);
  EXPECT_GE(generic.size(), 24u);
  for (const std::string& file : generic)
    EXPECT_FALSE(has_decimal_literal(read(source / file))) << file << ": write T(1) / T(2), not 0.5";
  for (const char* planted : {"return 0.5 * x;", "x = 1e-9;", "x > .5;", "return 2.*x;"})
    EXPECT_TRUE(has_decimal_literal(planted)) << planted;
  for (const char* fine :
       {"a[0] * b[1];  // 0.5", "#include <rigor/linalg/types.hpp>", "x1.y2 = v_r.dot(n);", "T(12)"})
    EXPECT_FALSE(has_decimal_literal(fine)) << fine;
}

// strict_test.cpp instantiates every formula that asks for no more than a Field with the scalar that can do
// no more.
TEST(Formulas, OnAFieldAreEachInstantiatedWithStrict) {
  const std::string strict = read(source / "tests/layout/strict_test.cpp");
  for (const Formula& f : all_formulas())
    EXPECT_TRUE(f.scalar != "Field" || strict.find(" " + f.function + "<Strict>(") != std::string::npos)
        << f.file << ": add an explicit instantiation of " << f.function
        << "<Strict> to tests/layout/strict_test.cpp";
}

}  // namespace rigor::layout
