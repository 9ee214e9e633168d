#include <algorithm>
#include <array>
#include <map>
#include <rigor/engine/flight_batch.hpp>
#include <rigor/engine/shares.hpp>
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

void FlightBatch::evaluate(double t, unsigned threads, std::optional<Instructions> instructions) noexcept {
  const auto evaluate_blocks = detail::compiled_for(instructions.value_or(widest_instructions()), detail::flight_blocks);
  detail::in_shares(long(evaluated_), threads, [this, evaluate_blocks, t](long first, long last) { evaluate_blocks(blocks_.data() + first, last - first, t); });
  for (const Rotation& r : rotations_) put(r.place, r.flight.at(t));
}

}  // namespace rigor
