#pragma once
#include <optional>
#include <rigor/base/outcome.hpp>
#include <rigor/engine/batch_kernel.hpp>
#include <rigor/engine/instructions.hpp>
#include <rigor/integrators/method.hpp>
#include <vector>

namespace rigor {

/// The methods a batch steps by.
enum class BatchMethod { euler_momentum, euler_momentum_cross, split2 };
inline constexpr BatchMethod batch_methods[] = {BatchMethod::euler_momentum, BatchMethod::euler_momentum_cross, BatchMethod::split2};

/// The row of methods() a batch of this method has the bits of.
const Method& plain(BatchMethod method);

/// Many bodies that do not touch, stepped together: lane by lane the bits of the plain method, on every instruction set
/// and for any number of threads.
///
/// Without torque L stays the same to the bit (case D-08). For torque-free flight without a step there is ExactFlight.
class Batch {
 public:
  /// One motion per body (motion_of makes one from a state); attitudes are rotations.
  /// Faults: malformed, naming "motions", when the counts differ; not_finite, naming "motions[i].v_WB[k]" and so on.
  static Outcome<Batch> make(const std::vector<Cuboid<double>>& bodies, const std::vector<Motion>& motions, BatchMethod method = BatchMethod::euler_momentum);

  std::size_t size() const { return inverse_mass_.size(); }

  /// What acts on body i (i < size()) from now on, N and N·m; nothing at first.
  void set_load(std::size_t i, const Load& load);

  /// Body i (i < size()) as the plain method would hand it on.
  Motion motion(std::size_t i) const;

  /// Views of body i (i < size()), nothing copied; they follow the steps and live as long as the batch stays in place.
  using VectorView = Eigen::Map<const Vec3<double>, 0, Eigen::InnerStride<detail::lanes>>;
  using MatrixView = Eigen::Map<const Mat3<double>, 0, Eigen::Stride<3 * detail::lanes, detail::lanes>>;
  VectorView p_WB(std::size_t i) const { return VectorView(&block(i).p[0][i % detail::lanes]); }
  VectorView v_WB(std::size_t i) const { return VectorView(&block(i).v[0][i % detail::lanes]); }
  VectorView w_WB(std::size_t i) const { return VectorView(&block(i).w[0][i % detail::lanes]); }
  VectorView L_W(std::size_t i) const { return VectorView(&block(i).L[0][i % detail::lanes]); }
  MatrixView R_WB(std::size_t i) const { return MatrixView(&block(i).R[0][i % detail::lanes]); }

  /// `steps` ≥ 0 steps of h seconds under the present loads. Asked for many steps at once it takes few bodies through
  /// all of them while they are in the cache. `threads` ≥ 1 are started for the call (tens of µs); one thread
  /// allocates nothing. Fewer are used where the system has no more.
  /// Precondition: this processor has `instructions`; the widest it has when none are named.
  void step(double h, long steps = 1, unsigned threads = 1, std::optional<Instructions> instructions = {}) noexcept;

 private:
  Batch() = default;
  const detail::BatchBlock& block(std::size_t i) const { return blocks_[i / detail::lanes]; }

  std::vector<detail::BatchBlock> blocks_;  // the lanes past size() hold a body at rest
  std::vector<double> inverse_mass_;
  BatchMethod method_ = BatchMethod::euler_momentum;
};

}  // namespace rigor
