#pragma once

namespace rigor::detail {

/// sin(πx) and cos(πx) for |x| < 2^30, without branches or libm, within about 1 ulp: the same bits on every
/// processor. Taylor series of sin(πy)/y and cos(πy) in y², |y| ≤ 1/4, after x = k/2 + y.
[[gnu::always_inline]] inline void sincospi(double x, double& sine, double& cosine) {
  const double k = __builtin_rint(2 * x), y = __builtin_fma(k, -0.5, x), z = y * y;
  double s = 7.9520540014755128e-7;
  s = __builtin_fma(s, z, -2.1915353447830216e-5);
  s = __builtin_fma(s, z, 4.6630280576761256e-4);
  s = __builtin_fma(s, z, -7.3704309457143504e-3);
  s = __builtin_fma(s, z, 8.2145886611128228e-2);
  s = __builtin_fma(s, z, -5.9926452932079207e-1);
  s = __builtin_fma(s, z, 2.5501640398773455);
  s = __builtin_fma(s, z, -5.1677127800499700);
  s = __builtin_fma(y, 3.1415926535897932, y * __builtin_fma(s, z, 1.2246467991473532e-16));  // π = hi + lo
  double c = 4.3030695870329470e-6;
  c = __builtin_fma(c, z, -1.0463810492484570e-4);
  c = __builtin_fma(c, z, 1.9295743094039230e-3);
  c = __builtin_fma(c, z, -2.5806891390014060e-2);
  c = __builtin_fma(c, z, 2.3533063035889320e-1);
  c = __builtin_fma(c, z, -1.3352627688545895);
  c = __builtin_fma(c, z, 4.0587121264167682);
  c = __builtin_fma(c, z, -4.9348022005446793);
  c = __builtin_fma(c, z, 1.0);
  const double half = k * 0.5, whole = __builtin_floor(half);
  const bool odd = half - whole > 0.25;  // k odd: a quarter turn swaps the two
  const double sign = 1 - 4 * (whole * 0.5 - __builtin_floor(whole * 0.5));
  sine = sign * (odd ? c : s);
  cosine = sign * (odd ? -s : c);
}

}  // namespace rigor::detail
