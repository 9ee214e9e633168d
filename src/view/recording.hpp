#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <rigor/scene/simulate.hpp>
#include <string>
#include <utility>
#include <vector>

namespace rigor::view {

/// A run as the replay page shows it: poses, velocities, impulses, energy and momentum at moments at least 1/60 s
/// apart. What it keeps is bounded: every second moment is dropped, and the spacing doubled, above 20 000 states at
/// more than 30 moments a second and above a million states at all. The numbers to calculate with are in
/// trajectory.csv.
class Recording {
 public:
  /// `name` tells runs of one page apart.
  Recording(const Scene& scene, std::string name);

  void impact(const Impact& impact);
  /// An impact of which only its effect is known: shown on its line of action, where it passes nearest to the centre.
  void impact(std::size_t body, const State<double>& before, const State<double>& after);
  void add(double t, const std::vector<State<double>>& states);

  const std::string& name() const { return name_; }
  std::size_t frames() const { return frames_.size(); }
  /// Kinetic and potential energy, J, of each moment kept, s.
  std::pair<std::vector<double>, std::vector<double>> energy() const;
  /// Packed: positions as float32, quaternions in 1/32767, velocities and impulses in 1/32767 of the largest component.
  nlohmann::ordered_json packed() const;

 private:
  struct Touch {  ///< impulses of one pair in the time up to a frame: their sum, at their weighted mean
    int A, B;
    Vec3<double> weighted, j_W;
    double weight;
  };
  struct Frame {
    double t;
    std::vector<float> p, q, v, w;   ///< 3, 4 (w x y z), 3, 3 for each body
    std::vector<Touch> touches;
    double kinetic, potential, linear, angular;  ///< J, J, |N s|, |kg m^2/s| about the origin
  };
  static void join(std::vector<Touch>& into, const Touch& touch);
  void thin();

  Scene scene_;
  std::string name_;
  double spacing_ = 1.0 / 60;
  std::vector<Frame> frames_;
  std::vector<Touch> touches_;  ///< since the last frame
};

}  // namespace rigor::view
