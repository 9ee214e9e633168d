#pragma once
#include <cfenv>
#include <limits>
#include <optional>
#include <rigor/base/outcome.hpp>

#if defined(__FAST_MATH__) || defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "rigor needs IEEE 754 arithmetic: compile without -ffast-math and -ffinite-math-only"
#endif

namespace rigor {

/// What is wrong with the arithmetic of this thread, if anything: every bound in rigor holds for rounding to nearest
/// with subnormal numbers. A library loaded with us can have changed that (one linked with -ffast-math sets flush to
/// zero as it is loaded).
inline std::optional<Fault> float_environment_fault() {
  if (std::fegetround() != FE_TONEAREST)
    return Fault{Fault::Kind::unsupported, "floating point", "does not round to nearest, as every bound here requires"};
  volatile double smallest = std::numeric_limits<double>::min();
  volatile double half = smallest / 2;  // a product of constants would be the compiler's, not the processor's
  if (half == 0 || half * 2 != smallest)
    return Fault{Fault::Kind::unsupported, "floating point", "flushes subnormal numbers to zero (a library built with -ffast-math?)"};
  return std::nullopt;
}

}  // namespace rigor
