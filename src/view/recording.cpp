#include <algorithm>
#include <cmath>
#include <cstring>
#include <rigor/formulas/momentum.hpp>
#include <rigor/integrators/method.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/scene/trajectory.hpp>
#include <rigor/view/recording.hpp>

namespace rigor::view {
namespace {

using Json = nlohmann::ordered_json;
using V = Vec3<double>;

std::string base64(const void* data, std::size_t size) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const unsigned char* bytes = static_cast<const unsigned char*>(data);
  std::string text;
  text.reserve((size + 2) / 3 * 4);
  for (std::size_t i = 0; i < size; i += 3) {
    const std::size_t left = size - i;
    const unsigned group = unsigned(bytes[i]) << 16 | (left > 1 ? unsigned(bytes[i + 1]) << 8 : 0) | (left > 2 ? unsigned(bytes[i + 2]) : 0);
    text += digits[group >> 18 & 63];
    text += digits[group >> 12 & 63];
    text += left > 1 ? digits[group >> 6 & 63] : '=';
    text += left > 2 ? digits[group & 63] : '=';
  }
  return text;
}
template <class T>
std::string base64(const std::vector<T>& values) {
  return base64(values.data(), values.size() * sizeof(T));  // little-endian, as every browser's typed arrays
}

// Values in 1/32767 of the largest, and that largest.
Json quantised(const std::vector<float>& values) {
  float largest = 0;
  for (const float x : values) largest = std::max(largest, std::fabs(x));
  std::vector<std::int16_t> steps;
  for (const float x : values) steps.push_back(largest > 0 ? std::int16_t(std::lround(x / largest * 32767)) : std::int16_t(0));
  return {{"largest", largest}, {"steps", base64(steps)}};
}

void append(std::vector<float>& to, const auto& values) {
  for (int k = 0; k < values.size(); ++k) to.push_back(float(values[k]));
}
Json vector(const V& v) { return {v[0], v[1], v[2]}; }

}  // namespace

Recording::Recording(const Scene& scene, std::string name) : scene_(scene), name_(std::move(name)) {}

void Recording::join(std::vector<Touch>& into, const Touch& touch) {
  const auto same = std::find_if(into.begin(), into.end(), [&](const Touch& other) { return other.A == touch.A && other.B == touch.B; });
  if (same == into.end()) return into.push_back(touch);
  same->weighted += touch.weighted;
  same->j_W += touch.j_W;
  same->weight += touch.weight;
}

void Recording::impact(const Impact& impact) {
  const double weight = norm<double>(impact.j_W);
  join(touches_, {impact.A, impact.B, V(weight * impact.p_WC), impact.j_W, weight});
}

void Recording::impact(std::size_t body, const State<double>& before, const State<double>& after) {
  const Cuboid<double>& shape = scene_.bodies[body].shape;
  const V j = shape.mass() * (after.v_WB - before.v_WB), turned = motion_of(shape, after).L_W - motion_of(shape, before).L_W;
  const double size = dot<double>(j, j);
  if (!(size > 0)) return;
  impact({-1, int(body), V(after.p_WB + cross<double>(j, turned) / size), j});  // r x j = turned
}

