// A cuboid falls flat from 1 m with restitution 1/2: every impact at its time, told to a callback as it happens.
#include <cstdio>
#include <rigor/engine/located.hpp>

int main() {
  rigor::Scene scene;
  scene.planes.push_back(*rigor::Plane<double>::make({0, 0, 0}, {0, 1, 0}));
  scene.surface = *rigor::Surface<double>::make(0.5, 0, 0);
  rigor::State<double> start;
  start.p_WB = {0, 1.25, 0};  // the lower face is 1 m above the plane
  scene.bodies.push_back({*rigor::Cuboid<double>::make(2.5, {0.7, 0.5, 1.9}), start});
  scene.method = "located";
  scene.until = 1;
  scene.every = scene.until;
  const auto nothing = [](double, const std::vector<rigor::State<double>>&) {};
  const auto told = [](const rigor::LocatedImpact& impact) {
    std::printf("t = %.12f s: %.6f m/s, then %.6f m/s\n", impact.t, impact.before.v_WB[1], impact.after.v_WB[1]);
  };
  const auto run = rigor::simulate_located(scene, nothing, told);
  if (!run) return std::fprintf(stderr, "%s\n", run.fault().text().c_str()), 1;
  std::printf("energy %.6f J at the start, %.6f J at t = 1 s\n", run->ledger.energy.start, run->ledger.energy.end);
}
