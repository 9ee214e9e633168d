#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <rigor/live/live_scene.hpp>
#include <rigor/scene/trajectory.hpp>

namespace rigor::live {
namespace {

using Json = nlohmann::ordered_json;
using V = Vec3<double>;
using Kind = Fault::Kind;

constexpr double shortest_dt = 1e-4, longest_dt = 1.0 / 30;  // s
constexpr std::size_t most_impacts = 2000;                   // in one frame: what the page draws

Json list(const V& v) { return {v[0], v[1], v[2]}; }
std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Outcome<V> vector(const Json& message, const char* field, double largest) {
  const auto found = message.find(field);
  if (found == message.end()) return Fault{Kind::missing, field, "is missing"};
  if (!found->is_array() || found->size() != 3) return Fault{Kind::wrong_type, field, "must be three numbers"};
  V v;
  for (int k = 0; k < 3; ++k) {
    const Json& x = (*found)[std::size_t(k)];
    if (!x.is_number()) return Fault{Kind::wrong_type, field, "must be three numbers"};
    v[k] = x.get<double>();
    if (!(std::fabs(v[k]) <= largest)) return Fault{Kind::out_of_range, field, "must be within " + std::to_string(largest) + " m"};
  }
  return v;
}
Outcome<std::string> word(const Json& message, const char* field) {
  const auto found = message.find(field);
  if (found == message.end()) return Fault{Kind::missing, field, "is missing"};
  if (!found->is_string()) return Fault{Kind::wrong_type, field, "must be a text"};
  return found->get<std::string>();
}
template <class T>
void put(std::string& bytes, T value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}
void put(std::string& bytes, const auto& values, int count) {
  for (int k = 0; k < count; ++k) put(bytes, float(values[k]));
}

}  // namespace

Outcome<LiveScene> LiveScene::make(const Scene& scene, Reseed reseed) {
  if (find_method(scene.method) == nullptr)
    return Fault{Kind::unsupported, "method", "is \"" + scene.method + "\", which has no step to go on by; give one that has, for example --method sheet"};
  return LiveScene(scene, std::move(reseed));
}
LiveScene::LiveScene(const Scene& scene, Reseed reseed) : reseed_(std::move(reseed)), world_(begin(scene)), dt_(scene.dt) {}

World LiveScene::begin(const Scene& scene) {
  impacts_->clear();
  return World(scene, [into = impacts_](const Impact& impact) {
    if (into->size() < most_impacts) into->push_back(impact);
  });
}

void LiveScene::advance(double seconds, double budget_s) {
  if (!running_ || !finite_) return;
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const double before = t();
  owed_ += seconds;
  for (; owed_ >= dt_ * (1 - 1e-9) && finite_; ++steps_, owed_ -= dt_) {
    if (std::chrono::duration<double>(Clock::now() - start).count() > budget_s) {
      owed_ = 0;
      break;
    }
    world_.step(t(), dt_);
    finite_ = world_.finite();
  }
  if (!finite_) running_ = false;
  asked_ = 0.97 * asked_ + seconds;
  done_ = 0.97 * done_ + t() - before;
}

Outcome<bool> LiveScene::obey(const std::string& text, int viewer) {
  const Json message = Json::parse(text, nullptr, false);
  if (!message.is_object()) return Fault{Kind::malformed, "message", "is no JSON object"};
  const auto what = word(message, "do");
  if (!what) return what.fault();
  if (*what == "toggle") {
    const auto of = word(message, "what");
    return of ? toggle(*of) : of.fault();
  }
  if (*what == "new") {
    new_seed();
    return true;
  }
  if (*what == "method") {
    const auto name = word(message, "value");
    if (!name) return name.fault();
    if (find_method(*name) == nullptr) return Fault{Kind::out_of_range, "value", "is no method"};
    world_.set_method(*name);
    return true;
  }
  if (*what == "set") {
    const auto of = word(message, "what");
    if (!of) return of.fault();
    const auto value = message.find("value");
    if (value == message.end() || !value->is_number()) return Fault{Kind::wrong_type, "value", "must be a number"};
    return set(*of, value->get<double>());
  }
  if (*what == "hold" || *what == "move") {
    if (grip_ && grip_->viewer != viewer) return Fault{Kind::unsupported, "hold", "has to wait: somebody else holds a cuboid"};
    const auto to = vector(message, "to", 1e4);
    if (!to) return to.fault();
    if (*what == "move") {
      if (grip_) world_.hold(grip_->body, grip_->at_B, *to);
      return true;
    }
    const auto body = message.find("body");
    const std::size_t bodies = world_.scene().bodies.size();
    if (body == message.end() || !body->is_number_unsigned() || body->get<std::size_t>() >= bodies)
      return Fault{Kind::out_of_range, "body", "must be a cuboid's index, 0 to " + std::to_string(bodies) + " exclusive"};
    const std::size_t held = body->get<std::size_t>();
    const auto at = vector(message, "at", norm<double>(world_.scene().bodies[held].shape.size()));
    if (!at) return at.fault();
    grip_ = Grip{viewer, held, *at};
    world_.hold(held, *at, *to);
    return true;
  }
  if (*what == "release") {
    left(viewer);
    return true;
  }
  return Fault{Kind::unknown_key, "do", "must be toggle, new, method, set, hold, move or release"};
}
void LiveScene::left(int viewer) {
  if (!grip_ || grip_->viewer != viewer) return;
  world_.release();
  grip_.reset();
}

Outcome<bool> LiveScene::toggle(const std::string& what) {
  using Do = SceneAction::Do;
  if (what == "running") running_ = !running_ && finite_, owed_ = 0, asked_ = done_ = 0;
  else if (what == "vacuum") world_.press(world_.vacuum() ? Do::vacuum_off : Do::vacuum_on);
  else if (what == "gravity") world_.press(world_.gravity() ? Do::gravity_off : Do::gravity_on);
  else return Fault{Kind::unknown_key, "what", "must be running, vacuum or gravity"};
  return true;
}
Outcome<bool> LiveScene::set(const std::string& what, double value) {
  const Surface<double>& now = world_.scene().surface;
  double e = now.restitution(), mu_s = now.static_friction(), mu_d = now.dynamic_friction();
  if (what == "dt") {
    if (!(value >= shortest_dt && value <= longest_dt)) return Fault{Kind::out_of_range, "dt", "must be from 0.0001 s to 1/30 s"};
    base_ = t(), steps_ = 0, dt_ = value;
    return true;
  }
  if (what == "restitution") e = value;
  else if (what == "static_friction") mu_s = value;
  else if (what == "dynamic_friction") mu_d = value;
  else return Fault{Kind::unknown_key, "what", "must be dt, restitution, static_friction or dynamic_friction"};
  const auto surface = Surface<double>::make(e, mu_s, mu_d);
  if (!surface) return surface.fault();
  Scene checked = world_.scene();
  checked.surface = *surface;
  if (const auto ok = check_scene(checked); !ok) return ok.fault();
  world_.set_surface(*surface);
  return true;
}
// What was set stays set; switches are as at the start of every scene.
void LiveScene::new_seed() {
  Scene next = reseed_(world_.scene().seed + 1);
  next.method = world_.scene().method, next.surface = world_.scene().surface;
  world_ = begin(next);
  grip_.reset();
  base_ = owed_ = 0, steps_ = 0, finite_ = true, ++scenes_;
}

std::string LiveScene::description() const {
  const Scene& scene = world_.scene();
  Json json{{"kind", "scene"}, {"seed", scene.seed}, {"bodies", Json::array()}, {"planes", Json::array()}, {"methods", Json::array()}};
  for (const SceneBody& b : scene.bodies) json["bodies"].push_back({{"size", list(b.shape.size())}, {"mass", b.shape.mass()}, {"position", list(b.start.p_WB)}});
  for (const Plane<double>& p : scene.planes) json["planes"].push_back({{"point", list(p.point())}, {"normal", list(p.normal())}});
  for (const Method& m : methods()) json["methods"].push_back(m.name);
  json["dt"] = {{"from", shortest_dt}, {"to", longest_dt}};
  return dumped(json);
}

std::string LiveScene::status() const {
  const Scene& scene = world_.scene();
  const Ledger& l = world_.ledger();
  Json json{{"kind", "status"}, {"t", t()}, {"running", running_}, {"vacuum", world_.vacuum()}, {"gravity", world_.gravity()}, {"finite", finite_},
            {"seed", scene.seed}, {"method", scene.method}, {"dt", dt_}, {"pace", asked_ > 0 ? done_ / asked_ : 1.0}};
  json["surface"] = {{"restitution", scene.surface.restitution()}, {"static_friction", scene.surface.static_friction()},
                     {"dynamic_friction", scene.surface.dynamic_friction()}};
  json["energy"] = {{"start", l.energy.start}, {"now", l.energy.end}, {"work", l.energy.work}, {"restitution_loss", l.energy.restitution_loss},
                    {"friction_loss", l.energy.friction_loss}, {"correction", l.energy.correction}, {"switched", l.energy.switched},
                    {"stepper", l.energy.stepper}, {"worst_drift", l.energy.worst_drift}};
  json["momentum"] = {{"linear", norm<double>(l.linear.end)}, {"linear_drift", l.linear.worst_drift}, {"angular_stepper", norm<double>(l.angular.stepper)},
                      {"angular", norm<double>(l.angular.end)}, {"angular_drift", l.angular.worst_drift}};
  json["impacts"] = {{"planes", l.plane_impacts}, {"pairs", l.pair_impacts}, {"energy_rises", l.energy_rises}};
  json["skips"] = {{"pairs", l.skips.pairs}, {"pairs_of", l.skips.pairs_of}, {"planes", l.skips.planes}, {"planes_of", l.skips.planes_of}};
  json["deepest_penetration"] = l.deepest_penetration;
  json["held"] = grip_ ? Json(grip_->body) : Json();
  return dumped(json);
}

std::string LiveScene::frame() {
  std::string bytes;
  const auto states = world_.states();
  put(bytes, t());
  put(bytes, double(impacts_->size()));
  for (const State<double>& s : states) put(bytes, s.p_WB, 3);
  for (const State<double>& s : states) put(bytes, finite_ ? pose_quaternion(s.R_WB) : Vec4<double>(1, 0, 0, 0), 4);
  for (const Impact& impact : *impacts_) put(bytes, impact.p_WC, 3), put(bytes, impact.j_W, 3);
  impacts_->clear();
  return bytes;
}

}  // namespace rigor::live