void Recording::add(double t, const std::vector<State<double>>& states) {
  if (!frames_.empty() && t < scene_.until && t < frames_.back().t + spacing_ - 1e-9) return;
  Frame frame{t, {}, {}, {}, {}, std::move(touches_), 0, 0, 0, 0};
  touches_.clear();
  V gravity = scene_.gravity, p = zero3<double>(), L = p;
  for (const SceneAction& action : scene_.actions)
    if (action.at < t && action.what == SceneAction::Do::gravity_off) gravity = zero3<double>();
    else if (action.at < t && action.what == SceneAction::Do::gravity_on) gravity = scene_.gravity;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const State<double>& s = states[i];
    if (!s.p_WB.allFinite() || !s.R_WB.allFinite() || !s.v_WB.allFinite() || !s.w_WB.allFinite()) return;  // nothing to show
    const double m = scene_.bodies[i].shape.mass();
    const V spin = motion_of(scene_.bodies[i].shape, s).L_W;
    append(frame.p, s.p_WB), append(frame.q, pose_quaternion(s.R_WB)), append(frame.v, s.v_WB), append(frame.w, s.w_WB);
    frame.kinetic += (m * dot<double>(s.v_WB, s.v_WB) + dot<double>(s.w_WB, spin)) / 2;
    frame.potential -= m * dot<double>(gravity, s.p_WB);
    p += linear_momentum<double>(m, s.v_WB);
    L += cross<double>(s.p_WB, V(m * s.v_WB)) + spin;
  }
  frame.linear = norm<double>(p), frame.angular = norm<double>(L);
  frames_.push_back(std::move(frame));
  const std::size_t kept = frames_.size() * states.size();
  if (kept > (spacing_ < 1.0 / 31 ? 20000u : 1000000u)) thin();
}

void Recording::thin() {
  spacing_ *= 2;
  std::vector<Frame> kept;
  for (Frame& frame : frames_) {
    if (kept.empty() || frame.t >= kept.back().t + spacing_ - 1e-9) {
      for (const Touch& touch : touches_) join(frame.touches, touch);
      touches_.clear();
      kept.push_back(std::move(frame));
    } else {
      for (const Touch& touch : frame.touches) join(touches_, touch);
    }
  }
  frames_ = std::move(kept);
}

std::pair<std::vector<double>, std::vector<double>> Recording::energy() const {
  std::pair<std::vector<double>, std::vector<double>> curve;
  for (const Frame& f : frames_) curve.first.push_back(f.t), curve.second.push_back(f.kinetic + f.potential);
  return curve;
}

Json Recording::packed() const {
  Json run{{"name", name_}, {"method", scene_.method}, {"dt", scene_.dt}, {"bodies", Json::array()}, {"planes", Json::array()}};
  for (const SceneBody& b : scene_.bodies) run["bodies"].push_back({{"size", vector(b.shape.size())}, {"mass", b.shape.mass()}});
  for (const Plane<double>& plane : scene_.planes) run["planes"].push_back({{"point", vector(plane.point())}, {"normal", vector(plane.normal())}});
  std::vector<double> t;
  std::vector<float> p, q, v, w, kinetic, potential, linear, angular, touch_p, touch_j;
  std::vector<std::uint32_t> touch_end;  // touches up to and with this frame
  std::vector<std::int16_t> sides;
  for (const Frame& f : frames_) {
    t.push_back(f.t);
    p.insert(p.end(), f.p.begin(), f.p.end()), q.insert(q.end(), f.q.begin(), f.q.end());
    v.insert(v.end(), f.v.begin(), f.v.end()), w.insert(w.end(), f.w.begin(), f.w.end());
    kinetic.push_back(float(f.kinetic)), potential.push_back(float(f.potential));
    linear.push_back(float(f.linear)), angular.push_back(float(f.angular));
    for (const Touch& touch : f.touches) {
      if (!(touch.weight > 0)) continue;
      sides.push_back(std::int16_t(touch.A)), sides.push_back(std::int16_t(touch.B));
      append(touch_p, V(touch.weighted / touch.weight)), append(touch_j, touch.j_W);
    }
    touch_end.push_back(std::uint32_t(sides.size() / 2));
  }
  std::vector<std::int16_t> turns;
  for (const float x : q) turns.push_back(std::int16_t(std::lround(x * 32767)));
  run["t"] = base64(t), run["p"] = base64(p), run["q"] = base64(turns), run["v"] = quantised(v), run["w"] = quantised(w);
  run["touches"] = {{"end", base64(touch_end)}, {"sides", base64(sides)}, {"p", quantised(touch_p)}, {"j", quantised(touch_j)}};
  run["energy"] = {{"kinetic", base64(kinetic)}, {"potential", base64(potential)}};
  run["momentum"] = {{"linear", base64(linear)}, {"angular", base64(angular)}};
  return run;
}

}  // namespace rigor::view
