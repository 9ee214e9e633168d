#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <tests/grader/build_samples.hpp>
#include <thread>

namespace rigor::grader {
namespace {

using testing::ElementsAre;

BuildResult tangent_program(const std::string& body, const std::string& before = "") {
  const Directory dir;
  dir.write("CollisionPlane.cpp", "#include \"CollisionPlane.h\"\n#include \"Constants.h\"\n" + before +
                                      "\nV3D CollisionPlane::frictionTangent(Cuboid& c, P3D& p) {\n" + body + "\n}\n");
  return built(dir.path);
}

TEST(Worker, FixesTheConstantsBeforeAnyStaticConstructorRuns) {
  const BuildResult b = tangent_program("return kept;",
                                        "static const double twice = 2 * COEFF_RESITUTION;\n"
                                        "static V3D kept(twice, COEFF_DYNAMIC_FRICTION, DELTA_T);");
  for (const double e : {0.1, 0.7, 1.0 / 3}) {
    Constants constants;
    constants.restitution = e;
    constants.dynamic_friction = e / 7;
    constants.delta_t = 0x1.8p-1074;
    Worker worker(b.executable, constants);
    const Answer answer = worker.call(generic(Function::friction_tangent));
    ASSERT_EQ(kind_of(answer), "reply");
    EXPECT_THAT(std::get<Reply>(answer).vector, ElementsAre(2 * e, e / 7, 0x1.8p-1074)) << "bit for bit";
  }
}

TEST(Worker, SetsAndReadsTheWholeState) {
  Worker worker(built(samples() / "kit").executable, {});
  Request r = generic(Function::apply_force);  // the handed-out one does nothing: what went in comes out
  constexpr int numbers = (sizeof(BodyRecord) - sizeof r.A.size) / sizeof(double);
  double* in = &r.A.mass;
  for (int i = 0; i < numbers; ++i) in[i] = i + 1.0 / 3;
  const Answer answer = worker.call(r);
  ASSERT_EQ(kind_of(answer), "reply");
  const double* out = &std::get<Reply>(answer).A.mass;
  for (int i = 0; i < numbers; ++i) EXPECT_EQ(out[i], in[i]) << i;

  r.direct = 0;  // tensors as the constructor leaves them
  const Answer constructed = worker.call(r);
  EXPECT_THAT(std::get<Reply>(constructed).A.body_inertia, ElementsAre(1, 0, 0, 0, 1, 0, 0, 0, 1));
  EXPECT_EQ(worker.starts(), 1);
}

TEST(Worker, AnswersEveryFunctionOfARightSubmission) {
  Worker worker(built(samples() / "right" / "expressions").executable, {});
  std::uint64_t calls = 0;
  for (const Function f : {Function::body_inertia, Function::world_inertia, Function::apply_force, Function::update,
                           Function::friction_tangent, Function::plane_response, Function::pair_response,
                           Function::constants}) {
    Request r = generic(f);
    r.flags = want_helpers;
    const Answer answer = worker.call(r);
    ASSERT_EQ(kind_of(answer), "reply") << int(f) << words_of(answer);
    const Reply& reply = std::get<Reply>(answer);
    EXPECT_EQ(reply.serial, ++calls);
    if (f == Function::constants) continue;
    // R = 1: the world tensor is the body's, 13/6 within one rounding of each of two products with 1
    EXPECT_DOUBLE_EQ(reply.A_helpers.world_inertia[0], 13.0 / 6);
    EXPECT_EQ(reply.B_helpers.world_inverse_inertia[0] != 0, f == Function::pair_response);
  }
  EXPECT_EQ(worker.starts(), 1);
}

TEST(Worker, HoldsForcesOverSeveralStepsOnlyWhenAsked) {
  Worker worker(built(samples() / "right" / "expressions").executable, {});
  Request r = generic(Function::update);
  r.count = 8;
  r.h = 0.125;
  r.A.net_force[0] = 2;  // acceleration 1 for a mass of 2: exact in binary
  EXPECT_EQ(std::get<Reply>(worker.call(r)).A.velocity[0], r.A.velocity[0] + 0.125);
  r.flags = hold_forces;
  EXPECT_EQ(std::get<Reply>(worker.call(r)).A.velocity[0], r.A.velocity[0] + 1);
}

TEST(Worker, RunsTheStudentsOwnScene) {
  Request r = generic(Function::scene_steps);
  r.count = 480;
  r.seed = 7;
  Worker right(built(samples() / "right" / "expressions").executable, {});
  const Reply calm = std::get<Reply>(right.call(r, 10));
  EXPECT_EQ(calm.scene[3], 1);
  EXPECT_GT(calm.scene[0], 0) << "no centre behind a plane";
  r.flags = vacuum_on;
  const Reply pulled = std::get<Reply>(right.call(r, 10));
  EXPECT_NE(pulled.scene[1], calm.scene[1]) << "the vacuum does something";
  r.flags = 0;
  EXPECT_EQ(std::get<Reply>(right.call(r, 10)).scene[1], calm.scene[1]) << "the same seed, the same scene";

  Worker unfinished(built(samples() / "kit").executable, {});
  const Reply still = std::get<Reply>(unfinished.call(r, 10));
  EXPECT_EQ(still.scene[1], 0) << "nothing moves before update is written";
}

TEST(Worker, QuotesWhatIsPrintedAndKeepsItShort) {
  const BuildResult b = tangent_program("cout << \"I am here\" << endl; cerr << \"and there\"; return V3D();");
  Worker worker(b.executable, {});
  worker.call(generic(Function::friction_tangent));
  EXPECT_EQ(worker.take_output(), "I am here\nand there");
  EXPECT_EQ(worker.take_output(), "");
  for (int i = 0; i < 5000; ++i) worker.call(generic(Function::friction_tangent));
  EXPECT_EQ(worker.take_output().size(), 64u << 10);
}

// Without an answer to uname() a program linked with glibc 2.31 (Debian 11, Ubuntu 20.04) aborts before main.
TEST(Worker, LetsAnOlderCLibraryAskForTheKernel) {
  const BuildResult b = tangent_program("struct utsname u; return V3D(uname(&u), 0, 1);", "#include <sys/utsname.h>\n");
  Worker worker(b.executable, {});
  const Answer answer = worker.call(generic(Function::friction_tangent));
  ASSERT_EQ(kind_of(answer), "reply");
  EXPECT_THAT(std::get<Reply>(answer).vector, ElementsAre(0, 0, 1));
}

TEST(Worker, SaysThatAFunctionIsAbsent) {
  const Directory dir;
  std::string header = *read_file(fs::path(RIGOR_SOURCE_DIR) / "src/kit/handout/CollisionPlane.h");
  const std::string declaration = "V3D frictionTangent(Cuboid& c, P3D& p);";
  ASSERT_NE(header.find(declaration), header.npos);
  header.erase(header.find(declaration), declaration.size());
  dir.write("CollisionPlane.h", header);
  dir.write("CollisionPlane.cpp", "#include \"CollisionPlane.h\"\n");
  const BuildResult b = built(dir.path);
  EXPECT_EQ(b.of(StudentFunction::friction_tangent).kind, FunctionStatus::Kind::not_implemented);
  Worker worker(b.executable, {});
  EXPECT_EQ(kind_of(worker.call(generic(Function::friction_tangent))), "absent");
  EXPECT_EQ(kind_of(worker.call(generic(Function::plane_response))), "reply");
}

TEST(Worker, MovesBetweenThreadsByStartingAgain) {
  Worker worker(built(samples() / "kit").executable, {});
  std::thread([&] { EXPECT_EQ(kind_of(worker.call(generic(Function::update))), "reply"); }).join();
  EXPECT_EQ(kind_of(worker.call(generic(Function::update))), "reply");
  EXPECT_EQ(worker.starts(), 2);
}

TEST(Worker, GivesATimeOfItsOwnToALongCall) {
  const BuildResult b = tangent_program(
      "volatile double x = 0; for (int i = 0; i < 300000000; ++i) x = x + 1; return V3D(x, 0, 0);");
  Limits limits;
  limits.call_s = 0.01;
  Worker worker(b.executable, {}, limits);
  EXPECT_EQ(kind_of(worker.call(generic(Function::friction_tangent))), "timeout");
  EXPECT_EQ(kind_of(worker.call(generic(Function::friction_tangent), 60)), "reply");
}

// ---- Attacks: every sample says what becomes of the build, or of the call it attacks

class Hostile : public testing::TestWithParam<std::string> {};

TEST_P(Hostile, ComesToNothing) {
  const fs::path path = samples() / "hostile" / GetParam();
  const auto what = lines_of(path / "WHAT");
  ASSERT_EQ(what.size(), 2u);
  const std::string stage = what[1].substr(0, what[1].find(':')), expected = what[1].substr(what[1].find(' ') + 1);

  const BuildResult b = built(path);
  ASSERT_FALSE(b.executable.empty());
  const FunctionStatus& status = b.of(StudentFunction::plane_response);
  if (GetParam() != "includes-dev-zero") {  // left out as a file that is not there, or, without namespaces, refused
    EXPECT_EQ(status.kind == FunctionStatus::Kind::not_compiled, expected == "not-compiled") << status.error;
  }
  for (const std::string& said : b.notes) EXPECT_EQ(said.find("root:"), said.npos) << "a file of the machine: " << said;
  EXPECT_LE(status.error.size(), 1000u);

  Limits limits;
  limits.call_s = 0.2;
  Worker worker(b.executable, {}, limits);
  for (int call = 0; call < 2; ++call) {
    const Answer answer = worker.call(generic(Function::plane_response));
    if (call == 0) {
      // without namespaces there is a program to become: its loader may then open nothing, and it ends itself
      bool namespaces = false;
      for (const std::string& layer : worker.isolation()) namespaces = namespaces || layer.rfind("bubblewrap", 0) == 0;
      const std::string comes = expected == "not-compiled" ? "reply" : GetParam() == "executes" && !namespaces ? "exited" : expected;
      EXPECT_EQ(kind_of(answer), comes) << what[0] << ": " << words_of(answer);
    }
    const Reply* reply = std::get_if<Reply>(&answer);
    const bool computes = GetParam() == "answers-nan" || GetParam() == "interposes-the-library";
    if (reply && !computes) {  // what came is the unfinished function's, or the zeros that were forged
      EXPECT_EQ(reply->A.velocity[1], GetParam() == "forges-a-reply" ? 0 : generic(Function::update).A.velocity[1]);
    }
  }
  const std::string printed = worker.take_output();
  for (const char* sign : {"STOLEN", "WRITTEN", "CONNECTED", "EXECUTED", "RAISED", "root:"})
    EXPECT_EQ(printed.find(sign), printed.npos) << printed;
  // The neighbour, graded in the same run, answers as ever.
  Worker neighbour(built(samples() / "kit").executable, {});
  EXPECT_EQ(kind_of(neighbour.call(generic(Function::update))), "reply");
}

INSTANTIATE_TEST_SUITE_P(All, Hostile, testing::ValuesIn(samples_in("hostile")), [](const auto& sample) {
  std::string name = sample.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(HostileSamples, AreAtLeastTwenty) { EXPECT_GE(samples_in("hostile").size(), 20u); }

TEST(HostileSamples, LeaveNoProcessBehind) {
  for (const std::string name : {"forks", "leaves-a-child", "loops", "sleeps", "ignores-crashes", "closes-everything"}) {
    // a copy under a name of its own: other tests may be running the one in the cache
    const fs::path directory = fs::temp_directory_path() / ("rigor-left-" + std::to_string(::getpid()));
    fs::create_directories(directory);
    const fs::path executable = directory / name;
    fs::copy_file(built(samples() / "hostile" / name).executable, executable);
    fs::permissions(directory, fs::perms(0755));
    fs::permissions(executable, fs::perms(0755));
    {
      Limits limits;
      limits.call_s = 0.05;
      Worker worker(executable, {}, limits);
      worker.call(generic(Function::plane_response));
    }
    std::vector<std::string> left;
    for (const auto& entry : fs::directory_iterator("/proc")) {
      const auto words = lines_of(entry.path() / "cmdline");
      if (!words.empty() && words[0].find(executable.string()) != std::string::npos) left.push_back(entry.path());
    }
    EXPECT_THAT(left, testing::IsEmpty()) << name;
    fs::remove_all(directory);
  }
}

}  // namespace
}  // namespace rigor::grader
