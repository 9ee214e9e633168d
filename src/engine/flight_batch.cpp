#include <algorithm>
#include <array>
#include <map>
#include <rigor/base/promise.hpp>
#include <rigor/engine/flight_batch.hpp>
#include <thread>
#include <tuple>

namespace rigor {
namespace {

using detail::FlightBlock, detail::FlightNumbers, detail::flight_lanes;
using Kind = ExactFlight::Tuned::Kind;

// FlightNumbers<double> is so many doubles, and a block the same with each of them eight wide.
constexpr std::size_t numbers = sizeof(FlightNumbers<double>) / sizeof(double);
static_assert(sizeof(FlightNumbers<double[flight_lanes]>) == numbers * flight_lanes * sizeof(double));

void put_lane(FlightNumbers<double[flight_lanes]>& block, int lane, const FlightNumbers<double>& flight) {
  double* to = reinterpret_cast<double*>(&block);
  const double* from = reinterpret_cast<const double*>(&flight);
  for (std::size_t k = 0; k < numbers; ++k) to[k * flight_lanes + std::size_t(lane)] = from[k];
}

using Kernel = void (*)(FlightBlock*, long, double);
Kernel kernel(Instructions instructions) {
#ifdef __x86_64__
  if (instructions == Instructions::avx512) return detail::evaluate_blocks_avx512;
  if (instructions == Instructions::avx2) return detail::evaluate_blocks_avx2;
#endif
  promise(instructions == Instructions::baseline, "a batch works with instructions the processor has");
  return detail::evaluate_blocks_baseline;
}

}  // namespace

FlightBatch::FlightBatch(const std::vector<ExactFlight>& flights) {
  // Lanes of a block share the series and the order of the axes: twelve groups at most, and the rotations last.
  std::map<std::tuple<bool, bool, std::array<int, 3>>, std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < flights.size(); ++i) {
    const ExactFlight::Tuned& f = flights[i].tuned();
    groups[{f.kind == Kind::pure_rotation, f.kind == Kind::theta_prime, f.axis}].push_back(i);
  }
  place_.resize(flights.size());
  for (const auto& [group, members] : groups) {
    const auto& [rotation, prime, axis] = group;
    for (std::size_t k = 0; k < members.size(); ++k) {
      const ExactFlight& flight = flights[members[k]];
      const int lane = int(k % flight_lanes);
      if (lane == 0) {
        FlightBlock& block = blocks_.emplace_back();
        block.prime = prime;
        std::copy(axis.begin(), axis.end(), block.axis);
        for (int other = 0; other < flight_lanes; ++other) put_lane(block.f, other, flight.tuned().numbers);  // no lane is empty
        if (!rotation) evaluated_ = blocks_.size();
      }
      place_[members[k]] = {blocks_.size() - 1, lane};
      if (rotation) rotations_.push_back({flight, place_[members[k]]});
      else put_lane(blocks_.back().f, lane, flight.tuned().numbers);
    }
  }
  evaluate(0);
}

void FlightBatch::put(const Place& place, const Attitude& attitude) {
  FlightBlock& b = blocks_[place.block];
  for (int k = 0; k < 9; ++k) b.R[k][place.lane] = attitude.R_WB(k % 3, k / 3);
  for (int k = 0; k < 3; ++k) b.L[k][place.lane] = attitude.L_B[k];
}

void FlightBatch::evaluate(double t, unsigned threads, std::optional<Instructions> instructions) {
  promise(threads >= 1, "a batch works on threads >= 1 threads");
  const Kernel evaluate_blocks = kernel(instructions.value_or(widest_instructions()));
  const long count = long(evaluated_), shares = std::clamp(long(threads), 1l, std::max(count, 1l));
  const auto run = [this, evaluate_blocks, t](long first, long last) { evaluate_blocks(blocks_.data() + first, last - first, t); };
  std::vector<std::jthread> others;
  if (shares > 1) others.reserve(std::size_t(shares) - 1);
  for (long k = 1; k < shares; ++k) others.emplace_back(run, count * k / shares, count * (k + 1) / shares);
  run(0, count / shares);
  for (const Rotation& r : rotations_) put(r.place, r.flight.at(t));
}

}  // namespace rigor
