// step_euler_momentum and step_euler_momentum_cross of src/integrators/euler.cpp and step_split2 of splitting.cpp over
// lanes: the same operations in the same order, so the same bits.
// Compiled with -O3 -fno-math-errno -fno-trapping-math (CMakeLists.txt), which change no value and let loops be vectors.
#include <rigor/engine/batch_kernel.hpp>
#include <rigor/scalar/cos_sinc.hpp>

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

// The free turn of two axes (split2). Arguments of cos_sinc below 1/4 are the rule and take a third of the work of the rest:
// `near` says that all of a block's are.
template <bool near>
RIGOR_INLINE CosSinc cos_sinc_of(double z) {
  const CosSinc small = cos_sinc_near(z);
  if constexpr (near) return small;
  const CosSinc large = cos_sinc_far(z < 0.25 ? 0.25 : z);  // not 0, by whose root it divides: the user may trap what is no number
  return {z < 0.25 ? small.cos : large.cos, z < 0.25 ? small.sinc : large.sinc};
}
template <bool near, int k>
RIGOR_INLINE void turn_about(double x, double (&q)[4], double (&L)[3]) {
  constexpr int i = (k + 1) % 3, j = (k + 2) % 3;
  const CosSinc half = cos_sinc_of<near>(x * x);
  const double c = half.cos, s = x * half.sinc, C = 1 - 2 * s * s, S = 2 * s * c, y = L[i], z = L[j];
  L[i] = C * y + S * z, L[j] = C * z - S * y;
  const double p[4] = {q[0], q[1], q[2], q[3]};
  q[0] = p[0] * c - p[1 + k] * s, q[1 + k] = p[1 + k] * c + p[0] * s;
  q[1 + i] = p[1 + i] * c + p[1 + j] * s, q[1 + j] = p[1 + j] * c - p[1 + i] * s;
}
RIGOR_INLINE double chosen(double middle, double if_0, double if_1, double if_2) { return middle == 0 ? if_0 : middle == 1 ? if_1 : if_2; }
RIGOR_INLINE V to_second(double m, const V& x) { return {chosen(m, x.z, x.x, x.y), chosen(m, x.x, x.y, x.z), chosen(m, x.y, x.z, x.x)}; }

template <bool near>
RIGOR_INLINE void split2_turn(BatchBlock& b, const double (*L_B)[lanes], int lane, double h) {
  const double m = b.middle[lane];
  const V inverse_I = at(b.inverse_I, lane), k = to_second(m, inverse_I), L0 = to_second(m, at(L_B, lane));
  const double half_first = (k.x - k.y) / 2, half_third = (k.z - k.y) / 2;
  double L[3] = {L0.x, L0.y, L0.z}, q[4] = {1, 0, 0, 0};
  turn_about<near, 0>((0.0 + h / 2) * (L[0] * half_first), q, L);
  turn_about<near, 2>(h * (L[2] * half_third), q, L);
  turn_about<near, 0>(h / 2 * (L[0] * half_first), q, L);

  const double rate = h * k.y;
  const V theta{rate * L0.x, rate * L0.y, rate * L0.z};
  const CosSinc half = cos_sinc_of<near>(dot(theta, theta) / 4);
  const double f = half.sinc / 2, e[4] = {half.cos, f * theta.x, f * theta.y, f * theta.z};
  const double w = e[0] * q[0] - e[1] * q[1] - e[2] * q[2] - e[3] * q[3], second[3] = {e[0] * q[1] + e[1] * q[0] + e[2] * q[3] - e[3] * q[2],
                                                                                       e[0] * q[2] - e[1] * q[3] + e[2] * q[0] + e[3] * q[1],
                                                                                       e[0] * q[3] + e[1] * q[2] - e[2] * q[1] + e[3] * q[0]};
  // back to the body's order: its axis i is the second's 4 - m + i
  const double x = chosen(m, second[1], second[0], second[2]), y = chosen(m, second[2], second[1], second[0]), z = chosen(m, second[0], second[2], second[1]);

  const double n = 2 / (w * w + x * x + y * y + z * z);
  const V turn[3] = {{1 - n * (y * y + z * z), n * (x * y + w * z), n * (x * z - w * y)},
                     {n * (x * y - w * z), 1 - n * (x * x + z * z), n * (y * z + w * x)},
                     {n * (x * z + w * y), n * (y * z - w * x), 1 - n * (x * x + y * y)}};
  const V c0 = at(b.R, lane), c1 = at(b.R + 3, lane), c2 = at(b.R + 6, lane);
  const V L_W = advanced(at(b.L, lane), h / 2, at(b.tau, lane));
  V c[3], w_B;
  for (int i = 0; i < 3; ++i) {  // sums in the order of Eigen's product of matrices
    c[i] = {c0.x * turn[i].x + (c1.x * turn[i].y + c2.x * turn[i].z), c0.y * turn[i].x + (c1.y * turn[i].y + c2.y * turn[i].z),
            c0.z * turn[i].x + (c1.z * turn[i].y + c2.z * turn[i].z)};
    put(b.R + 3 * i, lane, c[i]);
  }
  w_B = {dot(c[0], L_W) * inverse_I.x, dot(c[1], L_W) * inverse_I.y, dot(c[2], L_W) * inverse_I.z};
  put(b.L, lane, L_W);
  put(b.w, lane, {dot({c[0].x, c[1].x, c[2].x}, w_B), dot({c[0].y, c[1].y, c[2].y}, w_B), dot({c[0].z, c[1].z, c[2].z}, w_B)});
}

