// Which part of the work each thread does, and with which instructions.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <mutex>
#include <rigor/engine/shares.hpp>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace rigor {
namespace {

using Parts = std::vector<std::pair<long, long>>;

// Keeps the parts it is called with; its copy number `last_copy` + 1 cannot be made, as a thread that there is no more room for.
struct Recorder {
  Parts* parts;
  std::mutex* lock;
  int* copies;
  int last_copy;
  Recorder(Parts* p, std::mutex* l, int* c, int last) : parts(p), lock(l), copies(c), last_copy(last) {}
  Recorder(const Recorder& other) : Recorder(other.parts, other.lock, other.copies, other.last_copy) {
    if (++*copies > last_copy) throw std::runtime_error("no more");
  }
  void operator()(long first, long last) const {
    const std::lock_guard guard(*lock);
    parts->push_back({first, last});
  }
};
Parts parts_of(long count, unsigned threads, int last_copy = 1000) {
  Parts parts;
  std::mutex lock;
  int copies = 0;
  detail::in_shares(count, threads, Recorder(&parts, &lock, &copies, last_copy));
  std::sort(parts.begin(), parts.end());
  return parts;
}

TEST(Shares, AreEvenPartsThatCoverAll) {
  EXPECT_EQ(parts_of(10, 1), (Parts{{0, 10}}));
  EXPECT_EQ(parts_of(10, 2), (Parts{{0, 5}, {5, 10}}));
  EXPECT_EQ(parts_of(10, 3), (Parts{{0, 3}, {3, 6}, {6, 10}}));
  EXPECT_EQ(parts_of(7, 4), (Parts{{0, 1}, {1, 3}, {3, 5}, {5, 7}}));
  EXPECT_EQ(parts_of(2, 5), (Parts{{0, 1}, {1, 2}})) << "no thread without work";
  EXPECT_EQ(parts_of(0, 3), (Parts{{0, 0}}));
}

// One thread is had, the next is not: the caller's own part, and then all that is left in one.
TEST(Shares, OfThreadsNotToBeHadAreDoneHere) {
  EXPECT_EQ(parts_of(20, 5, 1), (Parts{{0, 4}, {4, 8}, {8, 20}}));
  EXPECT_EQ(parts_of(20, 5, 0), (Parts{{0, 4}, {4, 20}}));
}

int one() { return 1; }
int two() { return 2; }
int three() { return 3; }

TEST(Shares, AreCompiledForTheInstructionsAskedFor) {
  const detail::Compiled<int()> function{one, two, three};
  EXPECT_EQ(detail::compiled_for(Instructions::baseline, function)(), 1);
  EXPECT_EQ(detail::compiled_for(Instructions::avx2, function)(), 2);
  EXPECT_EQ(detail::compiled_for(Instructions::avx512, function)(), 3);
}

// Every set of flags: what a processor lacks is never used on it.
TEST(Instructions, AskForAllTheFlagsTheyNeed) {
  for (int set = 0; set < 32; ++set) {
    const auto found = instructions_of({bool(set & 1), bool(set & 2), bool(set & 4), bool(set & 8), bool(set & 16)});
    const std::size_t want = set == 31 ? 3 : (set & 3) == 3 ? 2 : 1;
    ASSERT_EQ(found.size(), want) << set;
    for (std::size_t i = 0; i < want; ++i) EXPECT_EQ(int(found[i]), int(i)) << set;
  }
}

// The processor's own list, as the system reads it.
TEST(Instructions, AreThoseTheSystemSaysTheProcessorHas) {
  std::ifstream file("/proc/cpuinfo");
  std::set<std::string> flags;
  for (std::string line; flags.empty() && std::getline(file, line);)
    if (line.starts_with("flags")) {
      std::istringstream words(line);
      for (std::string word; words >> word;) flags.insert(word);
    }
  if (flags.empty()) GTEST_SKIP() << "no list of an x86 processor's flags";
  const bool avx2 = flags.contains("avx2") && flags.contains("fma");
  const bool avx512 = avx2 && flags.contains("avx512f") && flags.contains("avx512dq") && flags.contains("avx512vl");
  std::vector<Instructions> want{Instructions::baseline};
  if (avx2) want.push_back(Instructions::avx2);
  if (avx512) want.push_back(Instructions::avx512);
  EXPECT_EQ(supported_instructions(), want);
  EXPECT_EQ(widest_instructions(), want.back());
}

}  // namespace
}  // namespace rigor
