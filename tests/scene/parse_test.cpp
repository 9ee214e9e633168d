// Every bad field: one typed fault that names file, field, value and range (case S-08).
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <rigor/base/file.hpp>
#include <rigor/scene/scene.hpp>
#include <set>

namespace rigor {
namespace {

const char* good = R"({"$schema": "scene.schema.json",
  "cuboids": [{"size": [1, 2, 3], "mass": 2, "position": [0, 4, 0], "orientation": [0.5, 0.5, 0.5, 0.5], "velocity": [1, 0, 0], "spin": [0, 0, 2]}],
  "planes": [{"point": [0, 0, 0], "normal": [0, 1, 0]}],
  "gravity": [0, -9.8, 0], "restitution": 0.5, "static_friction": 0.5, "dynamic_friction": 0.3, "friction_law": "sheet", "pair_detection": "15-axes",
  "forces": [{"body": 0, "force": [0, 5, 0], "at": [0.1, 0, 0], "at_axes": "body", "from": 1, "to": 2}],
  "actions": [{"at": 3, "do": "vacuum-on"}, {"at": 5, "do": "vacuum-off"}],
  "method": "sheet", "dt": 0.004, "until": 10, "every": 0.05, "seed": 7, "name": "mine"
})";

TEST(ParseScene, ReadsEveryKey) {
  const auto s = parse_scene(good, "f.json");
  ASSERT_TRUE(s) << s.fault().text();
  EXPECT_EQ(s->name, "mine");
  EXPECT_EQ(s->bodies[0].shape.size()[2], 3);
  EXPECT_EQ(s->bodies[0].start.R_WB(1, 0), 1);  // a third of a turn about (1, 1, 1): x goes to y
  EXPECT_EQ(s->bodies[0].start.w_WB[2], 2);
  EXPECT_TRUE(s->forces[0].at_turns);
  EXPECT_EQ(s->actions[1].what, SceneAction::Do::vacuum_off);
  EXPECT_EQ(s->surface.dynamic_friction(), 0.3);
  EXPECT_EQ(s->every, 0.05);
  EXPECT_EQ(s->seed, 7u);
}

// Limits are about what a run does: steps where there are steps, rows where they are asked for.
TEST(ParseScene, LimitsStepsAndRows) {
  const auto read = [](const std::string& keys) {
    const auto s = parse_scene(R"({"cuboids": [{"size": [1, 1, 1], "mass": 1, "position": [0, 0, 0]}], )" + keys + "}", "f.json");
    return s ? "" : s.fault().text();
  };
  EXPECT_EQ(read(R"("dt": 1e-12, "until": 10)"), "f.json: dt is 1e-12, gives more than 1e12 steps until 10");
  EXPECT_EQ(read(R"("dt": 1e-12, "until": 1e10, "method": "located")"), "") << "no steps; by default ten thousand rows";
  EXPECT_EQ(read(R"("every": 1e-9, "until": 10, "method": "located")"), "f.json: until is 10 and every 1e-09, gives 1e+10 rows of 1 cuboid, at most 2e7 are kept");
  EXPECT_EQ(read(R"("every": 1e-9, "until": 10)"), "") << "a step gives one row at most";
  EXPECT_EQ(read(R"("every": 1e-7, "dt": 1e-7, "until": 10)"), "f.json: until is 10 and every 1e-07, gives 1e+08 rows of 1 cuboid, at most 2e7 are kept");
  EXPECT_EQ(read(R"("dt": 1e-7, "until": 10)"), "") << "nobody asked for rows: who keeps them asks";
}

