#pragma once
// What every peer's program shares. Plain arrays and standard headers alone: the engines bring their own vector types.
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace rigor::peers {

/// A cuboid in flight: axes x y z, SI units, world axes; `q` (w, x, y, z) body to world.
struct Flight {
  double until, mass;
  std::array<double, 3> size;
  std::array<double, 4> q;
  std::array<double, 3> w, p, v, a;

  std::array<double, 3> inertia() const {
    const auto& [x, y, z] = size;
    return {mass / 12 * (y * y + z * z), mass / 12 * (z * z + x * x), mass / 12 * (x * x + y * y)};
  }
  /// w in body axes.
  std::array<double, 3> spin_B() const;
};

struct End {
  std::array<double, 9> R;  ///< by rows
  std::array<double, 3> p, v, w;
};
/// The attitude of a quaternion (w, x, y, z) of any length, by rows.
std::array<double, 9> rows_of(const std::array<double, 4>& q);

/// A world made and set, with its body at the start of the flight.
class World {
 public:
  virtual ~World() = default;
  /// To the end of the flight: so many equal steps, or the engine's own.
  virtual void run() = 0;
  virtual End end() const = 0;
  /// Of the engine's equations, or its steps.
  virtual long evaluations() const = 0;
};

struct Variant {
  std::string name;
  std::string settings;  ///< version and everything that was set
  bool adaptive;
  double ns;             ///< about what one step costs
  std::function<std::unique_ptr<World>(const Flight&, long steps, double tolerance)> make;
};
/// One adapter each: bullet.cpp, ode.cpp, mujoco.cpp, simbody.cpp, dart.cpp.
std::vector<Variant> variants();

}  // namespace rigor::peers
