#pragma once
#include <rigor/grader/report.hpp>

namespace rigor::grader {

// Parts of report.html.

/// Error of `update` against the step beside the reference: a table of slopes and a plot.
std::string ladder_figures(const Ladder& ladder);
/// Energy and momenta over the scene.
std::string scene_figures(const SceneTrace& trace);

}  // namespace rigor::grader
