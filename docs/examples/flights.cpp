// A thousand tumbling bodies in closed form, evaluated together: attitudes are Eigen maps, nothing is copied.
#include <cstdio>
#include <rigor/bodies/cuboid.hpp>
#include <rigor/engine/flight_batch.hpp>

int main() {
  const auto box = rigor::Cuboid<double>::make(2.5, {0.7, 1.1, 1.9});
  std::vector<rigor::ExactFlight> flights;
  for (int i = 0; i < 1000; ++i)
    flights.push_back(*rigor::ExactFlight::make(box->inertia(), {0.3, 2, -0.001 * i}, rigor::identity3<double>()));
  rigor::FlightBatch batch(flights);
  const auto R_WB = batch.R_WB(999);  // a view: it follows every evaluation
  const auto L_B = batch.L_B(999);
  for (const double t : {0.0, 60.0, 3600.0}) {
    batch.evaluate(t);
    const rigor::Vec3<double> L_W = R_WB * L_B;
    std::printf("t = %-5g L_W = (%.12f, %.12f, %.12f) kg m^2/s\n", t, L_W[0], L_W[1], L_W[2]);
  }
}
