#pragma once
#include <rigor/engine/compiled.hpp>
#include <rigor/engine/flight_lane.hpp>

namespace rigor::detail {

constexpr int flight_lanes = 8;

/// Eight flights whose axes are permuted alike and that use the same series, and where they are.
struct alignas(64) FlightBlock {
  FlightNumbers<double[flight_lanes]> f;
  double R[9][flight_lanes];  ///< R_WB by columns
  double L[3][flight_lanes];  ///< L_B
  int axis[3];
  bool prime;
};

/// All at t seconds; the same bits from each. AVX2 means with fma.
extern const Compiled<void(FlightBlock* blocks, long count, double t)> flight_blocks;

}  // namespace rigor::detail
