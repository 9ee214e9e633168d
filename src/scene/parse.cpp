#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <rigor/base/file.hpp>
#include <rigor/base/suggest.hpp>
#include <rigor/integrators/method.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/scene/method_names.hpp>
#include <rigor/scene/scene.hpp>
#include <set>

namespace rigor {
namespace {

using Json = nlohmann::json;
using Kind = Fault::Kind;
using V = Vec3<double>;

std::string shown(double x) {
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, x);
  return std::string(text, end.ptr);
}

// Throws the first fault; caught in parse_scene. The rest of the file then reads straight down.
struct Refused {
  Fault fault;
};
[[noreturn]] void refuse(Kind kind, const std::string& where, const std::string& what) { throw Refused{{kind, where, what}}; }

void known_keys(const Json& object, const std::string& where, const std::vector<std::string>& keys) {
  if (!object.is_object()) refuse(Kind::wrong_type, where.empty() ? "scene" : where, "must be an object {...}");
  for (const auto& [key, value] : object.items())
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      refuse(Kind::unknown_key, where.empty() ? "scene" : where, "has an unknown key '" + key + "'" + did_you_mean(key, keys));
}

double number(const Json& value, const std::string& where, double low, double high, const char* range) {
  if (!value.is_number()) refuse(Kind::wrong_type, where, "must be a number, " + std::string(range));
  const double x = value.get<double>();
  if (!std::isfinite(x)) refuse(Kind::not_finite, where, "is not finite, must be " + std::string(range));
  if (!(x >= low && x <= high)) refuse(Kind::out_of_range, where, "is " + shown(x) + ", must be " + range);
  return x;
}
// Every number of a scene keeps to thirty powers of ten, so that energies, momenta and their squares stay numbers.
constexpr double most = 1e30, least = 1e-30;
constexpr const char* any_number = "in [-1e30, 1e30]";
constexpr const char* some = "in [1e-30, 1e30]";

std::string element(const std::string& where, std::size_t i) { return where + "[" + std::to_string(i) + "]"; }

const Json& list(const Json& value, const std::string& where, std::size_t length) {
  if (!value.is_array() || (length != 0 && value.size() != length))
    refuse(Kind::wrong_type, where, length == 0 ? "must be a list [...]" : "must be a list of " + std::to_string(length) + " numbers");
  return value;
}
V vector(const Json& value, const std::string& where) {
  V v;
  list(value, where, 3);
  for (std::size_t i = 0; i < 3; ++i) v[int(i)] = number(value[i], element(where, i), -most, most, any_number);
  return v;
}
std::string word(const Json& value, const std::string& where, const std::vector<std::string>& words) {
  std::string text;
  if (value.is_string()) text = value.get<std::string>();
  if (std::find(words.begin(), words.end(), text) != words.end()) return text;
  std::string all;
  for (const std::string& w : words) all += (all.empty() ? "" : ", ") + w;
  refuse(Kind::out_of_range, where, "is " + value.dump().substr(0, 40) + ", must be one of " + all + did_you_mean(text, words));
}
bool has(const Json& object, const char* key) { return object.contains(key); }
const Json& required(const Json& object, const char* key, const std::string& where) {
  if (!has(object, key)) refuse(Kind::missing, where.empty() ? key : where + "." + key, "is missing");
  return object.at(key);
}

// A quaternion (w, x, y, z) or a 3x3 matrix by rows. Refused when not a rotation within 1e-9: nothing is repaired.
Mat3<double> orientation(const Json& value, const std::string& where) {
  if (value.is_array() && value.size() == 4) {
    Vec4<double> q;
    for (std::size_t i = 0; i < 4; ++i) q[int(i)] = number(value[i], element(where, i), -most, most, any_number);
    const double length = std::sqrt(q.dot(q));
    if (!(std::fabs(length - 1) <= 1e-9)) refuse(Kind::not_unit, where, "has length " + shown(length) + ", a quaternion must have length 1 within 1e-9");
    return rotation_of<double>(q);
  }
  if (!value.is_array() || value.size() != 3) refuse(Kind::wrong_type, where, "must be a quaternion [w, x, y, z] or three rows of three numbers");
  Mat3<double> R;
  for (std::size_t i = 0; i < 3; ++i) R.row(int(i)) = vector(value[i], element(where, i)).transpose();
  const double defect = orthonormality_defect<double>(R);
  if (!(defect <= 1e-9)) refuse(Kind::not_orthonormal, where, "is off orthonormal by " + shown(defect) + ", at most 1e-9 is allowed");
  if (dot<double>(cross<double>(R.col(0), R.col(1)), R.col(2)) < 0) refuse(Kind::not_orthonormal, where, "is a reflection (determinant -1), must be a rotation");
  return R;
}

template <class T>
T made(Outcome<T> outcome, const std::string& where) {
  if (!outcome) throw Refused{outcome.fault().inside(where)};
  return std::move(outcome).value();
}

SceneBody body(const Json& json, const std::string& where) {
  known_keys(json, where, {"size", "mass", "position", "orientation", "velocity", "spin"});
  V size;
  const Json& edges = list(required(json, "size", where), where + ".size", 3);
  for (std::size_t i = 0; i < 3; ++i) size[int(i)] = number(edges[i], element(where + ".size", i), least, most, some);
  const double mass = number(required(json, "mass", where), where + ".mass", least, most, some);
  SceneBody b{made(Cuboid<double>::make(mass, size), where), {}};
  b.start.p_WB = vector(required(json, "position", where), where + ".position");
  if (has(json, "orientation")) b.start.R_WB = orientation(json["orientation"], where + ".orientation");
  if (has(json, "velocity")) b.start.v_WB = vector(json["velocity"], where + ".velocity");
  if (has(json, "spin")) b.start.w_WB = vector(json["spin"], where + ".spin");
  return b;
}
Plane<double> plane(const Json& json, const std::string& where) {
  known_keys(json, where, {"point", "normal"});
  const V point = vector(required(json, "point", where), where + ".point"), normal = vector(required(json, "normal", where), where + ".normal");
  const auto plane = Plane<double>::make(point, normal);
  if (!plane) refuse(Kind::not_unit, where + ".normal", "has length " + shown(norm<double>(normal)) + ", must have length 1 within 1e-9");
  return *plane;
}
SceneForce force(const Json& json, const std::string& where, std::size_t bodies) {
  known_keys(json, where, {"body", "force", "at", "at_axes", "from", "to"});
  SceneForce f{};
  const Json& index = required(json, "body", where);
  if (bodies == 0) refuse(Kind::out_of_range, where + ".body", "is " + index.dump().substr(0, 40) + ", but the scene has no cuboid");
  if (!index.is_number_integer() || index.get<long>() < 0 || index.get<long>() >= long(bodies))
    refuse(Kind::out_of_range, where + ".body", "is " + index.dump().substr(0, 40) + ", must be an index in [0, " + std::to_string(bodies) + ")");
  f.body = index.get<int>();
  f.force = vector(required(json, "force", where), where + ".force");
  if (has(json, "at")) f.at = vector(json["at"], where + ".at");
  if (has(json, "at_axes")) f.at_turns = word(json["at_axes"], where + ".at_axes", {"body", "world"}) == "body";
  f.from = has(json, "from") ? number(json["from"], where + ".from", 0, most, "in [0, 1e30] s") : 0;
  f.to = has(json, "to") ? number(json["to"], where + ".to", f.from, most, "from `from` to 1e30 s") : most;
  return f;
}
SceneAction action(const Json& json, const std::string& where) {
  known_keys(json, where, {"at", "do"});
  const std::vector<std::string> words{"vacuum-on", "vacuum-off", "gravity-on", "gravity-off"};
  const std::string what = word(required(json, "do", where), where + ".do", words);
  return {number(required(json, "at", where), where + ".at", 0, most, "in [0, 1e30] s"), SceneAction::Do(std::find(words.begin(), words.end(), what) - words.begin())};
}

const std::vector<std::string> scene_keys{"$schema", "name", "cuboids", "planes", "gravity", "restitution", "static_friction", "dynamic_friction", "friction_law",
                                          "pair_detection", "forces", "actions", "method", "dt", "until", "every", "seed"};

Scene from_json(const Json& json) {
  known_keys(json, "", scene_keys);
  Scene s;
  if (has(json, "$schema") && !json["$schema"].is_string()) refuse(Kind::wrong_type, "$schema", "must be a text in quotes");  // an editor's; not read here
  if (has(json, "name")) {
    if (!json["name"].is_string()) refuse(Kind::wrong_type, "name", "must be a text in quotes");
    s.name = json["name"];
  }
  const Json& cuboids = list(required(json, "cuboids", ""), "cuboids", 0);
  for (std::size_t i = 0; i < cuboids.size(); ++i) s.bodies.push_back(body(cuboids[i], element("cuboids", i)));
  if (has(json, "planes"))
    for (std::size_t i = 0; i < list(json["planes"], "planes", 0).size(); ++i) s.planes.push_back(plane(json["planes"][i], element("planes", i)));
  if (has(json, "gravity")) s.gravity = vector(json["gravity"], "gravity");
  const auto coefficient = [&](const char* key, double high, const char* range) { return has(json, key) ? number(json[key], key, 0, high, range) : 0; };
  const double mu_s = coefficient("static_friction", most, "in [0, 1e30]");
  const double mu_d = has(json, "dynamic_friction") ? coefficient("dynamic_friction", most, "in [0, 1e30]") : mu_s;
  s.surface = made(Surface<double>::make(coefficient("restitution", 1, "in [0, 1]"), mu_s, mu_d), "");
  if (has(json, "friction_law")) s.friction_law = *friction_law_named(word(json["friction_law"], "friction_law", {"sheet", "sheet_literal", "coulomb", "stronge"}));
  if (has(json, "pair_detection")) s.pair_detection = word(json["pair_detection"], "pair_detection", {"15-axes", "handed-out"}) == "handed-out" ? PairDetection::handed_out : PairDetection::axes;
  if (has(json, "forces"))
    for (std::size_t i = 0; i < list(json["forces"], "forces", 0).size(); ++i) s.forces.push_back(force(json["forces"][i], element("forces", i), s.bodies.size()));
  if (has(json, "actions"))
    for (std::size_t i = 0; i < list(json["actions"], "actions", 0).size(); ++i) s.actions.push_back(action(json["actions"][i], element("actions", i)));
  if (has(json, "method")) {
    if (!json["method"].is_string()) refuse(Kind::wrong_type, "method", "must be a text in quotes");
    s.method = json["method"];
  }
  if (has(json, "dt")) s.dt = number(json["dt"], "dt", least, most, "in [1e-30, 1e30] s");
  if (has(json, "until")) s.until = number(json["until"], "until", 0, most, "in [0, 1e30] s");
  if (has(json, "every")) s.every = number(json["every"], "every", 0, most, "0 (each step) or at most 1e30 s");
  if (has(json, "seed")) {
    if (!json["seed"].is_number_unsigned()) refuse(Kind::wrong_type, "seed", "is " + json["seed"].dump() + ", must be a whole number from 0 to 18446744073709551615");
    s.seed = json["seed"].get<std::uint64_t>();
  }
  return s;
}

// Text that counts the lines it has given away.
struct Counted {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;
  const char* at;
  long* line;
  reference operator*() const { return *at; }
  Counted& operator++() {
    *line += *at++ == '\n';
    return *this;
  }
  bool operator==(const Counted& other) const { return at == other.at; }
};

// JSON lets a key stand twice, and the last one would win in silence; and a file may nest deeper than any scene does.
Json parsed(const std::string& text) {
  struct Level {
    bool list;
    std::size_t index;          // of the element under way, where it is a list
    std::string key;            // of the value under way, where it is an object
    std::set<std::string> keys;
  };
  std::vector<Level> levels;
  long line = 1;
  const auto place = [&](std::size_t depth) {  // of what lies so deep
    std::string where;
    for (std::size_t i = 0; i < depth; ++i) where = levels[i].list ? element(where, levels[i].index) : where.empty() ? levels[i].key : where + "." + levels[i].key;
    return where.empty() ? "scene" : where;
  };
  const auto watch = [&](int depth, Json::parse_event_t event, Json& value) {
    using Event = Json::parse_event_t;
    if (depth > 16) refuse(Kind::malformed, "scene", "nests deeper than 16 levels");
    if (event == Event::object_start || event == Event::array_start) levels.push_back({event == Event::array_start, 0, "", {}});
    if (event == Event::object_end || event == Event::array_end) levels.pop_back();
    if (event == Event::key) {
      levels.back().key = value.get<std::string>();
      if (!levels.back().keys.insert(levels.back().key).second)
        refuse(Kind::malformed, place(levels.size() - 1), "has the key '" + levels.back().key + "' twice, the second time in line " + std::to_string(line));
    }
    const bool whole = event == Event::value || event == Event::object_end || event == Event::array_end;
    if (whole && !levels.empty() && levels.back().list) ++levels.back().index;
    return true;
  };
  try {
    return Json::parse(Counted{text.data(), &line}, Counted{text.data() + text.size(), &line}, watch);
  } catch (const Json::out_of_range& error) {  // "[json.exception.out_of_range.406] number overflow parsing '1e999'"
    const std::string what = error.what();
    const std::size_t from = what.find('\'') + 1;
    refuse(Kind::out_of_range, place(levels.size()), "is " + what.substr(from, std::min<std::size_t>(what.rfind('\'') - from, 40)) + ", must be " + any_number);
  }
}

}  // namespace

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const Method& method : methods()) names.emplace_back(method.name);
  return names;
}
std::vector<std::string> scene_methods() {
  std::vector<std::string> names = method_names();
  names.push_back("located");
  return names;
}

