#include <fmt/format.h>

#include <rigor/report/html.hpp>
#include <rigor/report/plot.hpp>
#include <rigor/view/page.hpp>
#include <rigor/view/replay.hpp>

namespace rigor::view {
namespace {

// What can be shown without a script: the energy over time, a thousand points a run at most.
std::string still(const std::vector<Recording>& runs) {
  report::Plot plot{"Kinetic and potential energy", "time, s", "energy, J", false, false, {}};
  std::vector<std::vector<std::string>> rows;
  for (const Recording& run : runs) {
    const auto [t, energy] = run.energy();
    report::Series curve{run.name(), {}, {}, false};
    for (std::size_t k = 0, every = t.size() / 1000 + 1; k < t.size(); k += every) curve.x.push_back(t[k]), curve.y.push_back(energy[k]);
    plot.series.push_back(curve);
    if (!t.empty()) rows.push_back({run.name(), fmt::format("{:.6g}", t.back()), fmt::format("{:.6g}", energy.front()), fmt::format("{:.6g}", energy.back())});
  }
  return "<p>The scene in three dimensions is drawn by this page's script, which does not run here. The numbers of the run are in summary.json and trajectory.csv beside it; this is its energy.</p>" +
         report::table({"run", "end, s", "energy at the start, J", "energy at the end, J"}, rows, {1, 2, 3}, "Kinetic and potential energy by run") + report::svg_file(plot);
}

}  // namespace

Outcome<std::string> replay_page(const std::vector<Recording>& runs, const std::string& title, const std::string& lead) {
  nlohmann::ordered_json data{{"schema", "rigor.replay/1"}, {"title", title}, {"runs", nlohmann::ordered_json::array()}};
  for (const Recording& run : runs) data["runs"].push_back(run.packed());
  return render({"replay", title, lead, "", std::move(data), still(runs)});
}

}  // namespace rigor::view
