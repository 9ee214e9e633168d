// The suite tried on every misconception, compiled and run as submissions are, and on every right way we know.
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <rigor/grader/audit.hpp>
#include <rigor/grader/misconceptions.hpp>
#include <tests/grader/build_samples.hpp>

namespace rigor::grader {
namespace {

std::vector<std::string> ids_of(const std::vector<Misconception>& list) {
  std::vector<std::string> ids;
  for (const Misconception& m : list) ids.push_back(m.id);
  return ids;
}
Submission switched() { return *open_submission(samples() / "audit" / "switched"); }

// Every third misconception and reading by default, all of them with RIGOR_ALL=1.
std::vector<std::string> sampled(std::vector<std::string> ids) {
  if (std::getenv("RIGOR_ALL") != nullptr) return ids;
  std::vector<std::string> some;
  for (std::size_t i = 0; i < ids.size(); i += 3) some.push_back(ids[i]);
  return some;
}

TEST(CompiledAudit, FailsAndNamesEveryMisconceptionAndPassesEveryRightSubmission) {
  const auto wrong = switched_auditees(switched(), sampled(ids_of(misconceptions())));
  const auto readings = switched_auditees(switched(), sampled(ids_of(variants())));
  ASSERT_TRUE(wrong && readings);
  std::vector<Auditee> right = *readings;
  for (const std::string& name : samples_in("right")) right.push_back(*compiled_auditee(*open_submission(samples() / "right" / name)));
  const Audit result = audit(*wrong, right, {1, 16, 2});
  EXPECT_GE(misconceptions().size(), 60u);
  EXPECT_GE(samples_in("right").size(), 12u);
  EXPECT_EQ(result.misconceptions.size(), wrong->size());
  EXPECT_EQ(result.variants.size(), right.size());
  for (const AuditRow& row : result.misconceptions) {
    EXPECT_TRUE(row.failed) << row.id;
    EXPECT_TRUE(row.named_right) << row.id;
    EXPECT_FALSE(row.named_wrong()) << row.id;
  }
  EXPECT_EQ(result.right_full_marks(), int(right.size())) << audit_text(result);
  EXPECT_TRUE(result.holds());
}

// The compiled student and the judge's model student are two people's code: where they agree on every misconception, a
// name is given for the student's mistake and not for an accident of the model.
TEST(ModelAudit, FailsEveryMisconceptionNamesItAndPassesEveryReading) {
  std::vector<Auditee> wrong, right;
  for (const std::string& id : ids_of(misconceptions())) wrong.push_back(model_auditee(id));
  for (const std::string& id : ids_of(variants())) right.push_back(model_auditee(id));
  const Audit result = audit(wrong, right, {1, 24, 2});
  EXPECT_TRUE(result.holds()) << audit_text(result);
  EXPECT_EQ(result.named_right(), int(wrong.size())) << audit_text(result);
}

TEST(CompiledAudit, NamesAClassOfMistakesThatAreOneFunctionByOneName) {
  const auto wrong = switched_auditees(switched(), {"moi.double-extents", "pair.relative-reversed", "plane.velocity-reversed"});
  ASSERT_TRUE(wrong);
  const auto json = nlohmann::json::parse(audit_json(audit(*wrong, {}, {1, 8, 1})));
  EXPECT_EQ(json["classes"]["moi.third"], nlohmann::json({"moi.double-extents"}));
  EXPECT_EQ(json["classes"]["pair.signs-reversed"], nlohmann::json({"pair.relative-reversed"}));
  EXPECT_EQ(json["classes"]["plane.normal-sign"], nlohmann::json({"plane.velocity-reversed"}));
  EXPECT_EQ(json["named_right"], 3);
  EXPECT_TRUE(json["confusion"].empty()) << json["confusion"];
}

// Two mistakes in one function, in a real submission: named together.
TEST(CompiledAudit, NamesPairs) {
  for (const std::string pair : {"update.no-gyroscopic+update.keeps-force", "force.torque-reversed+force.overwritten", "pair.restitution-one+pair.first-only"}) {
    const auto students = switched_auditees(switched(), {pair});
    ASSERT_TRUE(students);
    const Audit result = audit(*students, {}, {1, 16, 1});
    ASSERT_EQ(result.misconceptions.size(), 1u);
    EXPECT_TRUE(result.misconceptions[0].named_right) << pair << " " << audit_text(result);
  }
}

// An audit that could not fail would prove nothing: somebody right under a misconception's name, and somebody wrong
// under a reading's.
TEST(Audit, NoticesAMistakeThatPassesAWrongNameAndAReadingThatFails) {
  Auditee impostor = model_auditee("");
  impostor.id = "update.no-gyroscopic";
  Auditee misnamed = model_auditee("force.torque-reversed");
  misnamed.id = "force.reversed";
  Auditee failing = model_auditee("pair.no-spin");
  failing.id = "rows";
  const Audit result = audit({impostor, misnamed}, {failing}, {1, 8, 1});
  EXPECT_FALSE(result.holds());
  EXPECT_EQ(result.failed(), 0) << "the second passes the checks that claim what it is called";
  EXPECT_EQ(result.named_wrong(), 1);
  EXPECT_EQ(result.right_full_marks(), 0);
  const auto json = nlohmann::json::parse(audit_json(result));
  for (const char* key : {"misconceptions", "failed", "named_right", "named_wrong", "right_variants", "right_full_marks", "table"}) EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_EQ(json["confusion"].size(), 2u) << json["confusion"];
}

}  // namespace
}  // namespace rigor::grader
