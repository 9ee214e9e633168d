#include <algorithm>
#include <cmath>
#include <rigor/grader/report_parts.hpp>
#include <rigor/report/html.hpp>
#include <rigor/report/plot.hpp>

namespace rigor::grader {
namespace {

// Order from the finest pair, in words; rounding has none.
std::string order(const std::vector<double>& error) {
  const double coarse = error[error.size() - 2], fine = error.back();
  if (fine <= 1e-12) return "exact";
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", std::log2(coarse / fine));
  return std::isfinite(coarse / fine) ? text : "none";
}

}  // namespace

std::string ladder_figures(const Ladder& ladder) {
  const char* parts[] = {"position", "velocity", "spin", "rotation"};
  rigor::report::Plot plot{"Error of update against the step", "step h, s", "error after 1 s, of its scale", true, true, {}};
  std::vector<std::vector<std::string>> orders;
  for (std::size_t part = 0; part < 4; ++part) {
    orders.push_back({parts[part], order(ladder.errors[part]), order(ladder.reference[part])});
    const int colour = int(plot.series.size());
    if (orders.back()[1] != "exact") plot.series.push_back({std::string(parts[part]), ladder.steps, ladder.errors[part]});
    if (orders.back()[2] != "exact") plot.series.push_back({std::string(parts[part]) + ", reference", ladder.steps, ladder.reference[part], false, true, colour});
  }
  std::string html = rigor::report::table({"part", "order of the submission", "order of the reference"}, orders, {1, 2}, "Slope of the error, from the last halving of the step");
  if (!plot.series.empty())
    html += rigor::report::figure(plot, "A cube under a constant force and torque, 1 s in 50, 100, 200 and 400 steps. Dashed: the assignment's scheme, written right. A slope of 1 "
                                        "(the error halves with the step) is what the sheet's scheme gives; a flat line does not converge to the motion.");
  return html;
}

std::string scene_figures(const SceneTrace& trace) {
  char text[128];
  std::snprintf(text, sizeof text, "<p><strong>The scene blew up at t = %.3g s</strong>: from there on a number is not finite.</p>", trace.blew_up_at);
  const std::string blew_up = trace.blew_up_at > 0 ? text : "";
  if (trace.time.size() < 2) return blew_up;
  const double most = *std::max_element(trace.energy.begin(), trace.energy.end());
  const bool runs_away = !(most < 100 * std::fabs(trace.energy.front()));  // then only a logarithm shows when it began
  rigor::report::Plot energy{"Energy in the submission's own scene", "time, s", "kinetic and potential energy, J", false, runs_away, {{"energy", trace.time, trace.energy, false}}};
  rigor::report::Plot momentum{"Momenta in the submission's own scene", "time, s", "|P|, N s; |L| about the origin, kg m²/s", false, runs_away,
                              {{"linear momentum |P|", trace.time, trace.momentum, false}, {"angular momentum |L|", trace.time, trace.angular_momentum, false}}};
  return blew_up + "<p>Ten cuboids in the room of the assignment, 20 s, by the submission's own ParticleSystem. Not judged: collisions with e &lt; 1 and friction take energy away, and "
         "walls change both momenta; what grows without end, or never settles, is worth a look.</p>" +
         rigor::report::figure(energy) + rigor::report::figure(momentum);
}

}  // namespace rigor::grader
