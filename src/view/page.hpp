#pragma once
#include <nlohmann/json.hpp>
#include <rigor/base/outcome.hpp>
#include <string>

namespace rigor::view {

/// An interactive page of src/view/web, by name ("replay", "live"): its script is the one the page's policy lets run, by
/// its hash, and it may connect only to what `connect` lists (Content-Security-Policy sources; "" is nothing). Names are
/// escaped, the data lies inert in the page. `without_script` is HTML for a reader who lets no script run.
///
/// Faults: unsupported, saying why, when the program was built without the web bundle.
struct InteractivePage {
  std::string name, title, lead, connect;
  nlohmann::ordered_json data;
  std::string without_script{};
};
Outcome<std::string> render(const InteractivePage& page);

}  // namespace rigor::view
