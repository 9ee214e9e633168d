// The worked example of docs/adding-a-check.md: this program is built with docs/examples/own.cpp in place of
// src/grader/own.cpp, and nothing else is changed.
#include <gtest/gtest.h>

#include <rigor/grader/audit.hpp>
#include <rigor/grader/misconceptions.hpp>
#include <tests/grader/build_samples.hpp>

namespace rigor::grader {
namespace {

Report graded(const Submission& submission) {
  Rubric rubric;
  rubric.cases = 12;
  const auto report = grade(submission, rubric, {}, {});
  EXPECT_TRUE(report);
  return *report;
}
const CheckResult& result(const Report& report, const std::string& id) {
  return *std::find_if(report.results.begin(), report.results.end(), [&](const CheckResult& r) { return r.check->id == id; });
}
Submission right() { return *open_submission(samples() / "right" / "expressions"); }

TEST(OwnExample, IsInTheListsOfTheJudge) {
  ASSERT_NE(find_check("update.free-flight"), nullptr);
  ASSERT_NE(find_misconception("update.gravity-built-in"), nullptr);
  for (int k = 0; k < 12; ++k) EXPECT_TRUE(admitted(*find_check("update.free-flight"), draw_case(*find_check("update.free-flight"), 7, k)));
}

TEST(OwnExample, PassesARightSubmission) {
  const Report report = graded(right());
  EXPECT_EQ(report.score, 102) << report_text(report, false);
  EXPECT_EQ(result(report, "update.free-flight").verdict, Verdict::pass);
}

TEST(OwnExample, FailsAndNamesAStudentWhoMakesTheMistake) {
  Submission wrong = right();
  for (SourceFile& file : wrong.files)
    if (file.name == "Cuboid.cpp") {
      const std::string head = "void Cuboid::update(double delta) {";
      ASSERT_NE(file.text.find(head), file.text.npos);
      file.text.insert(file.text.find(head) + head.size(), "\n  linearVelocity[1] -= 9.8 * delta;");
    }
  wrong.hash += "/gravity";
  const Report report = graded(wrong);
  const CheckResult& own = result(report, "update.free-flight");
  EXPECT_EQ(own.verdict, Verdict::fail);
  ASSERT_EQ(own.diagnosis.size(), 1u) << report_text(report, false);
  EXPECT_EQ(own.diagnosis[0].id, "update.gravity-built-in");
  EXPECT_EQ(own.diagnosis[0].agreements, own.diagnosis[0].cases);
}

// The audit of the judge holds with the two added: the new mistake is told from every other.
TEST(OwnExample, HoldsInTheAudit) {
  const Audit result = audit({model_auditee("update.gravity-built-in"), model_auditee("update.velocity-stays"), model_auditee("update.keeps-force")}, {model_auditee("rows")}, {2, 12, 1});
  EXPECT_EQ(result.failed(), 3) << audit_text(result);
  EXPECT_EQ(result.named_right(), 3) << audit_text(result);
}

}  // namespace
}  // namespace rigor::grader
