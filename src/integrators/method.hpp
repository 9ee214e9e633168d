#pragma once
#include <functional>
#include <rigor/bodies/cuboid.hpp>
#include <rigor/formulas/state.hpp>
#include <string_view>
#include <vector>

namespace rigor {

/// Force and torque about the centre of mass, world axes.
struct Load {
  Vec3<double> f_W = zero3<double>();
  Vec3<double> tau_W = zero3<double>();
};

/// The load at a time, on a body in a state.
using LoadAt = std::function<Load(double t, const State<double>&)>;

/// State of a body as a method keeps it. `L_W`, the spin angular momentum, is carried along: the momentum forms
/// treat it as the state and ω as derived; the others keep it up to date from ω.
struct Motion {
  State<double> state;
  Vec3<double> L_W = zero3<double>();
};

/// Whether every number of a state is one.
inline bool is_finite(const State<double>& s) { return s.p_WB.allFinite() && s.R_WB.allFinite() && s.v_WB.allFinite() && s.w_WB.allFinite(); }

/// The motion of a body with this state: L = I ω at its attitude.
Motion motion_of(const Cuboid<double>& body, const State<double>& state);

/// A fixed-step method: pure, no memory but what Motion carries.
struct Method {
  std::string_view name;
  int order;                    ///< on a free body
  int forced_order;             ///< under a smooth load, through `advance`
  std::string_view conserves;   ///< without load, to rounding; "" when nothing
  int evaluations;              ///< of Euler's equation (or rotations) in one step
  std::string_view source;
  /// One step with the load held.
  Motion (*step)(const Cuboid<double>& body, const Motion& now, const Load& load, double h);
  /// One step from t that asks for the load at its own stages; nullptr for a method that holds it.
  Motion (*step_under)(const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h) = nullptr;
  /// Many steps without load: the same map, with nothing made twice and nothing derived in between; nullptr for step after step.
  Motion (*fly)(const Cuboid<double>& body, const Motion& now, double h, long steps) = nullptr;
};

/// One step from t under a load that changes: at the method's stages, or held as it is at the middle of the step, for the
/// state at its beginning.
Motion advance(const Method& method, const Cuboid<double>& body, const Motion& now, const LoadAt& load, double t, double h);

/// Every method, by file: to add one, write step_NAME in a file of its own and a row in methods.cpp. Those that need the
/// exact flow are in <rigor/engine/flow_methods.hpp>.
const std::vector<Method>& methods();
/// nullptr when there is none of that name.
const Method* find_method(std::string_view name);

}  // namespace rigor
