#pragma once
#include <string>
#include <vector>

namespace rigor {

/// The steppers, by name (integrators/method.hpp).
std::vector<std::string> method_names();
/// What a scene's `method` may be: a stepper, or "located".
std::vector<std::string> scene_methods();

}  // namespace rigor
