#pragma once
#include <array>

namespace rigor {

/// Symmetric compositions of a symmetric step of order 2: the stages sum to 1, and the sums of their odd powers vanish up to
/// the order. Yoshida 1990 (order 4); Kahan and Li 1997 (orders 6 and 8), digits as in Hairer, Lubich and Wanner, V.3.
inline constexpr std::array strang{1.0};
inline constexpr std::array yoshida4{1.3512071919596576340, -1.7024143839193152681, 1.3512071919596576340};
inline constexpr std::array kahan_li6{0.39216144400731413928, 0.33259913678935943860, -0.70624617255763935981, 0.082213596293550800230, 0.79854399093482996340,
                                      0.082213596293550800230, -0.70624617255763935981, 0.33259913678935943860, 0.39216144400731413928};
inline constexpr std::array kahan_li8{0.13020248308889008088, 0.56116298177510838456, -0.38947496264484728641, 0.15884190655515560090, -0.39590389413323757734,
                                      0.18453964097831570709, 0.25837438768632204729, 0.29501172360931029887, -0.60550853383003451170, 0.29501172360931029887,
                                      0.25837438768632204729, 0.18453964097831570709, -0.39590389413323757734, 0.15884190655515560090, -0.38947496264484728641,
                                      0.56116298177510838456, 0.13020248308889008088};

/// A splitting into two flows, not made of symmetric steps: kick b1, flow a1, kick b2 ... kick b1. Both rows sum to 1.
struct Splitting {
  std::array<double, 7> kick;
  std::array<double, 6> flow;
};
/// Six flows, order 4, its error constant hundreds of times smaller than Yoshida's. Blanes and Moan 2002, table 2.
inline constexpr Splitting blanes_moan4 = [] {
  constexpr double a1 = 0.0792036964311957, a2 = 0.353172906049774, a3 = -0.0420650803577195, b1 = 0.209515106613362, b2 = -0.143851773179818;
  constexpr double a4 = 1 - 2 * (a1 + a2 + a3), b3 = 0.5 - b1 - b2;
  return Splitting{{a1, a2, a3, a4, a3, a2, a1}, {b1, b2, b3, b3, b2, b1}};
}();

}  // namespace rigor
