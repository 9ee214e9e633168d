#include <gtest/gtest.h>

#include <rigor/cli/progress.hpp>

namespace rigor::cli {
namespace {

TEST(Progress, SaysHowFarAndHowLongStill) {
  EXPECT_EQ(progress_line(12, 100, 30), "[###...........................] 12 of 100, 3:40 left");  // 30/12 x 88 = 220 s
  EXPECT_EQ(progress_line(100, 100, 250), "[" + std::string(30, '#') + "] 100 of 100, 0:00 left");
  EXPECT_LE(progress_line(1000000, 1000000000, 1e6).size(), 80u);
}
TEST(Progress, SaysNothingAboutWorkOfLessThanTwoSeconds) {
  EXPECT_EQ(progress_line(0, 100, 30), "");
  EXPECT_EQ(progress_line(50, 100, 0.99), "");
  EXPECT_NE(progress_line(50, 100, 1.01), "");
}

}  // namespace
}  // namespace rigor::cli
