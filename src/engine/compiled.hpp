#pragma once

namespace rigor::detail {

/// One function compiled for each instruction set; null where the processor's family has none. No includes: kernels see it.
template <class Function>
struct Compiled {
  Function* baseline;
  Function* avx2;
  Function* avx512;
};

}  // namespace rigor::detail
