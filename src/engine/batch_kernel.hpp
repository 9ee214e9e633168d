#pragma once

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
};

/// `steps` steps of size h of `count` blocks, by the momentum form of symplectic Euler. All three give the same
/// bits; the caller sees to it that the processor has the instructions.
void step_blocks_baseline(BatchBlock* blocks, long count, double h, long steps);
void step_blocks_avx2(BatchBlock* blocks, long count, double h, long steps);
void step_blocks_avx512(BatchBlock* blocks, long count, double h, long steps);

}  // namespace rigor::detail
