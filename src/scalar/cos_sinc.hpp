#pragma once
// No includes: the batches' kernels see it.

namespace rigor {

/// cos √z and sin √z / √z, z ≥ 0, by sums, products, quotients and roots alone: no mathematics library and nothing fused, so
/// the same bits on every processor, in a loop over lanes too.
struct CosSinc {
  double cos, sinc;
};

/// z < 1/4: the series within about 1 ulp (next terms z⁸/16!, z⁷/15! < u/2), in pairs so that the processor has something to
/// do at the same time.
[[gnu::always_inline]] inline CosSinc cos_sinc_near(double z) {
  const double z2 = z * z, z4 = z2 * z2;
  return {((1 - z * (1 / 2.)) + z2 * (1 / 24. - z * (1 / 720.))) + z4 * ((1 / 40320. - z * (1 / 3628800.)) + z2 * (1 / 479001600. - z * (1 / 87178291200.))),
          ((1 - z * (1 / 6.)) + z2 * (1 / 120. - z * (1 / 5040.))) + z4 * ((1 / 362880. - z * (1 / 39916800.)) + z2 * (1 / 6227020800.))};
}

/// z ≥ 1/4, without branches: √z in half turns, of which quarter turns are counted off without an error, then the series up to
/// π/4 (next terms z⁹/18!, z⁹/19! < u/20). The angle is that of a double two roundings away, u = 2^-53: cos and sin within
/// 2u(1 + √z). 2^49 half turns and more, which no double tells from whole turns, are taken for none.
[[gnu::always_inline]] inline CosSinc cos_sinc_far(double z) {
  constexpr double pi = 3.1415926535897932, unit = 6755399441055744.;  // 1.5 · 2^52: a sum with it has no place for less than 1
  const double x = __builtin_sqrt(z), all = x * (1 / pi), t = all >= 0x1p49 ? 0 : all;
  const double k = (2 * t + unit) - unit, q = k - 4 * ((k / 4 + unit) - unit);  // quarter turns, and what they leave of whole ones: -2 to 2
  const double y = pi * (t - 0.5 * k), y2 = y * y, y4 = y2 * y2, y8 = y4 * y4;
  const CosSinc near = cos_sinc_near(y2);
  const double c = near.cos + y8 * y8 * (1 / 20922789888000.);
  const double s = y * (near.sinc - y8 * (y4 * y2) * (1 / 1307674368000. - y2 * (1 / 355687428096000.)));
  const bool odd = q * q == 1;
  const double cosine = q * q + q > 1 ? -1 : 1, sine = q * q - q > 1 ? -1 : 1;  // signs
  return {cosine * (odd ? s : c), sine * (odd ? c : s) / x};
}

/// The same out of the way of loops whose angles are small as a rule: inside them it takes the registers (a third of a splitting's time).
[[gnu::noinline]] inline CosSinc cos_sinc_far_apart(double z) { return cos_sinc_far(z); }

/// For any z ≥ 0.
inline CosSinc cos_sinc(double z) {
  if (!(z < 0.25)) [[unlikely]] return cos_sinc_far_apart(z);
  return cos_sinc_near(z);
}

}  // namespace rigor
