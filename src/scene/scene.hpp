#pragma once
#include <cstdint>
#include <filesystem>
#include <rigor/bodies/cuboid.hpp>
#include <rigor/bodies/plane.hpp>
#include <rigor/contact/surface.hpp>
#include <rigor/formulas/state.hpp>
#include <string>
#include <vector>

namespace rigor {

/// A cuboid of a scene and how it starts.
struct SceneBody {
  Cuboid<double> shape;
  State<double> start;
};

/// A constant force on one body for a time.
struct SceneForce {
  int body;
  Vec3<double> force;              ///< N, world axes
  Vec3<double> at = zero3<double>();  ///< m, from the centre of mass
  bool at_turns = false;           ///< `at` in body axes (turns with the body) instead of world axes
  double from = 0, to = 0;         ///< s; acts in [from, to)
};

/// What a key press of the assignment's program does, at a time.
struct SceneAction {
  enum class Do { vacuum_on, vacuum_off, gravity_on, gravity_off };
  double at;  ///< s
  Do what;
};

enum class PairDetection { axes, handed_out };

/// A scene file as a value. SI units, world axes, spin in rad/s.
struct Scene {
  std::string name;
  std::vector<SceneBody> bodies;
  std::vector<Plane<double>> planes;
  Vec3<double> gravity{0, -9.8, 0};
  Surface<double> surface;
  FrictionLaw friction_law = FrictionLaw::sheet;
  PairDetection pair_detection = PairDetection::axes;
  std::vector<SceneForce> forces;
  std::vector<SceneAction> actions;   ///< in order of time
  std::string method = "sheet";
  double dt = 1.0 / 240, until = 20, every = 0;  ///< every 0: as output_interval says
  std::uint64_t seed = 1;             ///< of the vacuum's offsets
};

/// Reads a scene file (docs/schema/scene.schema.json). Faults name file, field, value and allowed range; unknown
/// keys come with a suggestion; nothing is repaired.
Outcome<Scene> parse_scene(const std::string& text, const std::string& name);
/// A file, or a built-in by name ("assignment"); `seed` replaces the scene's where it is not 0.
Outcome<Scene> open_scene(const std::string& path_or_name, std::uint64_t seed = 0);

/// The built-in scenes: assignment, drop, tumble, slide, spin-box.
std::vector<std::string> builtin_scenes();
Scene builtin_scene(const std::string& name, std::uint64_t seed);

/// Checks what parsing cannot see in one field (dt against until, actions in order, friction law against its
/// coefficients); also what the command line changed.
Outcome<bool> check_scene(const Scene& scene);

/// Time between outputs, s: `every`; where that is 0 each step, or with method "located", which has no steps, 1/60 s or a
/// ten-thousandth of `until`, whichever is longer.
double output_interval(const Scene& scene);
/// Fault where a run would give more than 2e7 rows, one for each body and output time. check_scene asks where `every` is
/// given; where it is 0, who keeps the rows has to.
Outcome<bool> check_rows(const Scene& scene);

}  // namespace rigor