RIGOR_INLINE void split2(BatchBlock& b, double h) {
  double L_B[3][lanes];
  long long far = 0;
  for (int lane = 0; lane < lanes; ++lane) {
    const V v = at(b.v, lane), a = at(b.a, lane), L = advanced(at(b.L, lane), h / 2, at(b.tau, lane));
    put(b.p, lane, advanced(at(b.p, lane), h, advanced(v, h / 2, a)));
    put(b.v, lane, advanced(v, h, a));
    put(b.L, lane, L);
    const V in_B{dot(at(b.R, lane), L), dot(at(b.R + 3, lane), L), dot(at(b.R + 6, lane), L)}, k = at(b.inverse_I, lane);
    put(L_B, lane, in_B);
    // no argument of cos_sinc is above (h |L| k/2)², k the largest of the inverse moments
    const double largest = k.x > k.y ? (k.x > k.z ? k.x : k.z) : (k.y > k.z ? k.y : k.z), reach = h / 2 * largest;
    far |= reach * reach * dot(in_B, in_B) < 0.249 ? 0 : 1;
  }
  if (far) {
    for (int lane = 0; lane < lanes; ++lane) split2_turn<false>(b, L_B, lane, h);
  } else {
    for (int lane = 0; lane < lanes; ++lane) split2_turn<true>(b, L_B, lane, h);
  }
}

// Types and not pointers to functions: inlined before the loop over lanes is looked at, which then becomes vectors.
template <class StepBlock>
RIGOR_INLINE void step_all(BatchBlock* blocks, long count, double h, long steps) {
  for (long step = 0; step < steps; ++step)
    for (long i = 0; i < count; ++i) StepBlock::step(blocks[i], h);
}
struct Momentum {
  RIGOR_INLINE static void step(BatchBlock& b, double h) {
    for (int lane = 0; lane < lanes; ++lane) euler_momentum(b, lane, h);
  }
};
struct MomentumCross {
  RIGOR_INLINE static void step(BatchBlock& b, double h) {
    for (int lane = 0; lane < lanes; ++lane) euler_momentum_cross(b, lane, h);
  }
};
struct Split2 {
  RIGOR_INLINE static void step(BatchBlock& b, double h) { split2(b, h); }
};

template <class StepBlock>
void baseline(BatchBlock* blocks, long count, double h, long steps) {
  step_all<StepBlock>(blocks, count, h, steps);
}
#ifdef __x86_64__
template <class StepBlock>
[[gnu::target("avx2")]] void avx2(BatchBlock* blocks, long count, double h, long steps) {
  step_all<StepBlock>(blocks, count, h, steps);
}
template <class StepBlock>
[[gnu::target("avx512f,avx512dq,avx512vl")]] void avx512(BatchBlock* blocks, long count, double h, long steps) {
  step_all<StepBlock>(blocks, count, h, steps);
}
template <class StepBlock>
constexpr Compiled<StepBlocks> compiled{baseline<StepBlock>, avx2<StepBlock>, avx512<StepBlock>};
#else
template <class StepBlock>
constexpr Compiled<StepBlocks> compiled{baseline<StepBlock>, nullptr, nullptr};
#endif

}  // namespace

const Compiled<StepBlocks> euler_momentum_blocks = compiled<Momentum>;
const Compiled<StepBlocks> euler_momentum_cross_blocks = compiled<MomentumCross>;
const Compiled<StepBlocks> split2_blocks = compiled<Split2>;

}  // namespace rigor::detail
