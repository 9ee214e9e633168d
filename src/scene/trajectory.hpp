#pragma once
#include <rigor/linalg/rotation.hpp>
#include <rigor/scene/simulate.hpp>
#include <string>
#include <vector>

namespace rigor {

/// The quaternion (w ≥ 0) of R, or of the rotation nearest to it where R is none (a defect above 1e-12).
Vec4<double> pose_quaternion(const Mat3<double>& R);

/// Collects `trajectory.csv`: t,body,px,py,pz,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz, a row per body and output time, shortest
/// digits that read back to the same double. The quaternion has w ≥ 0, whatever rows are asked for; where R is no rotation
/// it is that of the nearest one.
class TrajectoryCsv {
 public:
  void add(double t, const std::vector<State<double>>& states);
  const std::string& text() const { return text_; }

 private:
  std::string text_ = "t,body,px,py,pz,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz\n";
};

/// `summary.json`: ledgers, contacts, steps, wall time (docs/scenes.md). Numbers that are not finite are strings.
std::string summary_json(const Scene& scene, const RunSummary& summary, double wall_s);

}  // namespace rigor
