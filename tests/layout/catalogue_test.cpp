#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <regex>
#include <set>
#include <tests/layout/text.hpp>

// The verification catalogue: every case id has a test, or the reason why it has none yet, never both. Tests
// name the ids they cover ("case FB-05"); tests/mutants names them as oracles and does not count.
namespace rigor::layout {
namespace {

const std::string command = "RIGOR_WRITE=1 build/release/tests/test_layout --gtest_filter='Catalogue.*'";
const char* const heading =
    "# id\twhat is checked\twhy none yet (empty when a test under tests/ names the id)\n";

struct Case {
  std::string id, description, why_none;
  std::vector<std::string> tests;
};

// Lines "id <tab> description [<tab> why none yet]"; "#" starts a comment.
std::vector<Case> cases_in(const std::string& text) {
  std::vector<Case> cases;
  for (const std::string& line : lines_of(text)) {
    if (line.empty() || line[0] == '#') continue;
    Case one;
    std::istringstream fields(line);
    std::getline(fields, one.id, '\t');
    std::getline(fields, one.description, '\t');
    std::getline(fields, one.why_none, '\t');
    cases.push_back(one);
  }
  return cases;
}

std::set<std::string> ids_in(const std::string& text) {
  static const std::regex id(R"(\b(?:I|K|D|FB|F|P|FR|BB|ST|E|S)-\d\d\b)");
  std::set<std::string> found;
  for (auto m = std::sregex_iterator(text.begin(), text.end(), id); m != std::sregex_iterator(); ++m)
    found.insert(m->str());
  return found;
}

std::vector<Case> catalogue() {
  std::vector<Case> cases = cases_in(read(source / "tests/catalogue.tsv"));
  for (const std::string& file : files_below("tests", {".cpp", ".hpp"})) {
    if (starts(file, "tests/layout/") || starts(file, "tests/mutants/")) continue;
    const std::set<std::string> ids = ids_in(read(source / file));
    for (Case& one : cases)
      if (ids.count(one.id)) one.tests.push_back(file);
  }
  return cases;
}

std::vector<std::string> complaints(const std::vector<Case>& cases) {
  std::vector<std::string> all;
  std::set<std::string> seen;
  for (const Case& one : cases) {
    if (!seen.insert(one.id).second) all.push_back(one.id + ": listed twice");
    if (one.description.empty()) all.push_back(one.id + ": no description");
    if (one.tests.empty() && one.why_none.empty())
      all.push_back(one.id + ": no test names it, and tests/catalogue.tsv gives no reason");
    if (!one.tests.empty() && !one.why_none.empty())
      all.push_back(one.id + ": " + one.tests.front() + " names it, so its reason must go: " + command);
  }
  return all;
}

std::string table(const std::vector<Case>& cases) {
  std::string text = heading;
  for (const Case& one : cases)
    text += one.id + "\t" + one.description + (one.why_none.empty() ? "" : "\t" + one.why_none) + "\n";
  return text;
}

std::string page(const std::vector<Case>& cases) {
  std::string text = "# Verification cases and their tests\n\nWritten by `" + command +
                     "`; not edited by hand.\n" +
                     "A case has a test, or the reason why it has none yet (tests/catalogue.tsv).\n\n" +
                     "| case | what is checked | tests |\n|---|---|---|\n";
  for (const Case& one : cases) {
    text += "| " + one.id + " | " + one.description + " | ";
    for (std::size_t i = 0; i < one.tests.size(); ++i)
      text += (i ? ", `" : "`") + one.tests[i].substr(6) + "`";
    if (one.tests.empty()) text += "none yet: " + one.why_none;
    text += " |\n";
  }
  return text;
}

}  // namespace

// RIGOR_WRITE=1 mends a reason that a test has overtaken, and a stale page.
TEST(Catalogue, GivesEveryCaseATestOrAReason) {
  std::vector<Case> cases = catalogue();
  if (std::getenv("RIGOR_WRITE")) {
    for (Case& one : cases)
      if (!one.tests.empty()) one.why_none.clear();
    std::ofstream(source / "tests/catalogue.tsv") << table(cases);
    std::ofstream(source / "docs/catalogue.md") << page(cases);
  }
  EXPECT_EQ(cases.size(), 128u);
  std::vector<std::string> all = complaints(cases);
  if (read(source / "docs/catalogue.md") != page(cases))
    all.push_back("docs/catalogue.md is stale: " + command);
  for (const std::string& line : all) ADD_FAILURE() << line;
  const auto tested =
      std::count_if(cases.begin(), cases.end(), [](const Case& one) { return !one.tests.empty(); });
  std::printf("%ld of %zu cases have a test; the others a reason\n", long(tested), cases.size());
}

TEST(Catalogue, SeesGapsAndContradictions) {
  Case covered{"FB-05", "box", "", {"tests/a.cpp"}}, excused{"FB-06", "flip", "needs the located mode", {}};
  EXPECT_TRUE(complaints({covered, excused}).empty());
  excused.why_none.clear();
  EXPECT_EQ(complaints({covered, excused}).size(), 1u);
  covered.why_none = "later";
  EXPECT_EQ(complaints({covered}).size(), 1u);
  EXPECT_EQ(complaints({excused, excused}).size(), 3u);
  EXPECT_EQ(ids_in("// case FB-05, P-01: a test (UTF-08, AFB-05, FB-055 are none)"),
            (std::set<std::string>{"FB-05", "P-01"}));
  const auto read_back = cases_in("# comment\nD-02\tfall\nD-03\tspring\tnone yet\n");
  ASSERT_EQ(read_back.size(), 2u);
  EXPECT_EQ(read_back[0].why_none, "");
  EXPECT_EQ(read_back[1].why_none, "none yet");
}

}  // namespace rigor::layout
