// evaluate_flight over lanes. Compiled as batch_kernel.cpp is (CMakeLists.txt).
#include <rigor/engine/flight_kernel.hpp>

namespace rigor::detail {
namespace {

struct Columns {
  double R[9][flight_lanes], L[3][flight_lanes];  // in the order of the permuted axes
};

// Into a local: what is written cannot be what is read, or the loop would not become vectors.
template <bool prime>
[[gnu::always_inline]] inline void evaluate_lanes(const FlightNumbers<double[flight_lanes]>& f, double t, Columns& out) {
  for (int lane = 0; lane < flight_lanes; ++lane) {
    const FlightColumns now = evaluate_flight<prime>(f, lane, t);
    for (int k = 0; k < 9; ++k) out.R[k][lane] = now.R[k / 3][k % 3];
    for (int k = 0; k < 3; ++k) out.L[k][lane] = now.L[k];
  }
}

[[gnu::always_inline]] inline void evaluate_blocks(FlightBlock* blocks, long count, double t) {
  for (long i = 0; i < count; ++i) {
    FlightBlock& b = blocks[i];
    Columns out;
    if (b.prime) evaluate_lanes<true>(b.f, t, out);
    else evaluate_lanes<false>(b.f, t, out);
    for (int k = 0; k < 3; ++k) {
      __builtin_memcpy(b.R[3 * b.axis[k]], out.R[3 * k], sizeof out.R / 3);
      __builtin_memcpy(b.L[b.axis[k]], out.L[k], sizeof out.L / 3);
    }
  }
}

void baseline(FlightBlock* blocks, long count, double t) { evaluate_blocks(blocks, count, t); }
#ifdef __x86_64__
[[gnu::target("avx2,fma")]] void avx2(FlightBlock* blocks, long count, double t) { evaluate_blocks(blocks, count, t); }
[[gnu::target("avx512f,avx512dq,avx512vl,fma")]] void avx512(FlightBlock* blocks, long count, double t) { evaluate_blocks(blocks, count, t); }
#endif

}  // namespace

#ifdef __x86_64__
const Compiled<void(FlightBlock*, long, double)> flight_blocks{baseline, avx2, avx512};
#else
const Compiled<void(FlightBlock*, long, double)> flight_blocks{baseline, nullptr, nullptr};
#endif

}  // namespace rigor::detail
