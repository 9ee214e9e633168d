#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <rigor/scene/world.hpp>
#include <string>

namespace rigor::live {

/// The scene that everybody who looks shares: it runs by the clock and does what is pressed, as the assignment's program
/// does. Knows nothing of sockets; messages are JSON texts (docs/live.md).
class LiveScene {
 public:
  /// The scene of another seed: what `n` asks for.
  using Reseed = std::function<Scene(std::uint64_t seed)>;
  /// Faults: unsupported for method "located", which has no step.
  static Outcome<LiveScene> make(const Scene& scene, Reseed reseed);

  /// Lets `seconds` pass, in whole steps of dt; a remainder is owed. Gives up after `budget_s` of work, forgetting what
  /// is then owed: a scene too large for the machine runs slower than the clock.
  void advance(double seconds, double budget_s);

  /// Does what a message of a viewer says. Faults name the field; nothing is done then.
  Outcome<bool> obey(const std::string& message, int viewer);
  /// A viewer went: what it held is let go.
  void left(int viewer);

  bool running() const { return running_; }
  double t() const { return base_ + double(steps_) * dt_; }
  const World& world() const { return world_; }

  /// Bodies and planes, methods, the range of dt. Changes with the seed: see `scenes`.
  std::string description() const;
  /// Switches, settings and accounts.
  std::string status() const;
  /// Poses, and the impulses since the last call. Little-endian: float64 t, float64 number n of impulses, then float32:
  /// position (3) of each body, quaternion (w x y z) of each body, point and impulse (6) of each of the n.
  std::string frame();
  /// How many scenes have begun here: 1, and one more for each new seed.
  int scenes() const { return scenes_; }

 private:
  LiveScene(const Scene& scene, Reseed reseed);
  World begin(const Scene& scene);
  Outcome<bool> toggle(const std::string& what);
  Outcome<bool> set(const std::string& what, double value);
  void new_seed();

  Reseed reseed_;
  std::shared_ptr<std::vector<Impact>> impacts_ = std::make_shared<std::vector<Impact>>();  // the world's observer writes here
  World world_;
  bool running_ = false, finite_ = true;
  double dt_, base_ = 0, owed_ = 0;  // s
  long steps_ = 0;              // since base_: time is not summed step by step
  double asked_ = 0, done_ = 0;  // s, of the clock and of the scene, fading: how far it keeps up
  struct Grip {
    int viewer;
    std::size_t body;
    Vec3<double> at_B;
  };
  std::optional<Grip> grip_;
  int scenes_ = 1;
};

}  // namespace rigor::live
