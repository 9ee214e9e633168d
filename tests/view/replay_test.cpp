// What lies in a replay page: inert data that reads back, bounded size, names that stay names. How it looks and moves is
// for replay.mjs.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <rapidcheck/gtest.h>
#include <rigor/scene/trajectory.hpp>
#include <rigor/view/replay.hpp>
#include <rigor/view/texts.hpp>

namespace rigor::view {
namespace {

using Json = nlohmann::json;

Recording record(const Scene& scene, const std::string& name = "run") {
  Recording recording(scene, name);
  simulate(scene, [&](double t, const auto& states) { recording.add(t, states); }, [&](const Impact& impact) { recording.impact(impact); });
  return recording;
}
// A decoder of its own: RFC 4648, one digit after another.
template <class T>
std::vector<T> unpacked(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int have = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6 | unsigned(digits.find(c)), have += 6;
    if (have >= 8) bytes += char(bits >> (have -= 8) & 255);
  }
  std::vector<T> values(bytes.size() / sizeof(T));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
  return values;
}
bool have_bundle() { return !text_named("replay.js", texts()).empty(); }
// The text of <script type="application/json">, as a browser cuts it: up to the first end tag.
std::string data_of(const std::string& page) {
  const std::string start = "<script type=\"application/json\" id=\"data\">";
  const std::size_t from = page.find(start) + start.size();
  return page.substr(from, page.find("</", from) - from);
}

TEST(Recording, KeepsPosesAndVelocitiesWithinItsSteps) {
  Scene scene = builtin_scene("assignment", 4);
  scene.until = 3;
  std::vector<double> t;
  std::vector<std::vector<State<double>>> all;
  Recording recording(scene, "run");
  simulate(scene, [&](double at, const auto& states) { recording.add(at, states), t.push_back(at), all.push_back(states); });
  const Json run = recording.packed();
  const auto times = unpacked<double>(run["t"]);
  const auto p = unpacked<float>(run["p"]);
  const auto q = unpacked<std::int16_t>(run["q"]);
  const auto v = unpacked<std::int16_t>(run["v"]["steps"]);
  const double largest = run["v"]["largest"], n = double(scene.bodies.size());
  ASSERT_EQ(times, t) << "1/30 s apart: nothing is dropped";
  ASSERT_EQ(p.size(), times.size() * 3 * std::size_t(n));
  for (std::size_t k = 0; k < t.size(); k += 7)
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const State<double>& s = all[k][i];
      const Vec4<double> wanted = quaternion_of<double>(s.R_WB);
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(p[3 * (k * 10 + i) + c], s.p_WB[c], std::fabs(s.p_WB[c]) * 0x1p-24);
        // half a step, and float32's rounding of value and largest
        EXPECT_NEAR(v[3 * (k * 10 + i) + c] * largest / 32767, s.v_WB[c], largest * (0.5 / 32767 + 0x1p-22));
      }
      for (int c = 0; c < 4; ++c) EXPECT_NEAR(q[4 * (k * 10 + i) + c] / 32767.0, wanted[c], 0.5 / 32767 + 0x1p-22);
    }
}

// The impulses of a frame are summed over pairs, so their total is what the run gave: m (v_end - v_start) - m g t.
TEST(Recording, KeepsTheSumOfImpulsesThroughThinning) {
  Scene scene = builtin_scene("drop", 1);
  scene.every = 0;
  std::vector<State<double>> end;
  Recording recording(scene, "run");
  simulate(scene, [&](double t, const auto& states) { recording.add(t, states), end = states; }, [&](const Impact& impact) { recording.impact(impact); });
  const Json run = recording.packed();
  const auto j = unpacked<std::int16_t>(run["touches"]["j"]["steps"]);
  const double largest = run["touches"]["j"]["largest"], m = scene.bodies[0].shape.mass();
  double sum = 0;
  for (std::size_t k = 1; k < j.size(); k += 3) sum += j[k] * largest / 32767;
  EXPECT_NEAR(sum, m * end[0].v_WB[1] + m * 9.8 * 3, double(j.size() / 3) * largest * (0.5 / 32767 + 0x1p-22));
  EXPECT_LE(recording.frames(), 182u) << "1/60 s apart";
}