Outcome<bool> check_scene(const Scene& s) {
  if (const auto known = scene_methods(); std::find(known.begin(), known.end(), s.method) == known.end())
    return Fault{Kind::unsupported, "method", fmt::format("is '{}', which is none of the methods{}; known: {}", s.method, did_you_mean(s.method, known), fmt::join(known, ", "))};
  if (!(s.dt >= least && s.dt <= most)) return Fault{Kind::out_of_range, "dt", "is " + shown(s.dt) + ", must be in [1e-30, 1e30] s"};
  if (!(s.until >= 0 && s.until <= most)) return Fault{Kind::out_of_range, "until", "is " + shown(s.until) + ", must be in [0, 1e30] s"};
  if (s.method != "located" && s.until / s.dt > 1e12) return Fault{Kind::out_of_range, "dt", "is " + shown(s.dt) + ", gives more than 1e12 steps until " + shown(s.until)};
  if (!(s.every >= 0 && s.every <= most)) return Fault{Kind::out_of_range, "every", "is " + shown(s.every) + ", must be 0 (each step) or at most 1e30 s"};
  if (s.every > 0)
    if (const auto ok = check_rows(s); !ok) return ok.fault();
  for (std::size_t i = 1; i < s.actions.size(); ++i)
    if (s.actions[i].at < s.actions[i - 1].at) return Fault{Kind::out_of_range, element("actions", i) + ".at", "is " + shown(s.actions[i].at) + ", must not be before the action above it"};
  const bool cone = s.friction_law == FrictionLaw::coulomb || s.friction_law == FrictionLaw::stronge;
  if (cone && s.surface.dynamic_friction() > s.surface.static_friction())
    return Fault{Kind::out_of_range, "dynamic_friction", "is " + shown(s.surface.dynamic_friction()) + ", must not exceed static_friction with friction_law " + name(s.friction_law)};
  return true;
}

