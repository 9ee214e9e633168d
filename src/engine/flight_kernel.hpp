#pragma once
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

/// All at t seconds. The same bits from all three; the caller sees to it that the processor has the instructions.
void evaluate_blocks_baseline(FlightBlock* blocks, long count, double t);
void evaluate_blocks_avx2(FlightBlock* blocks, long count, double t);  // and fma
void evaluate_blocks_avx512(FlightBlock* blocks, long count, double t);

}  // namespace rigor::detail
