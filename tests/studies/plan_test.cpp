// Which cells a study has, and what it refuses before anything is measured.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <rigor/base/file.hpp>
#include <rigor/studies/drift.hpp>
#include <rigor/studies/peer.hpp>
#include <rigor/studies/plan.hpp>
#include <set>
#include <sstream>

namespace rigor::studies {
namespace {

namespace fs = std::filesystem;

StudyRequest small() {
  StudyRequest r{"convergence", {"short-A"}, {"sheet", "rk4"}};
  r.coarsest = 10;
  r.rungs = 4;
  return r;
}
StudyRequest by_h(const std::vector<double>& h) {
  StudyRequest r{"convergence", {"short-A"}, {"sheet", "rk4"}};
  r.h = h;
  return r;
}
std::string says(const StudyRequest& r) {
  const auto cells = plan(r);
  return cells ? "planned" : cells.fault().text();
}
template <class Change>
std::string says(Change change) requires std::invocable<Change, StudyRequest&> {
  StudyRequest r = small();
  change(r);
  return says(r);
}
void contains(const std::string& text, const std::string& part) { EXPECT_NE(text.find(part), std::string::npos) << text; }

// Under a torque the standard set has none of the ways that know free flight alone; on free flight it has them.
TEST(Plan, LeavesOutWhatKnowsNoTorque) {
  for (const char* problem : {"forced", "short-A"}) {
    StudyRequest r{"work-precision", {problem}, {}};
    std::set<std::string> used;
    const auto cells = plan(r);
    ASSERT_TRUE(cells);
    for (const Cell& cell : *cells) used.insert(cell.method);
    for (const char* free : {"exact-plain", "cvode-adams", "arkode-fehlberg8"}) EXPECT_EQ(used.count(free), r.problems[0] == "short-A" ? 1u : 0u) << free;
    EXPECT_EQ(used.count("dormand-prince-adaptive"), 1u);
  }
}

TEST(Plan, RefusesWhatCannotBeStudied) {
  contains(says([](StudyRequest& r) { r.kind = "convergnce"; }), "did you mean 'convergence'?");
  contains(says([](StudyRequest& r) { r.problems = {"case-D"}; }), "did you mean 'case-A'?");
  contains(says([](StudyRequest& r) { r.methods = {"rk5"}; }), "did you mean 'rk4'?");
  contains(says([](StudyRequest& r) { r.until = -1; }), "--until is -1, must be > 0");
  contains(says([](StudyRequest& r) { r.until = std::nan(""); }), "--until is nan");
  contains(says([](StudyRequest& r) { r = by_h({0.3}); }), "does not divide T = 1 s of short-A into whole steps; 1/3 does");
  contains(says([](StudyRequest& r) { r = by_h({-0.1}); }), "--h is -0.1");
  contains(says([](StudyRequest& r) { r = by_h({std::nan("")}); }), "--h is nan");
  contains(says([](StudyRequest& r) { r.tolerances = {1e-15}; }), "--tolerance is 1e-15, where the estimate of an error is rounding; must be in [1e-14, 0.1]");
  contains(says([](StudyRequest& r) { r.peers = {"buulet"}; }), "did you mean 'bullet'?");
  contains(says([](StudyRequest& r) { r.kind = "drift", r.until = 3; }), "not for drift");
  contains(says([](StudyRequest& r) { r.kind = "contact"; }), "there is no problem of contact 'short-A'");
  contains(says([](StudyRequest& r) { r.problems = {"/nowhere.json"}; }), "/nowhere.json does not exist");
  EXPECT_EQ(says([](StudyRequest& r) { r = by_h({0.1, 0.05}); }), "planned");
}

// Beside the test there is no peer's program: the fault says whether to install its package or only to build it. pkg-config knows two of them.
TEST(Plan, SaysWhatAPeerThatIsNotThereNeeds) {
  for (const Peer& peer : peers()) {
    StudyRequest r = small();
    r.peers = {peer.name};
    const auto cells = plan(r);
    ASSERT_FALSE(cells);
    EXPECT_EQ(cells.fault().kind, Fault::Kind::unsupported);
    EXPECT_EQ(cells.fault().text(), "peer " + peer.name + (peer.installed ? " is not built: " : " is not installed: install " + peer.package + ", then cmake --preset release && ") +
                                        "cmake --build build/release --target rigor_peers");
    const char* library = peer.name == "bullet" ? "bullet-float64" : peer.name == "ode" ? "ode" : nullptr;
    if (library != nullptr && std::system("pkg-config --version >/dev/null 2>&1") == 0) {
      EXPECT_EQ(peer.installed, std::system((std::string("pkg-config --exists ") + library).c_str()) == 0) << peer.name;
    }
  }
}

// A load that a study would leave out, or that who is asked does not know: the problem is named, and what is allowed.
TEST(Plan, RefusesALoadThatWouldBeLeftOut) {
  const std::vector<std::string> free = free_flight_names();
  for (const char* kind : {"drift", "stability"})
    for (const std::string& name : problem_names()) {
      EXPECT_EQ(std::count(free.begin(), free.end(), name), (*open_problem(name))->falls ? 1 : 0) << name;
      const auto cells = plan({kind, {name}, {"rk4"}});
      const std::string said = cells ? "planned" : cells.fault().text();
      const std::string refused = "--problem is " + name + ", which has a load that is not gravity alone: " + kind + " would leave it out; without: case-A, case-B, case-C, short-A, fb-01, fb-03, fb-05, fb-07, thrown, a scene file";
      EXPECT_EQ(said, (*open_problem(name))->falls ? "planned" : refused);
    }
  StudyRequest r{"convergence", {"forced"}, {"sheet"}};
  r.submission = "submission ada 0123";
  contains(says(r), "--problem is forced, which has a load that is not gravity alone: a submission is not asked for it");
  r.problems = {};
  std::set<std::string> flown;
  const auto cells = plan(r);
  ASSERT_TRUE(cells);
  for (const Cell& cell : *cells) flown.insert(cell.problem);
  EXPECT_EQ(flown, (std::set<std::string>{"short-A", "case-A", "thrown"}));  // the standard set, without the one it would refuse
  for (const char* method : {"exact-plain", "cvode-adams", "cvode-bdf", "arkode-fehlberg8"}) contains(says({"convergence", {"f-01"}, {method}}), std::string(method) + " knows no other");
}
// What is offered in place of an unknown name is not refused in turn.
TEST(Plan, OffersOnlyProblemsItTakes) {
  for (const char* kind : {"drift", "stability", "convergence"}) {
    StudyRequest r{kind, {"f-0"}, {"rk4"}};
    if (r.kind == "convergence") r.submission = "submission ada 0123";
    const std::string said = says(r), mark = "; known: ";
    ASSERT_NE(said.find(mark), std::string::npos) << said;
    std::istringstream known(said.substr(said.find(mark) + mark.size()));
    for (std::string name; std::getline(known >> std::ws, name, ',') && name != "or a scene file";) {
      r.problems = {name};
      EXPECT_EQ(says(r), "planned") << kind;
    }
  }
}

TEST(Plan, RefusesWhatIsThereTwice) {
  contains(says([](StudyRequest& r) { r.methods = {"rk4", "sheet", "rk4"}; }), "--method has rk4 twice");
  contains(says([](StudyRequest& r) { r.problems = {"short-A", "short-A"}; }), "--problem has short-A twice");
  contains(says(by_h({0.1, 0.05, 0.1})), "--h has 0.1 s twice");
  contains(says([](StudyRequest& r) { r.methods = {"cvode-adams"}, r.coarsest = {}, r.rungs = {}, r.tolerances = {1e-6, 1e-6}; }), "--tolerance has 1e-06 twice");
  for (const char* kind : {"drift", "stability", "contact", "work-precision"}) contains(says({kind, {}, {"rk4", "rk4"}}), "--method has rk4 twice");
}

TEST(Plan, RefusesAnOptionWithoutEffect) {
  const auto with = [](const char* kind, auto change) {
    StudyRequest r{kind, {}, {"sheet"}};
    change(r);
    return says(r);
  };
  for (const char* kind : {"convergence", "work-precision", "stability", "contact"}) {
    contains(with(kind, [](StudyRequest& r) { r.steps = 1000; }), "--steps is for drift, not for " + std::string(kind));
    contains(with(kind, [](StudyRequest& r) { r.step = 0.1; }), "--step is for drift");
    contains(with(kind, [](StudyRequest& r) { r.sums = {"plain"}; }), "--sums is for drift");
  }
  for (const char* kind : {"drift", "stability"}) {
    contains(with(kind, [](StudyRequest& r) { r.rungs = 3; }), "--rungs is for convergence, work-precision, contact, not for " + std::string(kind));
    contains(with(kind, [](StudyRequest& r) { r.coarsest = 3; }), "--coarsest is for");
    contains(with(kind, [](StudyRequest& r) { r.submission = "submission ada 0123"; }), "--submission is for");
  }
  for (const char* kind : {"drift", "stability", "contact"}) {
    contains(with(kind, [](StudyRequest& r) { r.h = {0.1}; }), "--h is for convergence, work-precision, not for " + std::string(kind));
    contains(with(kind, [](StudyRequest& r) { r.tolerances = {0.1}; }), "--tolerance is for");
    contains(with(kind, [](StudyRequest& r) { r.peers = {"ode"}; }), "--peer is for");
  }
  contains(says([](StudyRequest& r) { r.h = {0.1}; }), "--coarsest is of a ladder, --h names the steps");
  contains(says([](StudyRequest& r) { r.tolerances = {1e-6}; }), "--tolerance is for adaptive ways and peers: none of those asked for is one");
  contains(says([](StudyRequest& r) { r.methods = {"exact"}; }), "--coarsest is for ways that take steps");
  contains(says([](StudyRequest& r) { r = {"contact", {"p-04"}, {"located"}}, r.rungs = 3; }), "--rungs is for ways that take steps");
}

// The steps of --h in any order are a ladder from the coarsest on.
TEST(Plan, OrdersTheStepsItIsGiven) {
  const auto cells = plan(by_h({0.05, 0.1, 0.025}));
  ASSERT_TRUE(cells);
  EXPECT_EQ((*cells)[0].steps, 10);
  EXPECT_EQ((*cells)[1].steps, 20);
  EXPECT_EQ((*cells)[2].steps, 40);
}

class SceneOfAFlight : public ::testing::Test {
 protected:
  void TearDown() override {
    for (const fs::path& path : made) fs::remove(path);
  }
  std::string scene(const std::string& spin, const std::string& more = "") {
    static int files = 0;  // a problem is opened once in a program: no name twice
    made.push_back(fs::temp_directory_path() / ("rigor-plan-" + std::to_string(::getpid()) + "-" + std::to_string(files++) + ".json"));
    EXPECT_TRUE(write_file(made.back(), "{\"cuboids\": [{\"mass\": 2, \"size\": [1, 2, 3], \"position\": [0, 1, 0], \"spin\": " + spin + "}], \"until\": 1" + more + "}"));
    return made.back().string();
  }
  std::vector<fs::path> made;
};

// What a cell flies is in its description: the numbers of the file, not its name alone, and not how they are written.
TEST_F(SceneOfAFlight, IsInTheDescriptionOfItsCells) {
  std::set<std::string> contents;
  for (const std::string& path : {scene("[0, 2, 0.25]"), scene("[0, 2, 0.250]"), scene("[0, 2, 0.5]"), scene("[0, 2, 0.5]", ", \"gravity\": [0, -1, 0]")})
    for (const char* kind : {"convergence", "work-precision", "drift", "stability"}) {
      const auto cells = plan({kind, {path}, {"rk4"}});
      ASSERT_TRUE(cells) << cells.fault().text();
      for (const Cell& cell : *cells) {
        contents.insert(cell.content);
        EXPECT_EQ(cell.content.size(), 16u);
        contains(cell.text(), " content=" + cell.content);
      }
    }
  EXPECT_EQ(contents.size(), 3u);
  const auto of_the_catalogue = plan(small());
  for (const Cell& cell : *of_the_catalogue) EXPECT_EQ(cell.content, "");
}

TEST_F(SceneOfAFlight, IsStudiedForDriftAndStabilityWhereItSpins) {
  const std::string path = scene("[0.3, 2, 0.2]"), still = scene("[0, 0, 0]");
  const auto cells = plan({"stability", {path}, {"rk4"}});
  ASSERT_TRUE(cells) << cells.fault().text();
  ASSERT_EQ(cells->size(), 1u);
  EXPECT_EQ(stability(cells->front()).at("angle"), stability({"stability", "case-A", "rk4"}).at("angle"));  // the same body but for its mass
  for (const char* kind : {"drift", "stability"}) contains(says({kind, {still}, {"rk4"}}), "--problem is " + still + ", whose spin is 0");
  contains(says({"stability", {"/nowhere.json"}, {"rk4"}}), "/nowhere.json does not exist");
  contains(says({"stability", {"spn"}, {"rk4"}}), "did you mean 'spin'?");
}

}  // namespace
}  // namespace rigor::studies
