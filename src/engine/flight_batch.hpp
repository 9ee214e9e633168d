#pragma once
#include <optional>
#include <rigor/engine/exact_flight.hpp>
#include <rigor/engine/flight_kernel.hpp>
#include <rigor/engine/instructions.hpp>
#include <vector>

namespace rigor {

/// Many exact flights, evaluated together at one time: for each the bits of ExactFlight::at, on every instruction set and
/// for any number of threads.
class FlightBatch {
 public:
  explicit FlightBatch(const std::vector<ExactFlight>& flights);

  std::size_t size() const { return place_.size(); }

  /// Attitudes and angular momenta at t seconds (any sign, finite), in place of those at the time before. `threads` ≥ 1
  /// are started for the call, fewer where the system has no more; one thread allocates nothing.
  /// Precondition: this processor has `instructions`; the widest it has when none are named.
  void evaluate(double t, unsigned threads = 1, std::optional<Instructions> instructions = {}) noexcept;

  /// Views of flight i (i < size()) as last evaluated, at t = 0 at first; nothing copied, alive as long as the batch.
  using VectorView = Eigen::Map<const Vec3<double>, 0, Eigen::InnerStride<detail::flight_lanes>>;
  using MatrixView = Eigen::Map<const Mat3<double>, 0, Eigen::Stride<3 * detail::flight_lanes, detail::flight_lanes>>;
  MatrixView R_WB(std::size_t i) const { return MatrixView(&blocks_[place_[i].block].R[0][place_[i].lane]); }
  VectorView L_B(std::size_t i) const { return VectorView(&blocks_[place_[i].block].L[0][place_[i].lane]); }

 private:
  struct Place {
    std::size_t block;
    int lane;
  };
  struct Rotation {  // flights without an elliptic function, one by one
    ExactFlight flight;
    Place place;
  };
  void put(const Place& place, const Attitude& attitude);

  std::vector<detail::FlightBlock> blocks_;  // `evaluated_` of them by the kernel, the rest hold the rotations
  std::size_t evaluated_ = 0;
  std::vector<Place> place_;
  std::vector<Rotation> rotations_;
};

}  // namespace rigor
