// A thousand bodies fall for one second, stepped together; states are read as views, without a copy.
#include <cstdio>
#include <rigor/engine/batch.hpp>

int main() {
  const auto box = rigor::Cuboid<double>::make(2.5, {0.7, 1.1, 1.9});
  rigor::State<double> start;
  start.w_WB = {0.3, 2, -0.2};
  const std::vector<rigor::Motion> motions(1000, rigor::motion_of(*box, start));
  auto made = rigor::Batch::make(std::vector<rigor::Cuboid<double>>(1000, *box), motions);
  if (!made) return std::fprintf(stderr, "%s\n", made.fault().text().c_str()), 1;
  rigor::Batch batch = std::move(made).value();
  for (std::size_t i = 0; i < batch.size(); ++i) batch.set_load(i, {{0, -9.8 * box->mass(), 0}, {0, 0, 0}});
  batch.step(1.0 / 256, 256, 2);  // 256 steps on two threads: the bits of one
  // symplectic Euler's parabola: -g t^2/2 - g t h/2
  std::printf("height %.6f m, velocity %.6f m/s\n", batch.p_WB(999)[1], batch.v_WB(999)[1]);
}
