#include <gtest/gtest.h>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include <rigor/base/float_environment.hpp>

namespace rigor {
namespace {

// case S-09
TEST(FloatEnvironment, IsRefusedWhenItDoesNotRoundToNearest) {
  EXPECT_FALSE(float_environment_fault());
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const auto fault = float_environment_fault();
    std::fesetround(FE_TONEAREST);
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->kind, Fault::Kind::unsupported);
  }
}

#if defined(__SSE2__)
TEST(FloatEnvironment, IsRefusedWhenSubnormalNumbersAreFlushed) {
  const unsigned before = _mm_getcsr();
  for (const unsigned bit : {0x8000u, 0x0040u}) {  // results to zero; operands as zero
    _mm_setcsr(before | bit);
    const auto fault = float_environment_fault();
    _mm_setcsr(before);
    EXPECT_TRUE(fault) << bit;
  }
}
#endif

}  // namespace
}  // namespace rigor
