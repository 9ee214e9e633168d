#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <rigor/grader/sandbox.hpp>
#include <rigor/grader/seccomp.hpp>
#include <tests/grader/build_samples.hpp>

namespace rigor::grader {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr ProcessLimits usual{5, 1ull << 30, 1u << 20};

struct Output {
  std::string text;
  int status;
};

/// A shell command run confined as a compiler is.
Output shell(const std::string& command, const ProcessLimits& limits = usual) {
  int out[2];
  EXPECT_EQ(pipe2(out, O_CLOEXEC), 0);
  const int null = open("/dev/null", O_RDONLY | O_CLOEXEC);
  Child child = *start({Profile::compiler, {"/bin/sh", "-c", command}, "/", {}, {}, {null, out[1], out[1]}, limits});
  close(out[1]);
  close(null);
  std::string text;
  for (char c; read(out[0], &c, 1) == 1;) text += c;
  close(out[0]);
  child.ended(5);
  return {text, child.end()};
}

/// The exit status of an action under a filter, in a process of its own.
template <class Action>
int under(const SystemCallFilter& filter, Action action) {
  const pid_t pid = fork();
  if (pid == 0) _exit(install(filter) ? action() : 111);
  int status = 0;
  waitpid(pid, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
}

int error_of(long result) { return result < 0 ? errno : 0; }

TEST(WorkerFilter, RefusesWithAnErrorNumberAndKillsNobody) {
  const SystemCallFilter filter = worker_filter(0);
  EXPECT_EQ(under(filter, [] { return error_of(open("/etc/passwd", O_RDONLY)); }), EPERM);
  EXPECT_EQ(under(filter, [] { return error_of(socket(AF_INET, SOCK_STREAM, 0)); }), EPERM);
  EXPECT_EQ(under(filter, [] { return error_of(fork()); }), EPERM);
  EXPECT_EQ(under(filter, [] { return error_of(kill(getpid(), SIGTERM)); }), EPERM);
  EXPECT_EQ(under(filter, [] { return error_of(unlink("/tmp/none")); }), EPERM);
  EXPECT_EQ(under(filter, [] { return error_of(write(1, "", 0)); }), 0);
}

TEST(WorkerFilter, LetsAProcessAbortItselfAndNobodyElse) {
  const pid_t pid = fork();
  if (pid == 0) {
    if (!install(worker_filter(getpid()))) _exit(111);
    if (error_of(syscall(SYS_tgkill, getpid() + 1, getpid() + 1, SIGABRT)) != EPERM) _exit(112);
    if (error_of(syscall(SYS_tgkill, getpid(), getpid(), SIGTERM)) != EPERM) _exit(113);
    abort();
  }
  int status = 0;
  waitpid(pid, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status)) << WEXITSTATUS(status);
  EXPECT_EQ(WTERMSIG(status), SIGABRT);
}

TEST(CompilerFilter, LetsFilesAndProcessesBeAndStopsWhatReachesBeyond) {
  const SystemCallFilter filter = compiler_filter();
  EXPECT_EQ(under(filter, [] { return error_of(open("/etc/passwd", O_RDONLY)); }), 0);
  EXPECT_EQ(under(filter, [] { return error_of(socket(AF_INET, SOCK_STREAM, 0)); }), EPERM);
}

TEST(Sandbox, ShowsACompilerNothingOfTheMachineButTheSystem) {
  EXPECT_EQ(shell("cat /etc/passwd 2>&- | wc -c").text, "0\n");
  EXPECT_EQ(shell("ls " RIGOR_SOURCE_DIR " 2>&- | wc -l").text, "0\n");
  EXPECT_EQ(shell("touch /usr/rigor-was-here && echo written").text.find("written"), std::string::npos);
  EXPECT_EQ(shell("echo $HOME $LC_ALL; test -f /usr/include/stdio.h && echo seen").text, "/tmp C\nseen\n");
}

TEST(Sandbox, HoldsTheLimits) {
  EXPECT_NE(shell("while :; do :; done", {1, 1ull << 30, 1u << 20}).status, 0);
  EXPECT_NE(shell("x=0123456789; while :; do x=$x$x; done", {5, 64u << 20, 1u << 20}).status, 0);
  EXPECT_EQ(shell(":").status, 0) << "else the two above prove nothing";
}

TEST(Sandbox, GivesAProgramTheDescriptorsItShallHaveAndNoOthers) {
  const int careless = open("/etc/hostname", O_RDONLY);  // a part of the judge that does not close on exec
  const Output output =
      shell("for n in 3 4 5 6 7 8 9; do if (eval \": <&$n\") 2>&-; then echo $n; fi; done; echo end");
  close(careless);
  EXPECT_EQ(output.text, "end\n");
}

// Bubblewrap tells in several pieces what it has begun; who has asked for the first must not cut off the others.
TEST(Sandbox, StartsWhoeverAsksHoweverEarly) {
  for (int k = 0; k < 200; ++k) {
    int out[2];
    ASSERT_EQ(pipe2(out, O_CLOEXEC), 0);
    const int null = open("/dev/null", O_RDONLY | O_CLOEXEC);
    Child child = *start({Profile::compiler, {"/bin/echo", "hello"}, "/", {}, {}, {null, out[1], out[1]}, usual});
    close(out[1]);
    close(null);
    child.cpu_seconds();
    ASSERT_TRUE(child.ended(30)) << k;
    ASSERT_EQ(child.status(), 0) << k;
    char text[6];
    EXPECT_EQ(read(out[0], text, 6), 6) << k;
    close(out[0]);
  }
}

TEST(Sandbox, SaysInWordsWhatItReached) {
  const auto lines = isolation(Profile::worker);
  EXPECT_GE(lines.size(), 4u);
  EXPECT_THAT(lines,
              Contains(testing::AnyOf(HasSubstr("bubblewrap: user, process, network"), HasSubstr("process only"))));
  if (std::getenv("RIGOR_TEST_IN_A_CONTAINER") != nullptr) {
    EXPECT_THAT(lines, Contains(HasSubstr("process only")));
  }
}

// ---- The same program as other people run it: in a container without namespaces, and not as root. Each runs this
// test executable once more in that place, with a few of the attacks; with RIGOR_ALL more of them, and the sanitizers.

std::string self() { return fs::read_symlink("/proc/self/exe").string(); }

const std::string container = "bwrap --unshare-user --disable-userns --dev-bind / / -- ";
const std::string unprivileged = "setpriv --reuid 12345 --regid 12345 --clear-groups ";
const std::string chosen =
    " --gtest_brief=1 --gtest_filter='Sandbox.Says*:All/Hostile.*/kills*:All/Hostile.*/reads_files:All/Hostile.*/writes_files:All/Hostile.*/leaves*" +
    std::string(std::getenv("RIGOR_ALL") ? ":All/Hostile.*/aborts*:All/Hostile.*/includes_*:Sanitizers.Find*'" : "'");

TEST(Sandbox, WorksInAContainerWithoutNamespaces) {
  if (::system((container + "true 2>/dev/null").c_str()) != 0)
    GTEST_SKIP() << "bubblewrap cannot make a place without namespaces here";
  const Directory place;
  EXPECT_EQ(::system(("RIGOR_CACHE=" + (place.path / "cache").string() + " RIGOR_TEST_IN_A_CONTAINER=1 " + container +
                      self() + chosen).c_str()), 0);
}

TEST(Sandbox, WorksForAUserWhoIsNotRoot) {
  if (geteuid() != 0) GTEST_SKIP() << "this whole run is not root's";
  if (::system((unprivileged + "test -x " + self() + " -a -r " + samples().string()).c_str()) != 0)
    GTEST_SKIP() << "the sources lie where another user cannot read them";
  const Directory place;
  fs::permissions(place.path, fs::perms(0777));
  EXPECT_EQ(::system(("RIGOR_CACHE=" + (place.path / "cache").string() + " " + unprivileged + self() + chosen).c_str()),
            0);
}

}  // namespace
}  // namespace rigor::grader
