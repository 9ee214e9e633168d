#include <algorithm>
#include <cmath>
#include <rigor/base/promise.hpp>
#include <rigor/engine/batch.hpp>
#include <rigor/engine/shares.hpp>
#include <rigor/formulas/linear_acceleration.hpp>
#include <rigor/integrators/splitting.hpp>
#include <string>

namespace rigor {
namespace {

using detail::BatchBlock, detail::lanes;

// 16 blocks are 31 kB: what a tile needs stays in a first-level cache of 32 kB from one step to the next.
constexpr long tile = 16;

template <class Field, class Vector>
void put(Field& field, std::size_t i, const Vector& value) {
  for (int k = 0; k < 3; ++k) field[k][i % lanes] = value[k];
}

struct Row {
  const char* plain;
  const detail::Compiled<detail::StepBlocks>& kernels;
};
const Row& row_of(BatchMethod method) {
  static constexpr Row rows[] = {{"euler-momentum", detail::euler_momentum_blocks}, {"euler-momentum-cross", detail::euler_momentum_cross_blocks}, {"split2", detail::split2_blocks}};
  return rows[int(method)];
}

}  // namespace

const Method& plain(BatchMethod method) { return *find_method(row_of(method).plain); }

Outcome<Batch> Batch::make(const std::vector<Cuboid<double>>& bodies, const std::vector<Motion>& motions, BatchMethod method) {
  if (bodies.size() != motions.size())
    return Fault{Fault::Kind::malformed, "motions", "are " + std::to_string(motions.size()) + ", must be one for each of " + std::to_string(bodies.size()) + " bodies"};
  Batch batch;
  batch.method_ = method;
  BatchBlock at_rest{};
  for (int lane = 0; lane < lanes; ++lane) at_rest.R[0][lane] = at_rest.R[4][lane] = at_rest.R[8][lane] = 1;
  batch.blocks_.assign((bodies.size() + lanes - 1) / lanes, at_rest);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Motion& m = motions[i];
    const std::string where = "motions[" + std::to_string(i) + "].";
    for (const auto& [field, value] : {std::pair{"p_WB", &m.state.p_WB}, {"v_WB", &m.state.v_WB}, {"w_WB", &m.state.w_WB}, {"L_W", &m.L_W}})
      for (int k = 0; k < 3; ++k)
        if (!std::isfinite((*value)[k])) return Fault{Fault::Kind::not_finite, where + field + "[" + std::to_string(k) + "]", "is not finite, must be a number"};
    for (int k = 0; k < 9; ++k)
      if (!std::isfinite(m.state.R_WB(k % 3, k / 3)))
        return Fault{Fault::Kind::not_finite, where + "R_WB(" + std::to_string(k % 3) + "," + std::to_string(k / 3) + ")", "is not finite, must be a number"};
    BatchBlock& b = batch.blocks_[i / lanes];
    for (int k = 0; k < 9; ++k) b.R[k][i % lanes] = m.state.R_WB(k % 3, k / 3);
    put(b.L, i, m.L_W);
    put(b.w, i, m.state.w_WB);
    put(b.v, i, m.state.v_WB);
    put(b.p, i, m.state.p_WB);
    put(b.inverse_I, i, bodies[i].inverse_inertia());
    b.middle[i % lanes] = middle_axis(bodies[i].inertia());
    batch.inverse_mass_.push_back(bodies[i].inverse_mass());
  }
  return batch;
}

void Batch::set_load(std::size_t i, const Load& load) {
  BatchBlock& b = blocks_[i / lanes];
  put(b.a, i, linear_acceleration<double>(inverse_mass_[i], load.f_W));
  put(b.tau, i, load.tau_W);
}

Motion Batch::motion(std::size_t i) const { return {{p_WB(i), R_WB(i), v_WB(i), w_WB(i)}, L_W(i)}; }

void Batch::step(double h, long steps, unsigned threads, std::optional<Instructions> instructions) noexcept {
  promise(steps >= 0, "a batch makes steps >= 0 steps");
  const auto advance = detail::compiled_for(instructions.value_or(widest_instructions()), row_of(method_).kernels);
  // Which thread steps a block, and in which company, changes nothing: no lane reads another.
  detail::in_shares(long(blocks_.size()), threads, [this, advance, h, steps](long first, long last) {
    for (long i = first; i < last; i += tile) advance(blocks_.data() + i, std::min(tile, last - i), h, steps);
  });
}

}  // namespace rigor
