// A tumbling body in closed form, a million seconds away: energy and angular momentum are what they were.
#include <cstdio>
#include <rigor/bodies/cuboid.hpp>
#include <rigor/engine/exact_flight.hpp>

int main() {
  const auto box = rigor::Cuboid<double>::make(2.5, {0.7, 1.1, 1.9});  // kg, m
  const auto flight = rigor::ExactFlight::make(box->inertia(), {0.3, 2, -0.2}, rigor::identity3<double>());
  if (!flight) return std::fprintf(stderr, "%s\n", flight.fault().text().c_str()), 1;
  for (const double t : {0.0, 1.0, 1e6}) {
    const rigor::Attitude a = flight->at(t);
    const rigor::Vec3<double> L_W = a.R_WB * a.L_B;
    std::printf("t = %-7g  L_W = (%.12f, %.12f, %.12f) kg m^2/s,  T = %.12f J\n", t, L_W[0], L_W[1], L_W[2],
                0.5 * a.L_B.dot(a.L_B.cwiseQuotient(box->inertia())));
  }
}