double output_interval(const Scene& s) {
  if (s.every > 0) return s.every;
  return s.method == "located" ? std::max(1.0 / 60, s.until / 1e4) : s.dt;
}
Outcome<bool> check_rows(const Scene& s) {
  constexpr double most_rows = 2e7;  // of 0.2 kB
  const double interval = s.method == "located" ? output_interval(s) : std::max(output_interval(s), s.dt);
  const double rows = double(s.bodies.size()) * (s.until / interval + 1);
  if (rows <= most_rows) return true;
  return Fault{Kind::out_of_range, "until", fmt::format("is {} and every {}, gives {:.3g} rows of {} cuboid{}, at most 2e7 are kept", shown(s.until), shown(s.every), rows, s.bodies.size(), s.bodies.size() == 1 ? "" : "s")};
}

Outcome<Scene> parse_scene(const std::string& text, const std::string& name) {
  if (text.empty()) return Fault{Kind::malformed, name + ":", "is empty, must be a scene in JSON"};
  try {
    Scene scene = from_json(parsed(text));
    if (const auto ok = check_scene(scene); !ok) throw Refused{ok.fault()};
    if (scene.name.empty()) scene.name = name;
    return scene;
  } catch (const Refused& refused) {
    Fault fault = refused.fault;
    fault.where = name + ": " + fault.where;
    return fault;
  } catch (const Json::exception& error) {
    const std::string what = error.what();  // "[json.exception.parse_error.101] parse error at line 3, ..."
    return Fault{Kind::malformed, name + ":", "is no JSON" + (what.find("at line") == std::string::npos ? std::string() : ": " + what.substr(what.find("] ") + 2, 160))};
  }
}

Outcome<Scene> open_scene(const std::string& path_or_name, std::uint64_t seed) {
  const auto names = builtin_scenes();
  if (std::find(names.begin(), names.end(), path_or_name) != names.end()) return builtin_scene(path_or_name, seed == 0 ? 1 : seed);
  const auto text = read_file(path_or_name, 64u << 20);
  if (!text) {
    Fault fault = text.fault();
    if (path_or_name.find('.') == std::string::npos && path_or_name.find('/') == std::string::npos) {
      fault.what = "is neither a file nor a built-in scene" + did_you_mean(path_or_name, names) + "; built in: ";
      for (const std::string& n : names) fault.what += (n == names.front() ? "" : ", ") + n;
    }
    return fault;
  }
  auto scene = parse_scene(*text, path_or_name);
  if (!scene || seed == 0) return scene;
  Scene seeded = *scene;
  seeded.seed = seed;
  return seeded;
}

}  // namespace rigor