// A JSON pointer, the value put there, and what must be said.
struct Bad {
  const char *where, *value, *says;
};
TEST(ParseScene, NamesFileFieldValueAndRangeOfEverythingWrong) {
  const Bad table[] = {
      {"/cuboids/0/mass", "0", "f.json: cuboids[0].mass is 0, must be in [1e-30, 1e30]"},
      {"/cuboids/0/mass", "-1", "f.json: cuboids[0].mass is -1, must be in [1e-30, 1e30]"},
      {"/cuboids/0/mass", "\"2\"", "f.json: cuboids[0].mass must be a number, in [1e-30, 1e30]"},
      {"/cuboids/0/size/1", "-2", "f.json: cuboids[0].size[1] is -2, must be in [1e-30, 1e30]"},
      {"/cuboids/0/size", "[1, 2]", "f.json: cuboids[0].size must be a list of 3 numbers"},
      {"/cuboids/0/size", "[1e200, 1e200, 1e200]", "f.json: cuboids[0].size[0] is 1e+200, must be in [1e-30, 1e30]"},
      {"/cuboids/0/size/2", "5e-324", "f.json: cuboids[0].size[2] is 5e-324, must be in [1e-30, 1e30]"},
      {"/cuboids/0/position/0", "null", "f.json: cuboids[0].position[0] must be a number, in [-1e30, 1e30]"},
      {"/cuboids/0/orientation", "[1, 1, 0, 0]", "f.json: cuboids[0].orientation has length 1.4142135623730951, a quaternion must have length 1 within 1e-9"},
      {"/cuboids/0/orientation", "[[1, 0, 0], [0, 1, 0], [0, 0, 2]]", "f.json: cuboids[0].orientation is off orthonormal by 3, at most 1e-9 is allowed"},
      {"/cuboids/0/orientation", "[[1, 0, 0], [0, 1, 0], [0, 0, -1]]", "f.json: cuboids[0].orientation is a reflection (determinant -1), must be a rotation"},
      {"/cuboids/0/color", "1", "f.json: cuboids[0] has an unknown key 'color'"},
      {"/cuboids/0/masss", "1", "f.json: cuboids[0] has an unknown key 'masss' (did you mean 'mass'?)"},
      {"/planes/0/normal", "[0, 0, 0]", "f.json: planes[0].normal has length 0, must have length 1 within 1e-9"},
      {"/planes/0/normal", "[0, 2, 0]", "f.json: planes[0].normal has length 2, must have length 1 within 1e-9"},
      {"/restitution", "1.0000001", "f.json: restitution is 1.0000001, must be in [0, 1]"},
      {"/restitution", "-1e-9", "f.json: restitution is -1e-09, must be in [0, 1]"},
      {"/static_friction", "-0.1", "f.json: static_friction is -0.1, must be in [0, 1e30]"},
      {"/dynamic_friction", "-0.1", "f.json: dynamic_friction is -0.1, must be in [0, 1e30]"},
      {"/friction_law", "\"coulom\"", "f.json: friction_law is \"coulom\", must be one of sheet, sheet_literal, coulomb, stronge (did you mean 'coulomb'?)"},
      {"/pair_detection", "3", "f.json: pair_detection is 3, must be one of 15-axes, handed-out"},
      {"/forces/0/body", "1", "f.json: forces[0].body is 1, must be an index in [0, 1)"},
      {"/forces/0/body", "0.5", "f.json: forces[0].body is 0.5, must be an index in [0, 1)"},
      {"/forces/0/to", "0.5", "f.json: forces[0].to is 0.5, must be from `from` to 1e30 s"},
      {"/actions/0/do", "\"vacuum\"", "f.json: actions[0].do is \"vacuum\", must be one of vacuum-on, vacuum-off, gravity-on, gravity-off"},
      {"/actions/1/at", "1", "f.json: actions[1].at is 1, must not be before the action above it"},
      {"/method", "\"shet\"", "f.json: method is 'shet', which is none of the methods (did you mean 'sheet'?)"},
      {"/dt", "0", "f.json: dt is 0, must be in [1e-30, 1e30] s"},
      {"/dt", "-0.01", "f.json: dt is -0.01, must be in [1e-30, 1e30] s"},
      {"/dt", "1e-20", "f.json: dt is 1e-20, gives more than 1e12 steps until 10"},
      {"/until", "-1", "f.json: until is -1, must be in [0, 1e30] s"},
      {"/every", "-1", "f.json: every is -1, must be 0 (each step) or at most 1e30 s"},
      {"/gravity/1", "-1e155", "f.json: gravity[1] is -1e+155, must be in [-1e30, 1e30]"},
      {"/seed", "-1", "f.json: seed is -1, must be a whole number from 0 to 18446744073709551615"},
      {"/restituton", "1", "f.json: scene has an unknown key 'restituton' (did you mean 'restitution'?)"},
      {"/cuboids", "3", "f.json: cuboids must be a list [...]"},
  };
  for (const Bad& bad : table) {
    auto json = nlohmann::json::parse(good);
    json[nlohmann::json::json_pointer(bad.where)] = nlohmann::json::parse(bad.value);
    const auto s = parse_scene(json.dump(), "f.json");
    ASSERT_FALSE(s) << bad.where << " = " << bad.value;
    EXPECT_EQ(s.fault().text().substr(0, std::string(bad.says).size()), bad.says);
  }
}

