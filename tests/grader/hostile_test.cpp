// Hostile submissions through the whole grader, in one class with two honest ones.
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <rigor/grader/class_run.hpp>
#include <set>
#include <tests/grader/build_samples.hpp>

namespace rigor::grader {
namespace {

using nlohmann::json;

// The same report whoever else was graded: all but the time it took.
std::string without_time(const fs::path& report_json) {
  json report = json::parse(*read_file(report_json));
  report.erase("seconds");
  return report.dump(1);
}

// A sample of the room, or (./rigor test --all) all of it: some keep a compiler or a timeout busy for ten seconds.
std::vector<std::string> attacks() {
  if (std::getenv("RIGOR_ALL") != nullptr) return samples_in("hostile");
  return {"answers-nan", "changes-the-constants", "closes-everything", "forges-a-reply", "interposes-the-library", "kills-its-parent", "leaves-a-child",
          "own-entry",   "prints-a-score",        "sleeps",            "strange-names",  "throws",                 "traces-its-parent", "writes-everywhere"};
}

TEST(HostileClass, GainsNothingAndChangesNoNeighboursReport) {
  const Directory dir;
  Rubric rubric;
  rubric.cases = 4;
  rubric.limits.call_s = 0.1;
  std::vector<Entry> honest, all;
  for (const std::string name : {"right/expressions", "wrong/torque-kept"}) honest.push_back({name, {samples() / name}, 0, 1, false});
  for (const std::string& name : attacks()) all.push_back({"hostile/" + name, {samples() / "hostile" / name}, 0, 1, false});
  all.insert(all.begin(), honest[0]);
  all.push_back(honest[1]);

  ClassOptions options;
  options.out = dir.path / "alone";
  options.tool = "test";
  const auto alone = grade_class(honest, rubric, options);
  ASSERT_EQ(alone[0].score, 100);
  ASSERT_EQ(alone[1].score, 98);
  options.out = dir.path / "together";
  options.jobs = 2;
  const auto rows = grade_class(all, rubric, options);

  const std::set<std::string> vocabulary{"pass", "fail", "crash", "timeout", "memory", "not-compiled", "not-implemented", "skipped"};
  for (const ClassRow& row : rows) {
    EXPECT_EQ(row.trouble, "") << row.entry.student;
    for (const auto& [id, verdict] : row.verdicts) EXPECT_TRUE(vocabulary.contains(verdict)) << row.entry.student << " " << id << " " << verdict;
    if (!row.entry.student.starts_with("hostile/")) continue;
    EXPECT_EQ(row.score, 0) << row.entry.student << ": every other function is as handed out";
    const fs::path reports = options.out / safe_name(row.entry.student);
    const std::string html = *read_file(reports / "report.html"), text = *read_file(reports / "report.txt");
    for (const char* spoken : {"<script>alert", "<b>", "<img", "onerror=\"", "\x1b"}) EXPECT_EQ(html.find(spoken), html.npos) << row.entry.student << ": " << spoken;
    EXPECT_EQ(text.find('\x1b'), text.npos) << row.entry.student;
    for (const char* sign : {"STOLEN", "root:"}) EXPECT_EQ(text.find(sign), text.npos) << row.entry.student;
  }
  for (const Entry& entry : honest) {
    const std::string name = safe_name(entry.student) + "/report.json";
    EXPECT_TRUE(without_time(dir.path / "alone" / name) == without_time(dir.path / "together" / name)) << entry.student;
  }
}

// Every function sleeps for an hour: each is asked twice and then once a check, within 40 call_seconds.
TEST(HostileClass, ThatOnlySleepsIsGivenUpOn) {
  const Directory dir;
  for (const std::string name : {"Cuboid.cpp", "CollisionPlane.cpp", "ParticleSystem.cpp"}) {
    std::string text = *read_file(samples() / "right" / "expressions" / name);
    for (const std::string function : {"applyForce(P3D worldPosition, V3D force) {", "::update(double delta) {", "computeWorldCoordsMOI() {", "computeWorldCoordsInverseMOI() {",
                                       "frictionTangent(Cuboid &c, P3D &p) {", "applyCollisionResponse(Cuboid &c) {", "V3D &collisionNormal) {"})
      if (const std::size_t at = text.find(function); at != text.npos) text.insert(at + function.size(), " for (;;) sleep(3600);");
    dir.write(name, "#include <unistd.h>\n" + text);
  }
  Rubric rubric;
  rubric.limits.call_s = 0.05;
  const auto report = grade(*open_submission(dir.path), rubric, {}, {});
  ASSERT_TRUE(report);
  EXPECT_EQ(report->score, 6) << "moi.body and its inverse are all that answers";
  int asked = 0;
  for (const CheckResult& r : report->results) {
    if (r.check->function == StudentFunction::body_inertia) continue;
    if (r.max_points > 0) {
      EXPECT_EQ(r.verdict, Verdict::timeout) << r.check->id;
    }
    asked += r.cases;
    EXPECT_LE(r.cases, 3) << r.check->id;
  }
  EXPECT_LE(asked, 60);
}

}  // namespace
}  // namespace rigor::grader
