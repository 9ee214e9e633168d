#pragma once
#include <functional>
#include <optional>
#include <random>
#include <rigor/collision/near_pairs.hpp>
#include <rigor/contact/impact.hpp>
#include <rigor/formulas/force_sum.hpp>
#include <rigor/integrators/method.hpp>
#include <rigor/scene/plan.hpp>
#include <rigor/scene/scene.hpp>
#include <vector>

namespace rigor {

/// An impulse as it was given: at a corner for a plane, at the contact point for a pair.
struct Impact {
  int A, B;               ///< bodies; A is -1 for a plane
  Vec3<double> p_WC, j_W; ///< m; N s, acting on B
};
using ImpactObserver = std::function<void(const Impact&)>;

/// The assignment's program between two key presses: a scene on its way, one step at a time. `simulate` runs it to the
/// end, the live scene for as long as somebody looks.
class World {
 public:
  /// Precondition: check_scene(scene) holds.
  explicit World(Scene scene, ImpactObserver on_impact = {});

  /// Forces; every cuboid against every plane; every pair i < j; then every cuboid advances by h seconds from t.
  void step(double t, double h);

  /// The states of all, in scene order; kept until the next call.
  const std::vector<State<double>>& states() const;
  bool finite() const;
  const Ledger& ledger() const { return ledger_; }
  const Scene& scene() const { return scene_; }
  bool gravity() const { return gravity_on_; }
  bool vacuum() const { return vacuum_on_; }

  /// What is left out from now on (plan.hpp); the states have the same bits with and without.
  void set_skips(const Skips& skips) { skips_ = skips; }
  /// The accounts up to now, where `monitors` left them out: sums over steps are NaN.
  void make_up_accounts() { audit(); }

  /// A key press, now.
  void press(SceneAction::Do what);
  void set_surface(const Surface<double>& surface) { scene_.surface = surface; }
  /// Precondition: find_method(name). Motion goes on from the state reached.
  void set_method(const std::string& name);
  /// A hand: a damped spring from a point of a body (body axes, m) to a place (world axes, m), until released. Its
  /// stiffness is 30 N/m for each kg, its damping critical for the whole mass; its work counts as a force's.
  void hold(std::size_t body, const Vec3<double>& at_B, const Vec3<double>& to_W) { hand_ = Hand{body, at_B, to_W}, steady_ = false; }
  void release() { hand_.reset(), steady_ = false; }

 private:
  struct Hand {
    std::size_t body;
    Vec3<double> at_B, to_W;
  };
  const Cuboid<double>& shape(std::size_t i) const { return scene_.bodies[i].shape; }
  void act(double t);
  void start_vacuum();
  void sum_forces(double t);
  void add_load(std::size_t i, const Vec3<double>& arm, const Vec3<double>& force);
  void note(int A, std::size_t B, const Vec3<double>& p_WC, const ImpactReport<double>& report);
  void move(std::size_t i, const Vec3<double>& shift);
  void keep_state_alone(std::size_t i);
  void against_plane(std::size_t i, const Plane<double>& plane);
  void pairs();
  double strayed() const;
  void against_each_other(std::size_t i, std::size_t j);
  void advance(std::size_t i, double h);
  void account(std::size_t i, const Motion& moving, double h);
  double kinetic(std::size_t i, const Motion& m) const;
  double potential() const;
  double energy() const;
  Vec3<double> linear() const;
  Vec3<double> angular(std::size_t i, const Motion& m) const;  ///< about the world's origin
  Vec3<double> angular() const;
  void audit();
  void forget_steps();

  Scene scene_;
  ImpactObserver on_impact_;
  const Method* method_;
  std::mt19937_64 random_;
  std::vector<Motion> motions_;
  std::vector<Load> loads_;
  std::vector<Wrench<double>> vacuum_;
  std::optional<Hand> hand_;
  Vec3<double> gravity_;
  bool gravity_on_ = true, vacuum_on_ = false;
  std::size_t next_action_ = 0;
  Skips skips_;
  std::vector<char> still_;  // at rest without load: its last step changed nothing, and nothing has since
  bool steady_ = false;  // loads_ hold gravity and vacuum as they are now, and nothing else
  std::vector<double> reach_;  // of each cuboid: half its diagonal and 0.01 m
  double margin_ = 0;            // m: near_ are those who come within it of touching
  NearPairs near_;
  std::vector<Vec3<double>> seen_at_;  // centres when near_ was found
  std::vector<double> shifted_;  // by position corrections since `pairs` began, m
  double worst_shift_ = 0;
  mutable std::vector<State<double>> shown_;
  Ledger ledger_;
};

}  // namespace rigor
