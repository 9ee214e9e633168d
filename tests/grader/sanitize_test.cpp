// --sanitize: the first thing undefined in a submission, said as advice.
#include <gtest/gtest.h>

#include <rigor/grader/judge.hpp>
#include <rigor/grader/sanitize.hpp>
#include <tests/grader/build_samples.hpp>

namespace rigor::grader {
namespace {

TEST(Sanitizers, AreReadForTheFirstFindingInTheSubmission) {
  const std::vector<std::string> files{"Cuboid.cpp", "Cuboid.h"};
  EXPECT_EQ(sanitizer_finding("Cuboid.cpp:41:12: runtime error: index 3 out of bounds for type 'double [3]'\n", files), "Cuboid.cpp:41: index 3 out of bounds for type 'double [3]'");
  EXPECT_EQ(sanitizer_finding("hello\n==3==ERROR: AddressSanitizer: heap-buffer-overflow on address 0x6\nREAD of size 8\n"
                              "    #0 0x55 in __interceptor_memcpy ../asan.cpp:22\n    #1 0x55 in Cuboid::update(double) /tmp/src/Cuboid.cpp:88\n", files),
            "Cuboid.cpp:88: heap-buffer-overflow");
  EXPECT_EQ(sanitizer_finding("", files), "");
  EXPECT_EQ(sanitizer_finding("driver.cpp:3:1: runtime error: member call on null\n", files), "") << "not the student's";
  EXPECT_EQ(sanitizer_finding("a student prints ERROR: nothing at Cuboid.cpp:3\n", files), "");
}

std::string advice_on(const std::string& line) {
  Submission s = *open_submission(samples() / "right" / "expressions");
  for (SourceFile& file : s.files)
    if (file.name == "Cuboid.cpp") {
      const std::string head = "void Cuboid::update(double delta) {";
      file.text.insert(file.text.find(head) + head.size(), line);  // on the line of the head
    }
  s.hash += line;
  Rubric rubric;
  rubric.cases = 4;
  BuildOptions options;
  options.sanitize = true;
  const auto report = grade(s, rubric, {{"force.sum"}, -1}, options);
  EXPECT_TRUE(report);
  EXPECT_EQ(report->score, 4) << "advice takes no points";
  return report->notes.back();
}

TEST(Sanitizers, FindWhatIsUndefinedAndTakeNoPoints) {
  EXPECT_EQ(advice_on(""), "sanitizers (advice, no points): nothing found in 4 cases of every check");
  const std::string index = advice_on(" double a[3] = {0, 0, 0}; int k = 3; if (delta > 0) a[k] = delta; netForce[0] += a[k] * 0;");
  EXPECT_NE(index.find("Cuboid.cpp:"), index.npos) << index;
  EXPECT_NE(index.find("index 3 out of bounds"), index.npos) << index;
  const std::string heap = advice_on(" double* a = new double[3](); netForce[0] += 0 * a[3 + (delta > 100)]; delete[] a;");
  EXPECT_NE(heap.find("Cuboid.cpp:"), heap.npos) << heap;
  EXPECT_TRUE(heap.find("heap-buffer-overflow") != heap.npos || heap.find("insufficient space") != heap.npos) << "either sanitizer may be first: " << heap;
}

}  // namespace
}  // namespace rigor::grader
