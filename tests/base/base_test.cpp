#include <gtest/gtest.h>

#include <atomic>
#include <rigor/base/file.hpp>
#include <rigor/base/interrupt.hpp>
#include <rigor/base/outcome.hpp>
#include <rigor/base/promise.hpp>
#include <rigor/base/suggest.hpp>
#include <string>
#include <thread>
#include <vector>

namespace rigor {
namespace {

TEST(Suggest, FindsTheNearestWordAndStaysSilentWhenNoneIsNear) {
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);  // the textbook pair
  EXPECT_EQ(edit_distance("drfit", "drift"), 1u) << "two neighbours exchanged";
  EXPECT_EQ(edit_distance("ca", "abc"), 3u) << "an exchanged pair stays as it is: the textbook's difference from the unrestricted distance";
  EXPECT_EQ(did_you_mean("restituton", {"restitution", "gravity"}), " (did you mean 'restitution'?)");
  EXPECT_EQ(did_you_mean("banana", {"restitution", "gravity"}), "");
  EXPECT_EQ(did_you_mean("x", {}), "");
}

TEST(Fault, SeenFromFurtherOutNamesTheWholePath) {
  const Fault fault{Fault::Kind::not_positive, "size[1]", "is -2, must be > 0"};
  EXPECT_EQ(fault.inside("cuboids[2]").text(), "cuboids[2].size[1] is -2, must be > 0");
  EXPECT_EQ((Fault{Fault::Kind::missing, "[3]", "is missing"}).inside("planes").text(),
            "planes[3] is missing");
}

TEST(WriteFile, LeavesTheOldFileWholeWhenItCannotWrite) {
  const auto dir = std::filesystem::temp_directory_path() / ("rigor-base-test-" + std::to_string(::getpid()));
  std::filesystem::create_directories(dir / "taken");
  ASSERT_TRUE(write_file(dir / "a" / "b.txt", "old"));
  EXPECT_EQ(*read_file(dir / "a" / "b.txt"), "old");
  ASSERT_TRUE(write_file(dir / "a" / "b.txt", "new"));
  EXPECT_EQ(*read_file(dir / "a" / "b.txt"), "new");
  const auto refused = write_file(dir / "taken", "x");  // a directory is in the way
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.fault().kind, Fault::Kind::unwritable);
  int entries = 0;
  for (const auto& entry : std::filesystem::directory_iterator(dir)) entries += entry.exists();
  EXPECT_EQ(entries, 2) << "a temporary was left behind";
  EXPECT_EQ(read_file(dir / "none").fault().kind, Fault::Kind::unreadable);
  EXPECT_EQ(read_file("/dev/zero").fault().what, "is not a regular file");
  EXPECT_FALSE(read_file(dir / "a" / "b.txt", 2));
  std::filesystem::remove_all(dir);
}

TEST(WriteFile, IsWholeWhenThreadsWriteItAtOnce) {
  const std::filesystem::path dir = std::filesystem::temp_directory_path() / ("rigor-file-at-once-" + std::to_string(::getpid()));
  std::atomic<int> refused{0};
  {
    std::vector<std::jthread> threads;
    for (const char c : {'a', 'b', 'c', 'd'})
      threads.emplace_back([&, c] {
        for (int k = 0; k < 200; ++k) refused += !write_file(dir / "one.txt", std::string(5000, c));
      });
  }
  EXPECT_EQ(refused, 0);
  const std::string text = *read_file(dir / "one.txt");
  EXPECT_EQ(text, std::string(5000, text[0]));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(dir), {}), 1) << "no temporary is left";
  std::filesystem::remove_all(dir);
}

TEST(Interrupt, IsSeenOnceRaised) {
  EXPECT_EQ(interrupted(), 0);
  catch_interrupts();
  std::raise(SIGINT);
  EXPECT_EQ(interrupted(), SIGINT);
  std::signal(SIGTERM, SIG_DFL);
}

TEST(PromiseDeathTest, PrintsTheSentenceAndAborts) {
  EXPECT_DEATH(promise(1 + 1 == 3, "one and one make three"), "broke its promise: one and one make three");
}

}  // namespace
}  // namespace rigor
