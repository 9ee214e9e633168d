#pragma once
#include <algorithm>
#include <rigor/base/promise.hpp>
#include <rigor/engine/compiled.hpp>
#include <rigor/engine/instructions.hpp>
#include <thread>
#include <vector>

namespace rigor::detail {

/// The one of these instructions.
template <class Function>
Function* compiled_for(Instructions instructions, const Compiled<Function>& function) {
  Function* const found = instructions == Instructions::avx512 ? function.avx512 : instructions == Instructions::avx2 ? function.avx2 : function.baseline;
  promise(found != nullptr, "a batch works with instructions the processor has");
  return found;
}

/// run(first, last) for the parts of [0, count), one on this thread and the rest on threads started for it; one thread
/// allocates nothing.
template <class Run>
void in_shares(long count, unsigned threads, const Run& run) {
  promise(threads >= 1, "a batch works on threads >= 1 threads");
  const long shares = std::clamp(long(threads), 1l, std::max(count, 1l));
  std::vector<std::jthread> others;
  if (shares > 1) others.reserve(std::size_t(shares) - 1);
  for (long k = 1; k < shares; ++k) others.emplace_back(run, count * k / shares, count * (k + 1) / shares);
  run(0l, count / shares);
}

}  // namespace rigor::detail
