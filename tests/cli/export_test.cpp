// What `rigor export` writes, run by its entry scripts as the platforms run them.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <rigor/base/file.hpp>
#include <rigor/grader/archive.hpp>
#include <rigor/grader/check.hpp>
#include <set>
#include <sstream>
#include <string>
#include <tests/cli/shell.hpp>

namespace rigor {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class Export : public ::testing::Test {
 protected:
  void SetUp() override {
    dir = fs::temp_directory_path() / ("rigor-export-test-" + std::to_string(::getpid()));
    fs::create_directories(dir);
    fs::permissions(dir, fs::perms(0755));
    EXPECT_TRUE(write_file(dir / "rubric.toml", "seed = 77  # secret\ncases = 5\n[points]\n\"force.sum\" = 6\n"));
  }
  void TearDown() override { fs::remove_all(dir); }
  void exported(const std::string& what) {
    const Ran ran = sh(std::string(RIGOR_BINARY_DIR) + "/rigor export " + what + " " + (dir / what).string() + " --rubric " + (dir / "rubric.toml").string());
    ASSERT_EQ(ran.status, 0) << ran.text;
  }
  // As tar and unzip would.
  void unpack(const fs::path& archive, const fs::path& to) {
    const auto read = grader::read_archive(archive, {.packed_bytes = 1u << 30, .unpacked_bytes = 1u << 30, .file_bytes = 1u << 30, .entries = 10000});
    ASSERT_TRUE(read) << read.fault().text();
    for (const auto& file : read->files) {
      ASSERT_TRUE(write_file(to / file.path, file.bytes));
      fs::permissions(to / file.path, fs::perms(0755));
    }
  }
  static fs::path sample(const std::string& name) { return fs::path(RIGOR_SOURCE_DIR) / "tests/submissions" / name; }
  fs::path dir;
};

TEST_F(Export, WritesNoProgramThatLinksGslOrSundials) {
  const Ran ran = sh("ldd " + std::string(RIGOR_BINARY_DIR) + "/rigor-grader");
  for (const char* library : {"gsl", "sundials", "mpfr", "gmp"}) EXPECT_EQ(ran.text.find(library), std::string::npos) << ran.text;
  EXPECT_NE(ran.text.find("libc.so"), std::string::npos);
}

TEST_F(Export, KitGradesItselfForPracticeAndKeepsTheGradedSeed) {
  exported("kit");
  const fs::path kit = dir / "kit";
  for (const auto& item : fs::recursive_directory_iterator(kit))
    if (item.is_regular_file() && item.path().extension() != ".so") {
      std::ifstream file(item.path(), std::ios::binary);  // a program built with sanitizers is larger than read_file takes
      ASSERT_TRUE(file);
      const std::string text(std::istreambuf_iterator<char>(file), {});
      EXPECT_EQ(text.find("seed = 77"), std::string::npos) << item.path();
    }
  const std::string instructions = *read_file(kit / "README.md");
  for (const char* said : {"x86-64", "WSL", "linux/amd64"}) EXPECT_NE(instructions.find(said), std::string::npos) << said;
  fs::copy(sample("wrong/torque-kept"), kit / "src", fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  const Ran ran = sh("cd / && RIGOR_CACHE=" + (dir / "cache").string() + " " + (kit / "practice").string() + " --json");
  EXPECT_EQ(ran.status, 0);
  const json report = json::parse(ran.text, nullptr, false);
  ASSERT_TRUE(report.is_object()) << ran.text;
  EXPECT_EQ(report["seed"], 1);
  EXPECT_EQ(report["max_score"], 102) << "the course's points";
  const Ran seeded = sh("RIGOR_CACHE=" + (dir / "cache").string() + " " + (kit / "practice").string() + " --seed 77 --out " + (dir / "page").string());
  EXPECT_EQ(seeded.status, 2);
  EXPECT_NE(seeded.text.find("--seed: ./practice has one seed"), std::string::npos) << seeded.text;
  EXPECT_FALSE(fs::exists(dir / "page"));
  const Ran unknown = sh((kit / "practice").string() + " --check force.smu");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_EQ(unknown.text, "./practice: --check: there is no check 'force.smu' (did you mean 'force.sum'?); rigor/rubric.toml lists them\n");
  const Ran ours = sh("RIGOR_CACHE=" + (dir / "cache").string() + " " RIGOR_BINARY_DIR "/rigor grade " + sample("wrong/torque-kept").string() + " --practice --json --rubric " + (dir / "rubric.toml").string() + " 2>/dev/null");  // which says that the points add up to 102
  const json here = json::parse(ours.text, nullptr, false);
  ASSERT_TRUE(here.is_object()) << ours.text;
  ASSERT_EQ(here["checks"].size(), report["checks"].size());
  for (std::size_t i = 0; i < here["checks"].size(); ++i)
    for (const char* key : {"id", "verdict", "points"}) EXPECT_EQ(here["checks"][i][key], report["checks"][i][key]) << here["checks"][i]["id"];
  for (const json& check : report["checks"])
    if (check["id"] == "update.clears") {
      EXPECT_EQ(check["verdict"], "fail");
    }
}

TEST_F(Export, PracticeSaysThatTheCourseHasOtherChecks) {
  for (const bool hidden : {false, true}) {
    EXPECT_TRUE(write_file(dir / "hides.toml", std::string("seed = 77\n") + (hidden ? "[visibility]\n\"update.clears\" = \"hidden\"\n" : "")));
    const std::string room = (dir / (hidden ? "some" : "all")).string();
    ASSERT_EQ(sh(std::string(RIGOR_BINARY_DIR) + "/rigor export kit " + room + " --rubric " + (dir / "hides.toml").string()).status, 0);
    const auto rubric = read_file(fs::path(room) / "rigor" / "rubric.toml");
    ASSERT_TRUE(rubric);
    EXPECT_EQ(rubric->find("update.clears") == std::string::npos, hidden) << *rubric;
    const Ran ran = sh("RIGOR_CACHE=" + (dir / "cache").string() + " " + room + "/practice --cases 1");
    EXPECT_EQ(ran.status, 0) << ran.text;
    EXPECT_EQ(ran.text.find("the course also grades by checks that are not part of this practice") != std::string::npos, hidden) << ran.text;
  }
}

TEST_F(Export, AutolabLabEndsWithTheTwoLinesWhateverIsHandedIn) {
  exported("autolab");
  unpack(dir / "autolab" / "rigor.tar", dir / "lab");
  const fs::path lab = dir / "lab" / "rigor", job = dir / "job";
  for (const char* name : {"rigor.yml", "rigor.rb", "autograde-Makefile", "autograde.tar"}) ASSERT_TRUE(fs::exists(lab / name)) << name;
  fs::create_directories(job);
  fs::copy(lab / "autograde-Makefile", job / "Makefile");
  fs::copy(lab / "autograde.tar", job / "autograde.tar");
  std::set<std::string> problems;
  std::istringstream yml(*read_file(lab / "rigor.yml"));
  for (std::string line; std::getline(yml, line);)
    if (line.starts_with("- name: ")) problems.insert(line.substr(8));

  const auto scores_of = [&](const std::string& handin) {
    EXPECT_TRUE(write_file(job / "handin.zip", handin));
    const Ran ran = sh("cd " + job.string() + " && RIGOR_CACHE=" + (dir / "cache").string() + " make");
    EXPECT_EQ(ran.status, 0) << "any other status loses the scores";
    const std::string text = ran.text.substr(0, ran.text.find_last_not_of('\n') + 1);
    const std::size_t last = text.rfind('\n'), before = text.rfind('\n', last - 1);
    EXPECT_TRUE(json::accept(text.substr(before + 1, last - before - 1))) << text;
    const json scores = json::parse(text.substr(last + 1), nullptr, false);
    EXPECT_TRUE(scores.contains("scores")) << text;
    std::set<std::string> named;
    for (const auto& [name, score] : scores["scores"].items()) named.insert(name);
    EXPECT_EQ(named, problems) << "an unknown problem breaks all feedback";
    return scores["scores"];
  };
  const json none = scores_of("no archive at all");
  for (const auto& [name, score] : none.items()) EXPECT_EQ(score, 0) << name;

  const std::string zip = (job / "handin.zip").string();
  ASSERT_EQ(sh("cd " + sample("wrong/torque-kept").string() + " && python3 -c \"import shutil; shutil.make_archive('" + zip.substr(0, zip.size() - 4) + "', 'zip', '.')\"").status, 0);
  const json some = scores_of(*read_file(zip));
  scores_of("no archive at all");
  EXPECT_FALSE(fs::exists(job / "out" / "report.txt")) << "the report of the hand-in before";
  const std::string instructions = *read_file(dir / "autolab" / "README.md");
  for (const char* said : {"Import from tarball", "102 points", "seed", "rigor export autolab", "300 s"}) EXPECT_NE(instructions.find(said), std::string::npos) << said;
  EXPECT_EQ(some["Force"], 12) << "force.sum is 6 in this rubric";
  EXPECT_EQ(some["Dynamics"], 28) << "update.clears fails";
}

// In a root of its own that has a compiler, and neither our libraries nor Eigen.
TEST_F(Export, GradescopeAutograderRunsWhereOnlyACompilerIs) {
  exported("gradescope");
  const fs::path root = dir / "autograder";
  unpack(dir / "gradescope" / "autograder.zip", root / "source");
  fs::create_directories(root / "results");
  fs::create_directories(root / "submission");
  const std::string inside = "bwrap --unshare-all --ro-bind /usr /usr --symlink usr/lib /lib --symlink usr/lib64 /lib64 --symlink usr/bin /bin --proc /proc --dev /dev "
                             "--tmpfs /tmp --tmpfs /usr/include/eigen3 --ro-bind /dev/null /usr/lib/x86_64-linux-gnu/libarchive.so.13 --bind " + root.string() +
                             " /autograder --clearenv --setenv PATH /usr/bin:/bin ";
  if (sh(inside + "/bin/true").status != 0) GTEST_SKIP() << "this machine has no namespaces to make a root with";
  const auto results = [&] {
    const Ran ran = sh(inside + "/autograder/source/run_autograder");
    const auto text = read_file(root / "results/results.json");
    return json::parse(text ? *text : "no results: " + ran.text, nullptr, false);
  };
  const json empty = results();
  ASSERT_TRUE(empty.is_object());
  EXPECT_EQ(empty["score"], 0);
  EXPECT_NE(empty["tests"][0]["output"].get<std::string>().find("is empty"), std::string::npos);

  fs::copy(sample("wrong/torque-kept"), root / "submission");
  const json full = results();
  ASSERT_TRUE(full.is_object());
  double score = 0;
  for (const json& test : full["tests"]) score += test.value("score", 0.0);
  EXPECT_EQ(score, 100) << "102 of this rubric less the 2 of update.clears";
  const std::string instructions = *read_file(dir / "gradescope" / "README.md");
  for (const char* said : {"upload `autograder.zip`", "102 points", "seed", "rigor export gradescope", "10 minutes"}) EXPECT_NE(instructions.find(said), std::string::npos) << said;
  for (const char* script : {"setup.sh", "run_autograder"}) EXPECT_TRUE(fs::exists(root / "source" / script));
}

TEST_F(Export, WritesOverNothing) {
  EXPECT_TRUE(write_file(dir / "work" / "src" / "Cuboid.cpp", "a student's\n"));
  for (const char* what : {"kit", "autolab", "gradescope"}) {
    const Ran ran = sh(std::string(RIGOR_BINARY_DIR) + "/rigor export " + what + " " + (dir / "work").string());
    EXPECT_EQ(ran.status, 2) << what;
    EXPECT_NE(ran.text.find("is not empty, must be a new or an empty directory"), std::string::npos) << ran.text;
  }
  EXPECT_EQ(*read_file(dir / "work" / "src" / "Cuboid.cpp"), "a student's\n");
  EXPECT_EQ(std::distance(fs::recursive_directory_iterator(dir / "work"), {}), 2);
}

TEST_F(Export, RefusesBeforeItWritesAnything) {
  const std::string x = (dir / "x").string(), bad = (dir / "bad.toml").string(), file = (dir / "rubric.toml").string();
  EXPECT_TRUE(write_file(bad, "seeed = 3\n"));
  const std::pair<std::string, std::string> wrong[] = {
      {"autolap " + x, "did you mean 'autolab'?"},
      {"kit " + x + " --rubric " + bad, "did you mean 'seed'?"},
      {"gradescope " + x + " --rubric /nowhere.toml", "/nowhere.toml does not exist"},
      {"autolab " + file, "must be a new or an empty directory"},
      {"kit " + file + "/below", "cannot be written"},
      {"gradescope " + file + "/below", "cannot be written"},
      {"autolab " + file + "/below", "cannot be written"},
      {"kit", "DIR is required"},
  };
  for (const auto& [arguments, says] : wrong) {
    const Ran ran = sh(std::string(RIGOR_BINARY_DIR) + "/rigor export " + arguments);
    EXPECT_EQ(ran.status, 2) << arguments << "\n" << ran.text;
    EXPECT_NE(ran.text.find(says), std::string::npos) << arguments << "\n" << ran.text;
    EXPECT_FALSE(fs::exists(x)) << arguments;
  }
  EXPECT_EQ(sh(std::string(RIGOR_BINARY_DIR) + "/rigor export autolap " + x).text, "rigor export: 'autolap' is none of kit, autolab, gradescope (did you mean 'autolab'?)\n");
  EXPECT_EQ(*read_file(file), "seed = 77  # secret\ncases = 5\n[points]\n\"force.sum\" = 6\n");
}

}  // namespace
}  // namespace rigor
