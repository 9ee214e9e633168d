#pragma once
#include <rigor/base/outcome.hpp>
#include <rigor/view/recording.hpp>

namespace rigor::view {

/// replay.html: one file, no network, its one script allowed by its hash. Runs are of one scene and shown over each
/// other or side by side. Names are escaped, the data lies inert in the page.
///
/// Faults: unsupported, saying why, when the program was built without the web bundle.
Outcome<std::string> replay_page(const std::vector<Recording>& runs, const std::string& title, const std::string& lead);

}  // namespace rigor::view