TEST(ParseScene, RefusesWhatIsNoScene) {
  for (const char* text : {"", "{", "[]", "nonsense", "{\"cuboids\": [NaN]}", "\xff\xfe\x00\x01", "{\"cuboids\": [], \"dt\": 1e999}"})
    EXPECT_FALSE(parse_scene(text, "f.json")) << text;
  EXPECT_EQ(parse_scene("", "f.json").fault().text(), "f.json: is empty, must be a scene in JSON");
  EXPECT_EQ(parse_scene("null", "f.json").fault().text(), "f.json: scene must be an object {...}");
  EXPECT_EQ(parse_scene("{\"cuboids\": [], \"dt\": 1e999}", "f.json").fault().text(), "f.json: dt is 1e999, must be in [-1e30, 1e30]");
  EXPECT_EQ(parse_scene("{\"cuboids\": [{\"size\": [1, 2, -1e400]}]}", "f.json").fault().text(), "f.json: cuboids[0].size[2] is -1e400, must be in [-1e30, 1e30]");
  EXPECT_EQ(parse_scene("{\"cuboids\": [], \"forces\": [{\"body\": 0, \"force\": [1, 0, 0]}]}", "f.json").fault().text(), "f.json: forces[0].body is 0, but the scene has no cuboid");
  EXPECT_EQ(parse_scene("{\"planes\": []}", "f.json").fault().text(), "f.json: cuboids is missing");
  EXPECT_EQ(parse_scene("{\"cuboids\": [], \"dt\": 1, \"dt\": 2}", "f.json").fault().text(), "f.json: scene has the key 'dt' twice, the second time in line 1");
  EXPECT_EQ(parse_scene("{\"planes\": [[1], {\"a\": 0}],\n\"cuboids\": [{\"size\": [1, 2], \"x\": {}},\n {\"mass\": 1,\n  \"mass\": 2}]}", "f.json").fault().text(),
            "f.json: cuboids[1] has the key 'mass' twice, the second time in line 4");
  EXPECT_EQ(parse_scene("{\"a\": {\"b\": [[{}, {\"c\": 1, \"c\": 2}]]}}", "f.json").fault().text(), "f.json: a.b[0][1] has the key 'c' twice, the second time in line 1");
  EXPECT_EQ(parse_scene(std::string(100000, '['), "f.json").fault().text(), "f.json: scene nests deeper than 16 levels");
  EXPECT_TRUE(parse_scene("{\"cuboids\": []}", "f.json")) << "an empty world is a world";
  EXPECT_TRUE(parse_scene("{\"$schema\": \"scene.schema.json\", \"cuboids\": []}", "f.json")) << "what an editor writes";
}

TEST(ParseScene, NeverCrashesOnDamagedText) {
  std::mt19937 random(3);
  for (int k = 0; k < 3000; ++k) {
    std::string text = good;
    for (int n = 1 + int(random() % 4); n > 0; --n) {
      const std::size_t at = random() % text.size();
      switch (random() % 3) {
        case 0: text[at] = char(random()); break;
        case 1: text.erase(at, 1 + random() % 9); break;
        default: text.insert(at, 1, "0e-[]{}\",:"[random() % 10]);
      }
    }
    const auto s = parse_scene(text, "f.json");
    if (!s) {
      EXPECT_EQ(s.fault().where.substr(0, 7), "f.json:");
    }
  }
}

TEST(Schema, HasTheKeysThatAreAccepted) {
  const auto schema = nlohmann::json::parse(std::ifstream(RIGOR_SOURCE_DIR "/docs/schema/scene.schema.json"));
  const auto scene = nlohmann::json::parse(good);
  const auto keys = [](const nlohmann::json& object) {
    std::set<std::string> all;
    for (const auto& [key, value] : object.items()) all.insert(key);
    return all;
  };
  EXPECT_EQ(keys(schema["properties"]), keys(scene));
  for (const char* part : {"cuboids", "planes", "forces", "actions"})
    EXPECT_EQ(keys(schema["properties"][part]["items"]["properties"]), keys(scene[part][0])) << part;
}

TEST(OpenScene, KnowsTheBuiltInsAndSuggestsThem) {
  for (const std::string& name : builtin_scenes()) EXPECT_TRUE(open_scene(name));
  EXPECT_EQ(open_scene("assignment", 3)->bodies[0].start.p_WB, open_scene("assignment", 3)->bodies[0].start.p_WB);
  EXPECT_NE(open_scene("assignment", 3)->bodies[0].start.p_WB, open_scene("assignment", 4)->bodies[0].start.p_WB);
  EXPECT_NE(open_scene("asignment").fault().text().find("did you mean 'assignment'?"), std::string::npos);
  EXPECT_FALSE(open_scene("/nowhere/at/all.json"));
}

}  // namespace
}  // namespace rigor
