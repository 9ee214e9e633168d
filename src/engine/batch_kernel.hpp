#pragma once
#include <rigor/engine/compiled.hpp>

// What the kernel and Batch share. No Eigen and no standard containers: the kernel is compiled for several
// instruction sets, and nothing that other files compile too may come along.
namespace rigor::detail {

constexpr int lanes = 8;  ///< bodies side by side: one AVX-512 vector, two of AVX2, four of SSE2

/// Eight bodies, each quantity an array over them. World axes, SI units.
struct alignas(64) BatchBlock {
  double R[9][lanes];          ///< R_WB by columns
  double L[3][lanes];          ///< spin angular momentum
  double w[3][lanes];          ///< derived from L and R
  double v[3][lanes];
  double p[3][lanes];
  double a[3][lanes];          ///< f/m
  double tau[3][lanes];
  double inverse_I[3][lanes];  ///< principal, body axes
  double middle[lanes];        ///< the axis of the middle moment: 0, 1 or 2
};

/// `steps` steps of size h of `count` blocks. Each set of instructions gives the same bits.
using StepBlocks = void(BatchBlock* blocks, long count, double h, long steps);
extern const Compiled<StepBlocks> euler_momentum_blocks, euler_momentum_cross_blocks, split2_blocks;

}  // namespace rigor::detail
