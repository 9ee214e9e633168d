#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>
#include <tests/layout/text.hpp>

// Which layer may include which: the list CMake wrote (rigor_layer in CMakeLists.txt) against the #include
// lines.
namespace rigor::layout {
namespace {

struct Layer {
  std::string directory;
  std::set<std::string> sees;
};

// Lines "name directory seen,seen".
std::map<std::string, Layer> layers_in(const std::string& text) {
  std::map<std::string, Layer> layers;
  for (const std::string& line : lines_of(text)) {
    std::istringstream words(line);
    std::string name, directory, sees, seen;
    words >> name >> directory >> sees;
    if (name.empty()) continue;
    Layer layer{directory, {name}};
    for (std::istringstream list(sees); std::getline(list, seen, ',');) layer.sees.insert(seen);
    layers[name] = layer;
  }
  return layers;
}

// "#include <rigor/contact/friction.hpp>" -> contact, "#include <reference/top.hpp>" -> reference.
std::vector<std::string> layers_included_by(const std::string& text) {
  static const std::regex include(R"(^\s*#\s*include\s*[<"](?:rigor/(\w+)|(reference|tests))/.*)");
  std::vector<std::string> included;
  for (const std::string& line : lines_of(text)) {
    std::smatch match;
    if (std::regex_match(line, match, include)) included.push_back(match[1].matched ? match[1] : match[2]);
  }
  return included;
}

std::vector<std::string> complaints(const std::string& name, const Layer& layer, const std::string& text) {
  std::vector<std::string> all;
  for (const std::string& included : layers_included_by(text))
    if (!layer.sees.count(included)) all.push_back("layer " + name + " does not see " + included);
  return all;
}

}  // namespace

TEST(Layers, IncludeOnlyWhatTheListLetsThemSee) {
  const auto layers = layers_in(read(binary / "layers.txt"));
  ASSERT_GE(layers.size(), 5u);
  for (const auto& [name, layer] : layers)
    for (const std::string& file : files_below(layer.directory, {".hpp", ".cpp", ".h"}))
      for (const std::string& line : complaints(name, layer, read(source / file)))
        ADD_FAILURE() << file << ": " << line;
}

TEST(Layers, CoverEveryDirectoryOfTheSource) {
  std::set<std::string> known;
  for (const auto& [name, layer] : layers_in(read(binary / "layers.txt"))) known.insert(layer.directory);
  for (const auto& entry : std::filesystem::directory_iterator(source / "src")) {
    const std::string directory = "src/" + entry.path().filename().string();
    EXPECT_TRUE(!entry.is_directory() || known.count(directory))
        << directory << " is no layer of CMakeLists.txt";
  }
}

TEST(Layers, CheckSeesAnIncludeAgainstTheCurrent) {
  const auto layers = layers_in("formulas src/formulas linalg,scalar\nreference reference linalg,scalar\n");
  EXPECT_EQ(complaints("formulas", layers.at("formulas"), "#include <rigor/contact/solve.hpp>\n").size(), 1u);
  EXPECT_EQ(complaints("formulas", layers.at("formulas"), "#include <tests/exact/draw.hpp>\n").size(), 1u);
  EXPECT_EQ(complaints("formulas", layers.at("formulas"), "#include <reference/top.hpp>\n").size(), 1u);
  EXPECT_EQ(complaints("reference", layers.at("reference"), "#include \"rigor/formulas/state.hpp\"\n").size(),
            1u);
  EXPECT_TRUE(
      complaints("formulas", layers.at("formulas"), "#include <rigor/linalg/types.hpp>\n#include <vector>\n")
          .empty());
}

}  // namespace rigor::layout
