#include <cmath>
#include <rigor/base/promise.hpp>
#include <rigor/engine/flight.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;

V spin_of(const State<double>& start, std::optional<int> about) {
  const V w_B = apply_transposed<double>(start.R_WB, start.w_WB);
  return about ? V(w_B[*about] * V::Unit(*about)) : w_B;
}
ExactFlight attitude_of(const Cuboid<double>& shape, const V& w_B, const State<double>& start) {
  const auto made = ExactFlight::make(shape.inertia(), w_B, start.R_WB);
  promise(bool(made), "a flight starts from a finite state");
  return *made;
}

}  // namespace

Flight::Flight(const Cuboid<double>& shape, const State<double>& start, const V& a_W, std::optional<int> about)
    : shape_(&shape), start_(start), a_W_(a_W), w_B_(spin_of(start, about)), attitude_(attitude_of(shape, w_B_, start)) {
  spin_ = spin_bound(shape, w_B_);
  bound_ = spin_ * spin_ * (1 + 1 / std::sqrt(3.0));
}

double Flight::spin_bound(const Cuboid<double>& shape, const V& w_B) {
  double energy2 = 0;
  for (int i = 0; i < 3; ++i) energy2 += shape.inertia()[i] * w_B[i] * w_B[i];
  return std::sqrt(energy2 / shape.inertia().minCoeff() * (1 + 1e-12));
}

double Flight::rounding(double tau) const {
  double terms = norm<double>(shape_->size()) / 2 * (1 + spin_ * tau);
  for (int i = 0; i < 3; ++i) terms += std::fabs(start_.p_WB[i]) + tau * (std::fabs(start_.v_WB[i]) + tau * std::fabs(a_W_[i]) / 2);
  return 16 * 0x1p-53 * terms;
}

State<double> Flight::at(double tau) const {
  State<double> s = start_;
  for (int i = 0; i < 3; ++i) {
    s.p_WB[i] = start_.p_WB[i] + tau * (start_.v_WB[i] + tau * a_W_[i] / 2);
    s.v_WB[i] = start_.v_WB[i] + tau * a_W_[i];
  }
  if (spin_ == 0) return s;
  const Attitude attitude = attitude_.at(tau);
  s.R_WB = attitude.R_WB;
  s.w_WB = apply<double>(attitude.R_WB, V(attitude.L_B.cwiseProduct(shape_->inverse_inertia())));
  return s;
}

}  // namespace rigor
