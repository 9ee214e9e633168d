// Completion and man page: every command and option of the help is in them, and the shells take them.
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <rigor/base/file.hpp>
#include <rigor/cli/commands.hpp>
#include <rigor/cli/shell.hpp>
#include <tests/cli/shell.hpp>

namespace rigor::cli {
namespace {

class Shell : public ::testing::Test {
 protected:
  void SetUp() override {
    add_commands(app, status);
    dir = std::filesystem::temp_directory_path() / ("rigor-shell-test-" + std::to_string(::getpid()));
    std::filesystem::create_directories(dir);
  }
  void TearDown() override { std::filesystem::remove_all(dir); }
  std::string output(const std::string& command) {
    const auto [status, text] = sh(command);
    return status == 0 ? text : text + "(failed)";
  }
  // What bash offers after these words, sorted, in one line.
  std::string offered(const std::string& words) {
    EXPECT_TRUE(write_file(dir / "rigor.bash", bash_completion(app)));
    return output("bash -c 'source " + (dir / "rigor.bash").string() + "; COMP_WORDS=(rigor " + words +
                  "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _rigor; printf \"%s\\n\" \"${COMPREPLY[@]}\" | sort | tr \"\\n\" \" \"'");
  }
  bool there(const char* program) { return std::system(("command -v " + std::string(program) + " >/dev/null").c_str()) == 0; }
  CLI::App app{"test", "rigor"};
  int status = 0;
  std::filesystem::path dir;
};

TEST_F(Shell, BashOffersCommandsOptionsAndValues) {
  EXPECT_EQ(offered("ver"), "verify ");
  EXPECT_EQ(offered("run --q"), "--quiet ");
  EXPECT_EQ(offered("run --method loc"), "located ");
  EXPECT_EQ(offered("view --method loc"), " ") << "the live scene has no located mode";
  EXPECT_EQ(offered("run as"), "assignment ");
  EXPECT_EQ(offered("study \"\""), "contact convergence drift stability work-precision ");
  EXPECT_EQ(offered("export \"\""), "autolab gradescope kit ");
  EXPECT_EQ(offered("study drift --problem short"), "short-A ");
  EXPECT_EQ(offered("study contact --problem p-0"), "p-01-many p-01-one p-04 p-07 ");
  EXPECT_EQ(offered("study stability --problem asp"), "aspect ");
  EXPECT_EQ(offered("explain force.tor"), "force.torque ");
  EXPECT_EQ(offered("run --out x"), " ") << "files, which bash offers itself";
  EXPECT_EQ(offered("nonsense x"), " ");
  EXPECT_EQ(offered("grade --check force.p"), "force.pure ");
  EXPECT_EQ(offered("run --no-skip pl"), "planes ");
  EXPECT_EQ(offered("check-table --table \"\""), "free-flight impacts loaded-flight ");
  EXPECT_EQ(offered("help gr"), "grade ");
}

// What a comma may follow is completed behind it too; what is one value is not.
TEST_F(Shell, BashCompletesBehindACommaWhereTheOptionTakesAList) {
  EXPECT_EQ(offered("study convergence --method sheet,euler-n"), "sheet,euler-naive ");
  EXPECT_EQ(offered("study convergence --method sheet,rk4,tay"), "sheet,rk4,taylor16 ");
  EXPECT_EQ(offered("run --no-skip pairs,l"), "pairs,loads ");
  EXPECT_EQ(offered("grade --format text,ju"), "text,junit ");
  EXPECT_EQ(offered("run --method sheet,rk"), " ") << "one method";
}

TEST_F(Shell, TheManPageHasRangesAndDefaults) {
  const std::string man = man_page(app);
  const auto entry = [&](const std::string& command, const std::string& option) {
    const std::size_t from = man.find("\n.B " + option + "\n", man.find("\n.SS " + command + "\n"));
    return man.substr(from, man.find("\n.TP\n", from) - from);
  };
  EXPECT_NE(entry("run", "\\-\\-dt").find("in [1e\\-30, 1e30] s"), std::string::npos) << entry("run", "\\-\\-dt");
  EXPECT_NE(entry("demo", "\\-\\-out").find("out/demo by default"), std::string::npos) << entry("demo", "\\-\\-out");
  EXPECT_NE(entry("audit", "\\-\\-seeds").find("in [1, 1000]; "), std::string::npos) << entry("audit", "\\-\\-seeds");
  EXPECT_NE(entry("audit", "\\-\\-seeds").find(" by default"), std::string::npos) << entry("audit", "\\-\\-seeds");
}

TEST_F(Shell, EveryCommandAndOptionIsInAllThree) {
  const std::string bash = bash_completion(app), zsh = zsh_completion(app), man = man_page(app);
  int options = 0;
  for (const CLI::App* command : std::as_const(app).get_subcommands([](const CLI::App*) { return true; })) {
    const std::string name = command->get_name();
    EXPECT_NE(bash.find("\n    " + name + ")\n"), std::string::npos) << name;
    EXPECT_NE(zsh.find("\n    " + name + ") _arguments"), std::string::npos) << name;
    const std::size_t from = man.find("\n.SS " + name + "\n"), to = man.find("\n.S", from + 1);
    ASSERT_NE(from, std::string::npos) << name;
    for (const CLI::Option* option : command->get_options()) {
      const std::string word = option->get_name();
      if (word[0] != '-') continue;
      ++options;
      std::string in_roff;
      for (const char c : word) in_roff += c == '-' ? "\\-" : std::string(1, c);
      EXPECT_NE(bash.find(word), std::string::npos) << word;
      EXPECT_NE(zsh.find(word + "["), std::string::npos) << word;
      EXPECT_LT(man.find(".B " + in_roff + "\n", from), to) << name << " " << word;
    }
  }
  EXPECT_GT(options, 40);
}

TEST_F(Shell, TheShellsAndTheManPageReaderTakeThem) {
  ASSERT_TRUE(write_file(dir / "rigor.bash", bash_completion(app)));
  ASSERT_TRUE(write_file(dir / "_rigor", zsh_completion(app)));
  ASSERT_TRUE(write_file(dir / "rigor.1", man_page(app)));
  EXPECT_EQ(output("bash -n " + (dir / "rigor.bash").string()), "");
  if (there("zsh")) {
    EXPECT_EQ(output("zsh -n " + (dir / "_rigor").string()), "");
    EXPECT_EQ(output("zsh -fc 'autoload -Uz compinit && compinit -D -u; source " + (dir / "_rigor").string() + " && whence -w _rigor'"), "_rigor: function\n");
  }
  if (there("groff")) {
    EXPECT_EQ(output("groff -man -ww -z -Tutf8 " + (dir / "rigor.1").string()), "");
    EXPECT_NE(output("groff -man -Tascii -P-c -rLL=200n " + (dir / "rigor.1").string()).find("rigor run assignment --seed 3"), std::string::npos);
  }
}

}  // namespace
}  // namespace rigor::cli
