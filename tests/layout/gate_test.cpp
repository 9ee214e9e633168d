#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <set>
#include <sstream>
#include <tests/layout/formulas.hpp>

// Every formula has one id, a derivation and an exact test. This reads text; what the derivation and the test
// say is for a reader to judge.
namespace rigor::layout {
namespace {

const char* const id_pattern = "[a-z][a-z0-9_]*(?:\\.[a-z0-9_]+)+";

/// "## `inertia.cuboid`" of a derivation, with the parts its section has.
std::map<std::string, std::set<std::string>> derivations_in(const std::string& text) {
  const std::regex heading("^## `(" + std::string(id_pattern) + ")`$"),
      part(R"(^\*\*(Assumptions|Steps|Not claimed|Source)\b.*)");
  std::map<std::string, std::set<std::string>> found;
  std::string id;
  for (const std::string& line : lines_of(text)) {
    std::smatch match;
    if (starts(line, "#")) id = std::regex_match(line, match, heading) ? match[1].str() : "";
    if (id.empty()) continue;
    found[id];
    if (std::regex_match(line, match, part)) found[id].insert(match[1]);
  }
  return found;
}

/// Ids of "// id: a.b, c.d" comments that stand above a test; `floating` gets those that do not.
std::set<std::string> tags_in(const std::string& text, std::vector<std::string>* floating) {
  std::set<std::string> found, pending;
  for (const std::string& line : lines_of(text)) {
    if (starts(line, "// id:")) {
      const std::regex id(id_pattern);
      for (auto m = std::sregex_iterator(line.begin(), line.end(), id); m != std::sregex_iterator(); ++m)
        pending.insert(m->str());
    } else if (starts(line, "TEST(") || starts(line, "TEST_P(") || starts(line, "RC_GTEST_PROP(")) {
      found.merge(pending);
      pending.clear();
    } else if (!starts(line, "//") && !pending.empty()) {
      floating->insert(floating->end(), pending.begin(), pending.end());
      pending.clear();
    }
  }
  floating->insert(floating->end(), pending.begin(), pending.end());
  return found;
}

struct Tree {
  std::map<std::string, int> ids;  // id -> how many functions carry it
  std::map<std::string, std::set<std::string>> derivations;
  std::set<std::string> tests;
  std::vector<std::string> floating, without_id;
};

Tree read_tree() {
  Tree tree;
  for (const Formula& f : all_formulas()) {
    for (const std::string& id : f.ids) ++tree.ids[id];
    if (f.ids.empty() && f.no_id.empty()) tree.without_id.push_back(f.file + ": " + f.function);
  }
  for (const std::string& file : files_below("proofs", {".md"}))
    tree.derivations.merge(derivations_in(read(source / file)));
  for (const std::string& file : files_below("tests/exact", {".cpp"}))
    tree.tests.merge(tags_in(read(source / file), &tree.floating));
  return tree;
}

std::vector<std::string> complaints(const Tree& tree) {
  std::vector<std::string> all;
  for (const auto& [id, count] : tree.ids) {
    if (count > 1) all.push_back(id + ": defined " + std::to_string(count) + " times");
    const auto derivation = tree.derivations.find(id);
    if (derivation == tree.derivations.end())
      all.push_back(id + ": no heading ## `" + id + "` in proofs/*.md");
    else
      for (const char* part : {"Assumptions", "Steps", "Not claimed", "Source"})
        if (!derivation->second.count(part)) all.push_back(id + ": its derivation lacks **" + part + ".**");
    if (!tree.tests.count(id))
      all.push_back(id + ": no test under a line '// id: " + id + "' in tests/exact");
  }
  for (const auto& [id, parts] : tree.derivations)
    if (!tree.ids.count(id)) all.push_back(id + ": a derivation of a formula that is gone");
  for (const std::string& id : tree.tests)
    if (!tree.ids.count(id)) all.push_back(id + ": a test of a formula that is gone");
  for (const std::string& id : tree.floating)
    all.push_back(id + ": its tag in tests/exact does not stand on a test");
  for (const std::string& function : tree.without_id)
    all.push_back(function + " carries no id (write `/// id  topic.name`, or `/// no id  reason`)");
  return all;
}

bool complains(const Tree& tree, const std::string& about) {
  for (const std::string& line : complaints(tree))
    if (line.find(about) != std::string::npos) return true;
  return false;
}

}  // namespace

TEST(Gate, EveryFormulaHasOneIdADerivationAndAnExactTest) {
  const Tree tree = read_tree();
  for (const auto& [id, count] : tree.ids)
    std::printf("%-34s derivation %-3s  exact test %-3s\n", id.c_str(),
                tree.derivations.count(id) ? "yes" : "NO", tree.tests.count(id) ? "yes" : "NO");
  for (const Formula& f : all_formulas())
    if (!f.no_id.empty()) std::printf("%-34s no id: %s\n", f.function.c_str(), f.no_id.c_str());
  EXPECT_GE(tree.ids.size(), 26u);  // the assignment's formulas were found at all
  for (const std::string& line : complaints(tree)) ADD_FAILURE() << line;
}

TEST(Gate, SeesEachKindOfGap) {
  Tree whole;
  whole.ids = {{"a.b", 1}};
  whole.derivations = {{"a.b", {"Assumptions", "Steps", "Not claimed", "Source"}}};
  whole.tests = {"a.b"};
  EXPECT_TRUE(complaints(whole).empty());

  Tree tree = whole;
  tree.ids["a.b"] = 2;
  EXPECT_TRUE(complains(tree, "defined 2 times"));
  tree = whole, tree.derivations.clear();
  EXPECT_TRUE(complains(tree, "no heading"));
  tree = whole, tree.derivations["a.b"].erase("Not claimed");
  EXPECT_TRUE(complains(tree, "lacks **Not claimed"));
  tree = whole, tree.tests.clear();
  EXPECT_TRUE(complains(tree, "no test under"));
  tree = whole, tree.ids.clear();
  EXPECT_TRUE(complains(tree, "a derivation of a formula that is gone"));
  EXPECT_TRUE(complains(tree, "a test of a formula that is gone"));
  EXPECT_TRUE(tags_in("// id: a.b\n\nint x;\nTEST(A, B) {\n", &tree.floating).empty());
  EXPECT_TRUE(complains(tree, "does not stand on a test"));

  const auto untagged = formulas_in("f.hpp", "/// A law.\ntemplate <Field T>\nT law(const T& x) {\n");
  ASSERT_EQ(untagged.size(), 1u);
  EXPECT_EQ(untagged[0].function, "law");
  EXPECT_EQ(untagged[0].scalar, "Field");
  EXPECT_TRUE(untagged[0].ids.empty());
  const auto tagged = formulas_in(
      "f.hpp", "/// id        a.b\n/// source    x\ntemplate <Field T>\nVec3<T> law(const T& x) {\n");
  EXPECT_EQ(tagged.at(0).ids, std::vector<std::string>{"a.b"});
  const auto excused =
      formulas_in("f.hpp", "/// no id  sums two others\ntemplate <Field T>\nT law(const T& x) {\n");
  EXPECT_EQ(excused.at(0).no_id, "sums two others");
  EXPECT_TRUE(formulas_in("f.hpp", "template <Field T>\nstruct State {\n").empty());
  EXPECT_EQ(formulas_in("f.hpp", "/// A law.\ninline double law(double x) {\n").at(0).function, "law");
  EXPECT_TRUE(formulas_in("f.hpp", "namespace detail {\ninline double law(double x) {\n").empty());
}

// Outside src/formulas, templates on a scalar have no docstring with ids; why not stands in without_id.txt.
TEST(Gate, TemplatesOnAScalarElsewhereHaveAWrittenReasonForNoId) {
  std::map<std::string, std::set<std::string>> excused;
  for (const std::string& line : lines_of(read(source / "tests/layout/without_id.txt"))) {
    static const std::regex entry(R"(^(src/\S+) \| ([\w ]+) \| \S.*)");
    std::smatch match;
    if (line.empty() || line[0] == '#') continue;
    ASSERT_TRUE(std::regex_match(line, match, entry)) << line;
    std::istringstream names(match[2]);
    for (std::string name; names >> name;) EXPECT_TRUE(excused[match[1]].insert(name).second) << line;
  }
  std::size_t seen = 0;
  for (const std::string& file : files_below("src", {".hpp"})) {
    if (starts(file, "src/formulas/")) continue;
    std::set<std::string> here;
    for (const Formula& f : formulas_in(file, read(source / file)))
      if (f.scalar == "Field" || f.scalar == "Real") here.insert(f.function);
    seen += here.size();
    for (const std::string& function : here)
      EXPECT_TRUE(excused[file].count(function)) << file << ": " << function
                                                 << " carries no id and no reason in tests/layout/without_id.txt";
    for (const std::string& function : excused[file])
      EXPECT_TRUE(here.count(function)) << file << ": " << function << " is excused and gone";
    excused.erase(file);
  }
  for (const auto& [file, functions] : excused) ADD_FAILURE() << file << " is excused and gone";
  EXPECT_GE(seen, 15u);  // they were found at all
}

// Names in code font in proofs and errata: `topic.name` is a formula, and "erratum NAME" in a header a
// heading there.
TEST(Gate, NamesInDerivationsAndErrataResolve) {
  const Tree tree = read_tree();
  std::set<std::string> anchors;
  const std::string errata = read(source / "reference/errata.md");
  for (const std::string& line : lines_of(errata)) {
    std::smatch match;
    if (!std::regex_search(line, match, std::regex("^#+ .*`([a-z0-9-]+)`"))) continue;
    EXPECT_TRUE(anchors.insert(match[1]).second) << match[1] << " is a heading twice";
  }
  EXPECT_GE(anchors.size(), 20u);

  const std::regex formula_name("`(" + std::string(id_pattern) + ")`"),
      cited(R"(errat(?:um|a) ([a-z]+-[a-z-]+|restitution)(?: and ([a-z]+-[a-z-]+))?)");
  std::vector<std::string> pages = files_below("proofs", {".md"});
  pages.push_back("reference/errata.md");
  for (const std::string& file : pages) {
    const std::string text = read(source / file);
    for (auto m = std::sregex_iterator(text.begin(), text.end(), formula_name); m != std::sregex_iterator();
         ++m) {
      const std::string name = (*m)[1];
      const std::string ending = name.substr(name.rfind('.') + 1);
      if (ending == "md" || ending == "hpp" || ending == "cpp" || ending == "v" || ending == "txt") continue;
      EXPECT_TRUE(tree.ids.count(name)) << file << ": `" << name << "` is no formula";
    }
  }
  int citations = 0;
  for (const std::string& file : files_below("src", {".hpp"})) {
    const std::string text = read(source / file);
    for (auto m = std::sregex_iterator(text.begin(), text.end(), cited); m != std::sregex_iterator(); ++m)
      for (int k : {1, 2})
        if ((*m)[k].matched) {
          ++citations;
          EXPECT_TRUE(anchors.count((*m)[k]))
              << file << ": erratum " << (*m)[k] << " has no heading in reference/errata.md";
        }
  }
  EXPECT_GE(citations, 8);
}

}  // namespace rigor::layout
