// The live scene without sockets: what a message does, what it refuses, and that time passes as `simulate` has it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <rapidcheck/gtest.h>
#include <rigor/linalg/rotation.hpp>
#include <rigor/live/live_scene.hpp>
#include <rigor/scene/simulate.hpp>

namespace rigor::live {
namespace {

using Json = nlohmann::json;
using V = Vec3<double>;

LiveScene live(const std::string& name, std::uint64_t seed = 3) {
  return *LiveScene::make(builtin_scene(name, seed), [name](std::uint64_t next) { return builtin_scene(name, next); });
}
bool says(LiveScene& scene, const std::string& message, int viewer = 0) { return bool(scene.obey(message, viewer)); }
const std::string run = R"({"do":"toggle","what":"running"})", vacuum = R"({"do":"toggle","what":"vacuum"})", gravity = R"({"do":"toggle","what":"gravity"})";

template <class T>
T at(const std::string& bytes, std::size_t offset) {
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}
void expect_same(const std::vector<State<double>>& a, const std::vector<State<double>>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_TRUE(a[i].p_WB == b[i].p_WB && a[i].R_WB == b[i].R_WB && a[i].v_WB == b[i].v_WB && a[i].w_WB == b[i].w_WB) << "cuboid " << i;
}

// The witness is the run of the same scene file from its start to its end: the bits are the same.
TEST(LiveScene, PassesTimeAsARunDoes) {
  Scene scene = builtin_scene("assignment", 3);
  scene.until = 3, scene.every = 0;  // the last step of a run is made to fit: the one at 2 s is not the last
  scene.actions = {{1.0, SceneAction::Do::vacuum_on}, {1.5, SceneAction::Do::gravity_off}};
  std::vector<State<double>> wanted;
  simulate(scene, [&](double t, const auto& states) {
    if (std::fabs(t - 2) < 1e-9) wanted = states;
  });

  LiveScene here = live("assignment");
  here.advance(1, 60);
  EXPECT_EQ(here.t(), 0) << "nothing runs before space is pressed";
  ASSERT_TRUE(says(here, run));
  for (int k = 0; k < 60; ++k) here.advance(1.0 / 60, 60);
  ASSERT_TRUE(says(here, vacuum));
  here.advance(0.5, 60);
  ASSERT_TRUE(says(here, gravity));
  for (int k = 0; k < 4; ++k) here.advance(0.125, 60);
  EXPECT_NEAR(here.t(), 2, 1e-12);
  expect_same(here.world().states(), wanted);

  ASSERT_TRUE(says(here, run));
  here.advance(1, 60);
  EXPECT_NEAR(here.t(), 2, 1e-12) << "space stops";
}

TEST(LiveScene, SwitchesBackAndForth) {
  LiveScene here = live("assignment");
  EXPECT_TRUE(here.world().gravity());
  EXPECT_FALSE(here.world().vacuum());
  ASSERT_TRUE(says(here, gravity));
  ASSERT_TRUE(says(here, vacuum));
  EXPECT_FALSE(Json::parse(here.status())["gravity"]);
  EXPECT_TRUE(Json::parse(here.status())["vacuum"]);
  ASSERT_TRUE(says(here, gravity));
  ASSERT_TRUE(says(here, vacuum));
  EXPECT_TRUE(here.world().gravity());
  EXPECT_FALSE(here.world().vacuum());
}

TEST(LiveScene, BeginsAnewWithTheNextSeedAndKeepsWhatWasSet) {
  LiveScene here = live("assignment");
  ASSERT_TRUE(says(here, R"({"do":"set","what":"restitution","value":0.25})"));
  ASSERT_TRUE(says(here, R"({"do":"set","what":"dt","value":0.01})"));
  ASSERT_TRUE(says(here, R"({"do":"method","value":"rk4"})"));
  ASSERT_TRUE(says(here, run));
  here.advance(0.2, 60);
  ASSERT_TRUE(says(here, R"({"do":"new"})"));
  EXPECT_EQ(here.t(), 0);
  EXPECT_EQ(here.scenes(), 2);
  EXPECT_TRUE(here.running());
  std::vector<State<double>> wanted;
  for (const SceneBody& b : builtin_scene("assignment", 4).bodies) wanted.push_back(b.start);
  expect_same(here.world().states(), wanted);
  const Json status = Json::parse(here.status());
  EXPECT_EQ(status["seed"], 4);
  EXPECT_EQ(status["surface"]["restitution"], 0.25);
  EXPECT_EQ(status["dt"], 0.01);
  EXPECT_EQ(status["method"], "rk4");
}

// dt changed on the way: 24 steps of 1/240, then 10 of 0.01: a fall from rest by semi-implicit steps is known in closed
// form, y = y0 - g (h^2 n(n+1)/2) and so on with the speed reached.
TEST(LiveScene, StepsByTheDtThatWasSet) {
  Scene scene = builtin_scene("drop", 1);
  scene.bodies[0].start.p_WB[1] = 100;
  LiveScene here = *LiveScene::make(scene, [&](std::uint64_t) { return scene; });
  ASSERT_TRUE(says(here, run));
  here.advance(0.1, 60);
  ASSERT_TRUE(says(here, R"({"do":"set","what":"dt","value":0.01})"));
  here.advance(0.1, 60);
  const double h1 = 1.0 / 240, h2 = 0.01, v1 = 9.8 * 0.1;
  const double fallen = 9.8 * h1 * h1 * 24 * 25 / 2 + v1 * 0.1 + 9.8 * h2 * h2 * 10 * 11 / 2;
  EXPECT_NEAR(here.world().states()[0].p_WB[1], 100 - fallen, 1e-12);  // 34 roundings of 100: 5e-13
  EXPECT_NEAR(here.t(), 0.2, 1e-12);
}

// Held still, a cuboid hangs where spring and weight agree: 30 N/m and 9.8 N for each kg, 0.3267 m below the hand.
TEST(LiveScene, AHandHoldsACuboidUntilItsViewerLetsGoOrGoes) {
  LiveScene here = live("drop");
  ASSERT_TRUE(says(here, run));
  ASSERT_TRUE(says(here, R"({"do":"hold","body":0,"at":[0,0,0],"to":[0,5,0]})", 7));
  EXPECT_FALSE(says(here, R"({"do":"move","to":[0,6,0]})", 8)) << "another viewer's hand";
  EXPECT_FALSE(says(here, R"({"do":"hold","body":0,"at":[0,0,0],"to":[0,6,0]})", 8));
  here.left(8);
  ASSERT_TRUE(says(here, R"({"do":"move","to":[0,3,0]})", 7));
  for (int k = 0; k < 20; ++k) here.advance(0.25, 60);
  EXPECT_NEAR(here.world().states()[0].p_WB[1], 3 - 9.8 / 30, 1e-9);  // e^(-5.5 x 5) of the fall is left: 1e-12 x 2 m
  EXPECT_EQ(Json::parse(here.status())["held"], 0);
  here.left(7);
  EXPECT_TRUE(Json::parse(here.status())["held"].is_null());
  here.advance(0.25, 60);
  EXPECT_NEAR(here.world().states()[0].p_WB[1], 3 - 9.8 / 30 - 9.8 / 2 * 0.25 * (0.25 + 1.0 / 240), 1e-9);
}

TEST(LiveScene, FramesCarryPosesAndImpulses) {
  LiveScene here = live("drop");
  ASSERT_TRUE(says(here, run));
  std::size_t touches = 0;
  for (int k = 0; k < 60; ++k) {
    here.advance(1.0 / 60, 60);
    const std::string frame = here.frame();
    const std::size_t n = std::size_t(at<double>(frame, 8));
    ASSERT_EQ(frame.size(), 16 + 4 * (7 + 6 * n));
    EXPECT_EQ(at<double>(frame, 0), here.t());
    EXPECT_EQ(at<float>(frame, 20), float(here.world().states()[0].p_WB[1]));
    const Mat3<double> R = rotation_of<double>(Vec4<double>(at<float>(frame, 28), at<float>(frame, 32), at<float>(frame, 36), at<float>(frame, 40)));
    EXPECT_LE((R - here.world().states()[0].R_WB).cwiseAbs().maxCoeff(), 1e-6) << "four float32 of at most 1: 8 roundings of 2^-24, doubled";
    for (std::size_t c = 0; c < n; ++c) EXPECT_GE(at<float>(frame, 44 + 24 * c + 16), 0) << "the floor pushes up";
    touches += n;
  }
  EXPECT_EQ(touches, std::size_t(here.world().ledger().impacts));
  EXPECT_GT(touches, 0u);
}

TEST(LiveScene, RefusesNamingTheField) {
  struct { const char *message, *where; } wrong[] = {
      {"", "message"}, {"[]", "message"}, {"{", "message"}, {"7", "message"}, {"\xff", "message"}, {"{}", "do"},
      {R"({"do":7})", "do"}, {R"({"do":"shout"})", "do"}, {R"({"do":"toggle"})", "what"}, {R"({"do":"toggle","what":"sun"})", "what"},
      {R"({"do":"set","what":"dt","value":0})", "dt"}, {R"({"do":"set","what":"dt","value":1})", "dt"}, {R"({"do":"set","what":"dt","value":"1"})", "value"},
      {R"({"do":"set","what":"restitution","value":1.01})", "restitution"}, {R"({"do":"set","what":"static_friction","value":-1})", "static_friction"},
      {R"({"do":"set","what":"mass","value":1})", "what"}, {R"({"do":"set","what":"dt","value":1e999})", "message"},
      {R"({"do":"method","value":"located"})", "value"}, {R"({"do":"method"})", "value"},
      {R"({"do":"hold","body":10,"at":[0,0,0],"to":[0,0,0]})", "body"}, {R"({"do":"hold","body":-1,"at":[0,0,0],"to":[0,0,0]})", "body"},
      {R"({"do":"hold","body":0.5,"at":[0,0,0],"to":[0,0,0]})", "body"}, {R"({"do":"hold","body":0,"at":[9,0,0],"to":[0,0,0]})", "at"},
      {R"({"do":"hold","body":0,"at":[0,0],"to":[0,0,0]})", "at"}, {R"({"do":"hold","body":0,"at":[0,0,0],"to":[0,1e9,0]})", "to"},
      {R"({"do":"hold","body":0,"at":[0,0,0],"to":[0,null,0]})", "to"}};
  LiveScene here = live("assignment");
  const std::string before = here.status();
  for (const auto& [message, where] : wrong) {
    const auto done = here.obey(message, 0);
    ASSERT_FALSE(done) << message;
    EXPECT_EQ(done.fault().where, where) << message;
  }
  EXPECT_EQ(here.status(), before) << "nothing was done";
  const auto located = LiveScene::make([] { Scene s = builtin_scene("drop", 1); s.method = "located"; return s; }(), {});
  ASSERT_FALSE(located);
  EXPECT_EQ(located.fault().where, "method");
}

// A law that asks for mu_d <= mu_s goes on asking.
TEST(LiveScene, KeepsWhatTheFrictionLawAsks) {
  Scene scene = builtin_scene("slide", 1);
  scene.friction_law = FrictionLaw::coulomb;
  LiveScene here = *LiveScene::make(scene, [&](std::uint64_t) { return scene; });
  EXPECT_FALSE(says(here, R"({"do":"set","what":"dynamic_friction","value":0.4})"));
  EXPECT_TRUE(says(here, R"({"do":"set","what":"dynamic_friction","value":0.1})"));
}

// No message ends in anything but a fault or a deed; accounts stay JSON whatever the hand does.
RC_GTEST_PROP(LiveScene, SurvivesAnyMessage, ()) {
  LiveScene here = live("assignment");
  const auto pieces = *rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
      "{", "}", "[", "]", "\"do\"", ":", ",", "\"hold\"", "\"set\"", "\"what\"", "\"dt\"", "\"value\"", "1e308", "-0", "null", "\"\\u0000\"", "\xc3", "\"to\"", "\"body\"", "18446744073709551616"));
  std::string text;
  for (const std::string& piece : pieces) text += piece;
  (void)here.obey(text, 0);
  (void)here.obey(run, 0);
  here.advance(0.02, 60);
  RC_ASSERT(Json::accept(here.status()) && Json::accept(here.description()));
}

// Past what is finite the scene stands still, says so, and begins anew. 5e307 m/s^2 leads a position out
// of double's range after 2.7 s.
TEST(LiveScene, StopsWhereNumbersEnd) {
  Scene scene = builtin_scene("tumble", 1);
  scene.forces.push_back({0, V(5e307, 0, 0), zero3<double>(), false, 0, 100});
  LiveScene here = *LiveScene::make(scene, [&](std::uint64_t) { return scene; });
  ASSERT_TRUE(says(here, run));
  for (int k = 0; k < 20; ++k) here.advance(0.25, 60);
  EXPECT_FALSE(here.running());
  EXPECT_NEAR(here.t(), std::sqrt(2 * (1.797e308 / 5e307)), 2.0 / 240);  // the lead of half a step, and the step itself
  EXPECT_FALSE(Json::parse(here.status())["finite"]);
  EXPECT_EQ(here.frame().size(), 16u + 4 * 7);
  ASSERT_TRUE(says(here, run));
  EXPECT_FALSE(here.running()) << "there is nothing to go on with";
  ASSERT_TRUE(says(here, R"({"do":"new"})"));
  EXPECT_TRUE(Json::parse(here.status())["finite"]);
}

}  // namespace
}  // namespace rigor::live
