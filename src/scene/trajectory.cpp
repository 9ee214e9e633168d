#include <Eigen/SVD>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <rigor/scene/trajectory.hpp>

namespace rigor {
namespace {

void append(std::string& out, double x) {
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, x);
  out.append(text, end.ptr);
}

nlohmann::ordered_json vector(const Vec3<double>& v) { return {v[0], v[1], v[2]}; }
nlohmann::ordered_json momentum(const Ledger::Momentum& m) {
  return {{"start", vector(m.start)}, {"end", vector(m.end)}, {"external", vector(m.external)}, {"stepper", vector(m.stepper)}, {"worst_stepper", m.worst_stepper}, {"worst_drift", m.worst_drift}};
}

}  // namespace

Vec4<double> pose_quaternion(const Mat3<double>& R) {
  if (!(orthonormality_defect<double>(R) > 1e-12)) return quaternion_of<double>(R);
  const Eigen::JacobiSVD<Mat3<double>> svd(R, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return quaternion_of<double>(svd.matrixU() * svd.matrixV().transpose());
}

void TrajectoryCsv::add(double t, const std::vector<State<double>>& states) {
  for (std::size_t i = 0; i < states.size(); ++i) {
    const State<double>& s = states[i];
    append(text_, t);
    text_ += "," + std::to_string(i);
    const auto add_all = [&](const auto& v) {
      for (int k = 0; k < v.size(); ++k) text_ += ",", append(text_, v[k]);
    };
    add_all(s.p_WB), add_all(pose_quaternion(s.R_WB)), add_all(s.v_WB), add_all(s.w_WB);
    text_ += "\n";
  }
}

// What is not finite is written as null.
std::string summary_json(const Scene& scene, const RunSummary& run, double wall_s) {
  const Ledger& l = run.ledger;
  const Ledger::Energy& e = l.energy;
  nlohmann::ordered_json handed_over = nlohmann::ordered_json::array(), accumulations = handed_over, may_have_missed = handed_over;
  for (const HandOver& h : run.handed_over) handed_over.push_back({{"body", h.body}, {"times", h.times}, {"from", h.from}, {"to", h.to}, {"why", h.why}});
  for (const Accumulation& a : run.accumulations) accumulations.push_back({{"body", a.body}, {"at", a.at}, {"tail", a.tail}});
  for (const MayHaveMissed& m : run.may_have_missed) may_have_missed.push_back({{"bodies", {m.A, m.B}}, {"times", m.times}, {"from", m.from}, {"to", m.to}});
  nlohmann::ordered_json json{
      {"schema", "rigor.summary/1"},
      {"scene", scene.name},
      {"seed", scene.seed},
      {"method", scene.method},
      {"friction_law", name(scene.friction_law)},
      {"pair_detection", scene.pair_detection == PairDetection::axes ? "15-axes" : "handed-out"},
      {"corner_rule", "one after another, index order"},
      {"dt", scene.dt},
      {"until", scene.until},
      {"t_end", run.t_end},
      {"steps", run.steps},
      {"finite", run.finite},
      {"interrupted", run.interrupted},
      {"energy",
       {{"start", e.start}, {"end", e.end}, {"work", e.work}, {"restitution_loss", e.restitution_loss},
        {"friction_loss", e.friction_loss}, {"correction", e.correction}, {"switched", e.switched}, {"stepper", e.stepper},
        {"worst_stepper", e.worst_stepper}, {"worst_drift", e.worst_drift}}},
      {"linear_momentum", momentum(l.linear)},
      {"angular_momentum", momentum(l.angular)},
      {"impacts", {{"total", l.impacts}, {"planes", l.plane_impacts}, {"pairs", l.pair_impacts}, {"energy_rises", l.energy_rises}}},
      {"deepest_penetration", l.deepest_penetration},
      {"orthonormality_defect", l.worst_orthonormality},
      {"skips", {{"pairs", l.skips.pairs}, {"pairs_of", l.skips.pairs_of}, {"planes", l.skips.planes}, {"planes_of", l.skips.planes_of},
                 {"loads", l.skips.loads}, {"loads_of", l.skips.loads_of}, {"rest", l.skips.rest}, {"rest_of", l.skips.rest_of}, {"monitors", l.skips.monitors}, {"monitors_of", l.skips.monitors_of}}},
      {"handed_over", handed_over},
      {"accumulations", accumulations},
      {"may_have_missed", may_have_missed},
      {"stopped", run.stopped},
      {"wall_s", wall_s}};
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace rigor
