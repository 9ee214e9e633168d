#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <rigor/report/formula.hpp>
#include <rigor/report/texts.hpp>
#include <set>
#include <sstream>

namespace rigor::report {
namespace {

// The ids of the formulas, from their headers.
std::set<std::string> header_ids() {
  std::set<std::string> ids;
  for (const auto& file : std::filesystem::directory_iterator(RIGOR_SOURCE_DIR "/src/formulas")) {
    std::ifstream in(file.path());
    for (std::string line, slashes, id, word; std::getline(in, line);)
      if (std::istringstream words(line); words >> slashes >> word >> id && slashes == "///" && word == "id") ids.insert(id);
  }
  return ids;
}

TEST(Formula, OfTheListIsAFormulaOfTheSource) {
  const std::set<std::string> known = header_ids();
  ASSERT_GT(known.size(), 20u);
  for (const std::string& id : formula_ids()) EXPECT_EQ(known.count(id), 1u) << id;
  EXPECT_GT(formula_ids().size(), 20u);
}

TEST(Formula, IsMathMLWithItsTeXOrPlainText) {
  const bool bundled = !text_named("formulas.mathml", texts()).empty();
  for (const std::string& id : formula_ids()) {
    EXPECT_NE(formula_text(id), "") << id;
    const std::string html = formula_html(id);
    EXPECT_EQ(html.rfind(bundled ? "<math" : "<code>", 0), 0u) << id;
    EXPECT_EQ(html.find("application/x-tex") != std::string::npos, bundled) << id;
    EXPECT_EQ(html.find("<span"), std::string::npos) << id;  // no markup but MathML
  }
  EXPECT_EQ(formula_html("inertia"), "");  // the beginning of an id is none
}

}  // namespace
}  // namespace rigor::report
