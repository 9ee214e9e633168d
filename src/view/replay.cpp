#include <rigor/view/page.hpp>
#include <rigor/view/replay.hpp>

namespace rigor::view {

Outcome<std::string> replay_page(const std::vector<Recording>& runs, const std::string& title, const std::string& lead) {
  nlohmann::ordered_json data{{"schema", "rigor.replay/1"}, {"title", title}, {"runs", nlohmann::ordered_json::array()}};
  for (const Recording& run : runs) data["runs"].push_back(run.packed());
  return render({"replay", title, lead, "", std::move(data)});
}

}  // namespace rigor::view
