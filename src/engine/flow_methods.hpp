#pragma once
#include <rigor/integrators/method.hpp>

namespace rigor {

/// Methods whose free turn is the closed form, set up anew each step: on a free body there is no error but rounding, at
/// any step (`order` 0 says so). Under a load it is the flow between kicks: "exact" by Strang, order 2; "exact-kicks4" by
/// Blanes and Moan's six stages, order 4.
const std::vector<Method>& flow_methods();

}  // namespace rigor
