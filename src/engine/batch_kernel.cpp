// step_euler_momentum and step_euler_momentum_cross of src/integrators/euler.cpp over lanes: the same operations in the
// same order, so the same bits.
// Compiled with -O3 -fno-math-errno -fno-trapping-math (CMakeLists.txt), which change no value and let loops be vectors.
#include <rigor/engine/batch_kernel.hpp>

#define RIGOR_INLINE [[gnu::always_inline]] inline

namespace rigor::detail {
namespace {

struct V {
  double x, y, z;
};

RIGOR_INLINE double dot(const V& a, const V& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
RIGOR_INLINE V advanced(const V& x, double h, const V& rate) { return {x.x + h * rate.x, x.y + h * rate.y, x.z + h * rate.z}; }
RIGOR_INLINE V cross(const V& a, const V& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
RIGOR_INLINE V unit(const V& a) {
  const double length = __builtin_sqrt(dot(a, a));
  return {a.x / length, a.y / length, a.z / length};
}
RIGOR_INLINE V unit_by_product(const V& a) {
  const double scale = 1 / __builtin_sqrt(dot(a, a));
  return {scale * a.x, scale * a.y, scale * a.z};
}
RIGOR_INLINE V without(const V& a, const V& u) {
  const double along = dot(u, a);
  return {a.x - along * u.x, a.y - along * u.y, a.z - along * u.z};
}
RIGOR_INLINE V at(const double (*field)[lanes], int lane) { return {field[0][lane], field[1][lane], field[2][lane]}; }
RIGOR_INLINE void put(double (*field)[lanes], int lane, const V& value) {
  field[0][lane] = value.x;
  field[1][lane] = value.y;
  field[2][lane] = value.z;
}

RIGOR_INLINE void move_centre(BatchBlock& b, int lane, double h) {
  const V v = advanced(at(b.v, lane), h, at(b.a, lane));
  put(b.p, lane, advanced(at(b.p, lane), h, v));
  put(b.v, lane, v);
}

RIGOR_INLINE void euler_momentum(BatchBlock& b, int lane, double h) {
  const V c0 = at(b.R, lane), c1 = at(b.R + 3, lane), c2 = at(b.R + 6, lane), k = at(b.inverse_I, lane);
  const V L = advanced(at(b.L, lane), h, at(b.tau, lane));

  // I⁻¹ in world axes, entry (i, j) = Σ R_ik k_k R_jk, then ω = I⁻¹ L
  const V row0{c0.x, c1.x, c2.x}, row1{c0.y, c1.y, c2.y}, row2{c0.z, c1.z, c2.z};
  const V k0{row0.x * k.x, row0.y * k.y, row0.z * k.z}, k1{row1.x * k.x, row1.y * k.y, row1.z * k.z}, k2{row2.x * k.x, row2.y * k.y, row2.z * k.z};
  const double xy = dot(k0, row1), xz = dot(k0, row2), yz = dot(k1, row2);
  const V w{dot({dot(k0, row0), xy, xz}, L), dot({xy, dot(k1, row1), yz}, L), dot({xz, yz, dot(k2, row2)}, L)};

  put(b.L, lane, L);
  put(b.w, lane, w);
  move_centre(b, lane, h);

  const V u0 = unit(advanced(c0, h, cross(w, c0)));
  const V u1 = unit(without(advanced(c1, h, cross(w, c1)), u0));
  const V u2 = unit(without(without(advanced(c2, h, cross(w, c2)), u0), u1));
  put(b.R, lane, u0);
  put(b.R + 3, lane, u1);
  put(b.R + 6, lane, u2);
}

RIGOR_INLINE void euler_momentum_cross(BatchBlock& b, int lane, double h) {
  const V c0 = at(b.R, lane), c1 = at(b.R + 3, lane), c2 = at(b.R + 6, lane), k = at(b.inverse_I, lane);
  const V L = advanced(at(b.L, lane), h, at(b.tau, lane));
  const V w_B{dot(c0, L) * k.x, dot(c1, L) * k.y, dot(c2, L) * k.z};
  const V w{dot({c0.x, c1.x, c2.x}, w_B), dot({c0.y, c1.y, c2.y}, w_B), dot({c0.z, c1.z, c2.z}, w_B)};
  put(b.L, lane, L);
  put(b.w, lane, w);
  move_centre(b, lane, h);

  const V a1 = advanced(c1, h, cross(w, c1));
  const V u0 = unit_by_product(advanced(c0, h, cross(w, c0)));
  const V u1 = unit_by_product(without(a1, u0));
  put(b.R, lane, u0);
  put(b.R + 3, lane, u1);
  put(b.R + 6, lane, cross(u0, u1));
}

// Types and not pointers to functions: inlined before the loop over lanes is looked at, which then becomes vectors.
template <class StepLane>
RIGOR_INLINE void step_all(BatchBlock* blocks, long count, double h, long steps) {
  for (long step = 0; step < steps; ++step)
    for (long i = 0; i < count; ++i)
      for (int lane = 0; lane < lanes; ++lane) StepLane::step(blocks[i], lane, h);
}
struct Momentum {
  RIGOR_INLINE static void step(BatchBlock& b, int lane, double h) { euler_momentum(b, lane, h); }
};
struct MomentumCross {
  RIGOR_INLINE static void step(BatchBlock& b, int lane, double h) { euler_momentum_cross(b, lane, h); }
};

template <class StepLane>
void baseline(BatchBlock* blocks, long count, double h, long steps) {
  step_all<StepLane>(blocks, count, h, steps);
}
#ifdef __x86_64__
template <class StepLane>
[[gnu::target("avx2")]] void avx2(BatchBlock* blocks, long count, double h, long steps) {
  step_all<StepLane>(blocks, count, h, steps);
}
template <class StepLane>
[[gnu::target("avx512f,avx512dq,avx512vl")]] void avx512(BatchBlock* blocks, long count, double h, long steps) {
  step_all<StepLane>(blocks, count, h, steps);
}
template <class StepLane>
constexpr Compiled<StepBlocks> compiled{baseline<StepLane>, avx2<StepLane>, avx512<StepLane>};
#else
template <class StepLane>
constexpr Compiled<StepBlocks> compiled{baseline<StepLane>, nullptr, nullptr};
#endif

}  // namespace

const Compiled<StepBlocks> euler_momentum_blocks = compiled<Momentum>;
const Compiled<StepBlocks> euler_momentum_cross_blocks = compiled<MomentumCross>;

}  // namespace rigor::detail
