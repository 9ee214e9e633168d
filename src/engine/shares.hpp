#pragma once
#include <algorithm>
#include <exception>
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
/// allocates nothing. Where no more threads are to be had, this one does their parts too: it does not throw unless `run` does.
template <class Run>
void in_shares(long count, unsigned threads, const Run& run) {
  promise(threads >= 1, "a batch works on threads >= 1 threads");
  const long shares = std::clamp(long(threads), 1l, std::max(count, 1l));
  std::vector<std::jthread> others;
  long next = 1;
  try {
    if (shares > 1) others.reserve(std::size_t(shares) - 1);
    for (; next < shares; ++next) others.emplace_back(run, count * next / shares, count * (next + 1) / shares);
  } catch (const std::exception&) {
  }
  run(0l, count / shares);
  if (next < shares) run(count * next / shares, count);
}

}  // namespace rigor::detail