// r x j of the point shown is the change of angular momentum; and of all such points it is the nearest to the centre.
TEST(Recording, ShowsAnImpulseKnownByItsEffectOnItsLineOfAction) {
  const Scene scene = builtin_scene("tumble", 1);
  State<double> before = scene.bodies[0].start, after = before;
  before.p_WB = after.p_WB = {4, 5, 6};
  const Vec3<double> j(0.3, -1.2, 2.0), r(0.4, 0.9, -0.7);
  const Vec3<double> I = scene.bodies[0].shape.inertia();  // the start's axes are the world's
  after.v_WB += j / scene.bodies[0].shape.mass();
  const Vec3<double> turned(r[1] * j[2] - r[2] * j[1], r[2] * j[0] - r[0] * j[2], r[0] * j[1] - r[1] * j[0]);
  for (int k = 0; k < 3; ++k) after.w_WB[k] += turned[k] / I[k];
  Recording recording(scene, "run");
  recording.impact(0, before, after);
  recording.add(0, {after});
  const Json touches = recording.packed()["touches"];
  const auto p = unpacked<std::int16_t>(touches["p"]["steps"]);
  const double largest = touches["p"]["largest"];
  const Vec3<double> nearest = r - j * (r.dot(j) / j.dot(j));
  ASSERT_EQ(p.size(), 3u);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(p[k] * largest / 32767, after.p_WB[k] + nearest[k], largest * (0.5 / 32767 + 0x1p-22));
}

// Ten cuboids for a minute, each step offered, nearly all of it in contact: under 3 MB.
TEST(Recording, KeepsAMinuteOfTenCuboidsUnderThreeMegabytes) {
  Scene scene = builtin_scene("assignment", 3);
  scene.until = 60;
  scene.every = 0;
  const Recording recording = record(scene);
  EXPECT_GE(recording.frames(), 1800u) << "no coarser than 1/30 s";
  EXPECT_LE(recording.packed().dump().size() + text_named("replay.js", texts()).size() + text_named("replay.css", texts()).size(), 3'000'000u);
}

RC_GTEST_PROP(Replay, NamesAndTitlesAreNeverMarkup, ()) {
  if (!have_bundle()) return;
  const auto pieces = *rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
      "</script>", "<script>alert(1)</script>", "<!--", "-->", "\"", "'", "&lt;", "<", ">", "]]>", "\\", "\xff", "\n", "<img src=x onerror=alert(1)>", "\u2028", "x"));
  std::string name;
  for (const std::string& piece : pieces) name += piece;
  Scene scene = builtin_scene("tumble", 1);
  scene.until = 0.02;
  const auto page = replay_page({record(scene, name)}, name, name);
  RC_ASSERT(bool(page));
  std::string plain = *page;
  const std::string data = data_of(plain);
  RC_ASSERT(Json::accept(data));
  RC_ASSERT(data.find('<') == std::string::npos);
  // what is left without the data and our own script has the tags of a page with a harmless name, no more
  const auto tags = [](const std::string& text) { return std::count(text.begin(), text.end(), '<'); };
  RC_ASSERT(tags(plain) == tags(*replay_page({record(scene, "x")}, "x", "x")));
}

// A state that is not finite ends what is shown; the page is still whole.
TEST(Replay, StopsAtANumberThatIsNotFinite) {
  const Scene scene = builtin_scene("tumble", 1);
  Recording recording(scene, "run");
  std::vector<State<double>> states{scene.bodies[0].start};
  recording.add(0, states);
  states[0].w_WB[1] = std::nan("");
  recording.add(scene.until, states);
  EXPECT_EQ(recording.frames(), 1u);
  EXPECT_EQ(bool(replay_page({recording}, "x", "y")), have_bundle());
}

TEST(Replay, LoadsNothingAndSaysWhyWhereItWasNotBundled) {
  const auto page = replay_page({record(builtin_scene("drop", 1))}, "drop", "");
  if (!have_bundle()) {
    EXPECT_FALSE(page);
    EXPECT_NE(page.fault().text().find("npm"), std::string::npos);
    return;
  }
  ASSERT_TRUE(page);
  EXPECT_NE(page->find("default-src 'none'"), std::string::npos);
  EXPECT_EQ(page->find("script-src 'unsafe-inline'"), std::string::npos);
  for (const char* outside : {" src=", "@import", "url("}) EXPECT_EQ(page->substr(0, page->find("<script")).find(outside), std::string::npos) << outside;
}

}  // namespace
}  // namespace rigor::view
