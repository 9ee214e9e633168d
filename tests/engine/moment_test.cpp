// A moment keeps what doubles would lose: against the same sums in 60 digits.
#include <gtest/gtest.h>

#include <reference/precise.hpp>
#include <rigor/engine/located_world.hpp>

namespace rigor {
namespace {

using Long = reference::Precise;
Long exact(const Moment& m) { return Long(m.hi) + Long(m.lo); }

TEST(Moment, OfThousandsOfFlightsLosesNoDigit) {
  Moment m;
  Long want = 0;
  for (int k = 0; k < 20000; ++k) {
    const double tau = 0.1 + 1e-9 * (k % 7);
    m = m.after(tau), want += tau;
  }
  EXPECT_LT(std::fabs(double(exact(m) - want)), 1e-26) << "2e4 roundings of an error of 1e-13";
  EXPECT_GT(std::fabs(m.lo), 0x1p-43) << "half a last digit of 2000 s: not idle";
  EXPECT_EQ(m.value(), double(want));
}

TEST(Moment, IsBeforeAndAfterOthersToTheirLastDigits) {
  const Moment early{1, 3e-17}, late{1.5, -4e-17};
  EXPECT_EQ(early.until(1), -3e-17);
  EXPECT_EQ(late.since(Moment{1.5, 0}), -4e-17);
  EXPECT_EQ(Moment{1.5}.since(late), 4e-17);
  EXPECT_EQ((late.since(early)), 0.5 - 7e-17);
  EXPECT_EQ((Moment{1, 0x1p-51}.value()), 1 + 0x1p-51);
}

}  // namespace
}  // namespace rigor
