// The judge against the model student: no process is started, so a whole class of students costs a second.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <rigor/grader/judge.hpp>
#include <rigor/grader/misconceptions.hpp>
#include <set>
#include <thread>

namespace rigor::grader {
namespace {

const std::array<FunctionStatus, student_functions> all_there{};
using Ids = std::set<std::string>;

Answer model(const Habits& habits, const Call& call) { return model_answer(habits, call.constants, call.request); }

Report judged(const Student& student, int cases, std::uint64_t seed, Rubric rubric = {}, const Selection& selection = {}) {
  rubric.cases = cases;
  rubric.seed = seed;
  Report report;
  report.submission = "model";
  judge(student, all_there, rubric, selection, report);
  return report;
}
Report judged(const std::string& habits, int cases, std::uint64_t seed, const Rubric& rubric = {}) {
  const Habits h = habits_with(habits);
  return judged([h](const Call& call) { return model(h, call); }, cases, seed, rubric);
}
Ids failing(const Report& report) {
  Ids ids;
  for (const CheckResult& r : report.results)
    if (r.verdict != Verdict::pass && r.max_points > 0) ids.insert(r.check->id);
  return ids;
}
Ids named(const Report& report) {
  Ids ids;
  for (const CheckResult& r : report.results)
    for (const Diagnosis& d : r.diagnosis)
      if (r.max_points > 0) ids.insert(d.id);
  return ids;
}

TEST(Checks, AddUpToAHundredPointsInTheSixPartsOfTheAssignment) {
  std::map<std::string, double> parts;
  Ids ids;
  for (const Check& check : checks()) {
    parts[check.group] += check.points;
    EXPECT_TRUE(ids.insert(check.id).second) << check.id;
  }
  EXPECT_EQ(parts, (std::map<std::string, double>{
                       {"Inertia", 15}, {"Force", 10}, {"Dynamics", 30}, {"Plane normal", 15}, {"Friction", 15}, {"Pair", 15}, {"Scene", 0}}));
}

TEST(Checks, CasesAreTheSameForTheSameSeedAndOthersForAnother) {
  for (const Check& check : checks()) {
    const Scenario a = draw_case(check, 1, 3), b = draw_case(check, 1, 3), c = draw_case(check, 2, 3);
    EXPECT_EQ(a.A.size, b.A.size) << check.id;
    EXPECT_EQ(a.A.position, b.A.position) << check.id;
    if (check.id != "scene.runs") {
      EXPECT_NE(a.A.size, c.A.size) << check.id;
    }
  }
}

// An admitted input shows every claimed mistake by 20 bounds, so that no wrong answer passes by luck of the draw.
TEST(Checks, EveryAdmittedInputShowsEveryMistakeClaimed) {
  for (const Check& check : checks())
    for (int k = 0; k < 12; ++k) EXPECT_TRUE(admitted(check, draw_case(check, 99, k))) << check.id;
}

TEST(Judge, GivesTheRightStudentFullMarksAtAnySeed) {
  for (const std::uint64_t seed : {1u, 2u, 3u, 20260414u}) EXPECT_EQ(judged("", 60, seed).score, 100) << seed;
}

TEST(Judge, GivesEveryLegitimateReadingFullMarks) {
  for (const Misconception& variant : variants()) {
    const Report report = judged(variant.id, 40, 5);
    EXPECT_EQ(report.score, 100) << variant.id << " failed " << *failing(report).begin();
  }
}

TEST(Judge, NamesTheReadingItSaw) {
  const auto notes = [](const Report& report) {
    Ids all;
    for (const CheckResult& r : report.results) all.insert(r.notes.begin(), r.notes.end());
    return all;
  };
  EXPECT_EQ(notes(judged("friction-literal", 16, 5)).count("literal friction rule: every slip slides"), 1u);
  EXPECT_EQ(notes(judged("tangent-against-slip", 16, 5)).count("tangent against the slip"), 1u);
  EXPECT_EQ(notes(judged("explicit-position+exponential", 16, 5)).count("scheme: explicit-position+exponential"), 1u);
  EXPECT_EQ(notes(judged("correction-each-corner", 16, 5)).count(find_misconception("correction-each-corner")->text), 1u);
  EXPECT_TRUE(notes(judged("", 16, 5)).empty());
}

TEST(Judge, ChargesAMistakeOnce) {
  EXPECT_EQ(failing(judged("world-inverse.transposed", 24, 3)), Ids{"moi.world-inverse"});
  EXPECT_EQ(failing(judged("tangent.not-normalised", 24, 3)), (Ids{"tangent.slip", "tangent.force"}));
}

Report judged_with(const std::function<void(Habits&)>& set, int cases = 24) {
  Habits habits;
  set(habits);
  return judged([habits](const Call& call) { return model(habits, call); }, cases, 3);
}
// Relative velocity as the sum of both: what the first body does is turned round before the impulse is found.
Reply with_summed_velocities(const Call& call, bool spins = true) {
  Request turned = call.request;
  for (int i = 0; i < 3; ++i) turned.A.velocity[i] *= -1, turned.A.spin[i] *= -1;
  Reply r = model_answer({}, call.constants, turned);
  for (int i = 0; i < 3; ++i) r.A.velocity[i] += 2 * call.request.A.velocity[i], r.A.spin[i] += 2 * call.request.A.spin[i];
  for (int i = 0; i < 3 && !spins; ++i) r.A.spin[i] = call.request.A.spin[i], r.B.spin[i] = call.request.B.spin[i];
  return r;
}

// A mistake that is on no list: what is right given it passes.
TEST(Judge, ChargesAnUnknownMistakeOnce) {
  EXPECT_EQ(failing(judged_with([](Habits& h) { h.accelerate_factor = 0.5; })), Ids{"update.linear"});
  EXPECT_EQ(failing(judged_with([](Habits& h) { h.spin_up_factor = 1.2; })), (Ids{"update.torque", "update.torque-turned", "update.gyroscopic", "update.gyroscopic-turned"}));
  EXPECT_EQ(failing(judged_with([](Habits& h) { h.correction_factor = 0.3; })), (Ids{"plane.correction", "plane.correction-several"}));
  EXPECT_EQ(failing(judged_with([](Habits& h) { h.correction_factor = 0.3, h.contact_before_push = true; })), (Ids{"plane.correction", "plane.correction-several"}));
  EXPECT_EQ(failing(judged_with([](Habits& h) { h.plane.sign = 0.7; })), (Ids{"plane.restitution", "plane.impulse", "plane.impulse-turned"}));
  const auto pair = [](const Call& call) -> Answer {
    return call.request.function == std::uint32_t(Function::pair_response) ? with_summed_velocities(call) : model_answer({}, call.constants, call.request);
  };
  EXPECT_EQ(failing(judged(pair, 24, 3)), (Ids{"pair.restitution", "pair.impulse", "pair.impulse-turned"}));
}
// 1/12 in whole numbers is 0: its inverse is not finite, however it is made, but not left out.
TEST(Judge, ChargesATensorOfZeroOnce) {
  const auto student = [](double inverse) {
    return [inverse](const Call& call) -> Answer {
      Reply r = model_answer({}, call.constants, call.request);
      if (call.request.function != std::uint32_t(Function::body_inertia)) return r;
      for (double& x : r.A.body_inertia) x = 0;
      for (int i = 0; i < 9; ++i) r.A.body_inverse_inertia[i] = i % 4 == 0 ? inverse : 0;
      return r;
    };
  };
  for (const double inverse : {double(INFINITY), double(NAN)}) EXPECT_EQ(failing(judged(student(inverse), 24, 3)), Ids{"moi.body"});
  for (const double inverse : {0.0, 1.0}) EXPECT_EQ(failing(judged(student(inverse), 24, 3)), (Ids{"moi.body", "moi.body-inverse"}));
}
// Nothing passes for free: a second mistake beside one that is carried forward fails its own checks.
TEST(Judge, CarriesNoSecondMistakeForward) {
  const auto fails = [](const Report& report, const Ids& ids) {
    const Ids failed = failing(report);
    return std::includes(failed.begin(), failed.end(), ids.begin(), ids.end());
  };
  for (const double factor : {0.0, -1.0}) EXPECT_TRUE(fails(judged_with([=](Habits& h) { h.correction_factor = factor; }), {"plane.any-orientation"})) << factor;
  EXPECT_TRUE(fails(judged_with([](Habits& h) { h.keep_velocity = 0.99; }), {"update.convergence"}));
  EXPECT_TRUE(fails(judged_with([](Habits& h) { h.keep_spin = 0.9; }), {"update.convergence"}));
  EXPECT_TRUE(fails(judged_with([](Habits& h) { h.dt_power_rotation = 2; }), {"update.convergence"}));
  EXPECT_TRUE(fails(judged_with([](Habits& h) { h.dt_power_velocity = 0; }), {"update.convergence"}));
  const Ids friction{"plane.friction-limit", "plane.friction-slide", "plane.friction-stick"};
  for (const auto& set : std::vector<std::function<void(Habits&)>>{[](Habits& h) { h.friction = Habits::Friction::none; }, [](Habits& h) { h.friction_sign = -1; }, [](Habits& h) { h.friction_turns = false; },
                                                                  [](Habits& h) { h.friction_moves = false; }})
    for (const double impulse : {0.8, 1.2})
      for (const double push : {0.3, 0.9})
        EXPECT_TRUE(fails(judged_with([&](Habits& h) { set(h), h.plane.sign = impulse, h.correction_factor = push; }), friction));
  EXPECT_TRUE(fails(judged_with([](Habits& h) { h.spin_up_factor = 1.2, h.turn_factor = -1; }), {"update.rotation"}));
  EXPECT_TRUE(fails(judged([](const Call& call) -> Answer { return call.request.function == std::uint32_t(Function::pair_response) ? with_summed_velocities(call, false) : model_answer({}, call.constants, call.request); }, 24, 3),
                    {"pair.impulse-turned", "pair.angular-momentum"}));
}

TEST(Judge, NamesTheSchemeOnlyWhereVelocityAndSpinAreThoseOfOneStep) {
  for (const double factor : {0.0, 0.5, 2.0}) {
    const Report report = judged_with([=](Habits& h) { h.accelerate_factor = factor; }, 8);
    for (const CheckResult& r : report.results)
      if (r.check->id == "update.order") {
        EXPECT_TRUE(r.notes.empty()) << r.notes.front();
      }
  }
}

TEST(Judge, NamesTwoMistakesOfOneFunctionTogether) {
  EXPECT_EQ(named(judged("update.keeps-force+update.no-gyroscopic", 24, 3)), Ids{"update.no-gyroscopic+update.keeps-force"});
}

// What says why a check fails is the evidence of others too: a check run alone, or one case of it, gets the same answer.
TEST(Judge, SaysOfACheckRunAloneWhatItSaysOfAll) {
  const auto ids_of = [](const CheckResult& r) {
    std::vector<std::string> ids;
    for (const Diagnosis& d : r.diagnosis) ids.push_back(d.id + ": " + d.text);
    return ids;
  };
  int failed = 0, given_others = 0;
  std::vector<std::string> mistakes{"world-inverse.transposed", "tangent.not-normalised"};
  for (std::size_t k = 0; k < misconceptions().size(); k += 10) mistakes.push_back(misconceptions()[k].id);
  for (const std::string& mistake : mistakes) {
    const Habits habits = habits_with(mistake);
    const Student student = [&](const Call& call) { return model(habits, call); };
    for (const CheckResult& all : judged(student, 6, 3).results) {
      if (all.max_points == 0) continue;
      given_others += all.verdict == Verdict::pass && !all.notes.empty();
      std::vector<Selection> alone{{{all.check->id}, -1}};
      if (all.counterexample) alone.push_back({{all.check->id}, all.counterexample->number});
      failed += all.verdict == Verdict::fail;
      for (const Selection& selection : alone) {
        const Report report = judged(student, 6, 3, {}, selection);
        ASSERT_EQ(report.results.size(), 1u);
        EXPECT_EQ(report.results[0].verdict, all.verdict) << mistake << ", " << all.check->id << ", case " << selection.single_case;
        EXPECT_EQ(ids_of(report.results[0]), ids_of(all)) << mistake << ", " << all.check->id << ", case " << selection.single_case;
        EXPECT_EQ(report.score, all.points);
      }
    }
  }
  EXPECT_GT(failed, 20);
  EXPECT_GT(given_others, 0) << "right given a mistake made elsewhere";
}

TEST(Judge, InventsNothingForAMistakeItDoesNotKnow) {
  const Report report = judged(
      [](const Call& call) -> Answer {
        Reply r = model_answer(Habits{}, call.constants, call.request);
        if (call.request.function != std::uint32_t(Function::pair_response)) return r;
        for (int i = 0; i < 3; ++i) r.A.velocity[i] += 0.3 * std::sin(r.A.position[(i + 1) % 3]);
        return r;
      },
      24, 3);
  EXPECT_TRUE(named(report).empty());
  EXPECT_EQ(failing(report).count("pair.impulse"), 1u);
}

TEST(Judge, FindsAConstantFactor) {
  const Report report = judged(
      [](const Call& call) -> Answer {
        Reply r = model_answer(Habits{}, call.constants, call.request);
        for (double& x : r.A.body_inertia) x *= 0.3;
        return r;
      },
      24, 3, {}, {{"moi.body"}, -1});
  ASSERT_EQ(report.results.size(), 1u);
  ASSERT_EQ(report.results[0].diagnosis.size(), 1u);
  EXPECT_EQ(report.results[0].diagnosis[0].text, "the result is 0.3 times the right one, always");
}

// Right in single precision, judged 100 times as strictly: that is rounding, with how much of it, and both numbers.
TEST(Judge, SaysThatAnAnswerIsRightButForRounding) {
  Rubric rubric;
  rubric.tolerance = 0.01;
  const Report report = judged(
      [](const Call& call) -> Answer {
        Reply r = model_answer(Habits{}, call.constants, call.request);
        for (double& x : r.A.body_inertia) x = x * (1 + 1e-6);
        return r;
      },
      24, 3, rubric, {{"moi.body"}, -1});
  const CheckResult& r = report.results[0];
  EXPECT_EQ(r.verdict, Verdict::fail);
  ASSERT_EQ(r.diagnosis.size(), 1u);
  EXPECT_EQ(r.diagnosis[0].text, "right but for rounding: 10 times the allowed error");
  ASSERT_TRUE(r.counterexample);
  EXPECT_GT(r.counterexample->judgement.ratio(), 1) << "the bound of the case is the rubric's";
  EXPECT_NE(report_text(report, false).find("got            want"), std::string::npos);
}

TEST(Judge, StopsACheckAfterThreeDeathsAndGoesOnWithTheNext) {
  int calls = 0;
  const Report report = judged(
      [&](const Call& call) -> Answer {
        if (call.request.function == std::uint32_t(Function::apply_force)) return ++calls, Death{Death::Kind::crash, "stopped by a segmentation fault"};
        return model(Habits{}, call);
      },
      24, 3, {}, {{"force.sum", "moi.body"}, -1});
  ASSERT_EQ(report.results.size(), 2u);
  EXPECT_EQ(report.results[0].verdict, Verdict::pass);
  EXPECT_EQ(report.results[1].verdict, Verdict::crash);
  EXPECT_EQ(report.results[1].cases, 3);
  EXPECT_GE(calls, 3);  // and a few more to make the case small
}

// One more case after a first timeout, then one for each later check of that function; other functions are untouched.
TEST(Judge, AsksAFunctionThatTimedOutOnceMoreAndThenOnceACheck) {
  int calls = 0;
  const auto student = [&](const Call& call) -> Answer {
    if (call.request.function != std::uint32_t(Function::apply_force)) return model({}, call);
    ++calls;
    return Death{Death::Kind::timeout, "took longer than 0.5 s for one call"};
  };
  const Report report = judged(student, 50, 1);
  EXPECT_EQ(calls, 2 + 2) << "three checks of the function";
  EXPECT_EQ(failing(report), (Ids{"force.sum", "force.torque", "force.pure"}));
  EXPECT_EQ(report.score, 90);
}

// What the calls of one function may take in all is 40 call_seconds, here 0.4 s, seven of its calls. Nobody else pays.
TEST(Judge, StopsASlowFunctionAndNoOther) {
  int slow = 0;
  const auto student = [&](const Call& call) -> Answer {
    Answer answer = model({}, call);
    const bool force = call.request.function == std::uint32_t(Function::apply_force);
    if (force) ++slow;
    answer.seconds = force ? 0.0625 : 0.0002;
    return answer;
  };
  Rubric rubric;
  rubric.limits.call_s = 0.01;
  const Report report = judged(student, 50, 1, rubric);
  EXPECT_EQ(slow, 7);
  EXPECT_EQ(failing(report), (Ids{"force.sum", "force.torque", "force.pure"}));
  for (const CheckResult& r : report.results)
    if (r.check->function == StudentFunction::apply_force) {
      EXPECT_EQ(r.verdict, Verdict::timeout);
      EXPECT_NE(r.words.find("the 0.4 s that its calls may take in all are used up"), std::string::npos) << r.words;
    }
}

// A machine with other work makes every call wait: that is not the submission's time.
TEST(Judge, ChargesNobodyForABusyMachine) {
  const auto student = [&](const Call& call) -> Answer {
    std::this_thread::sleep_for(std::chrono::milliseconds(25));  // 25 ms for a call, as seen from outside
    return model({}, call);
  };
  Rubric rubric;
  rubric.limits.call_s = 0.01;
  rubric.cases = 3;
  Report report;
  judge(student, all_there, rubric, {{"force.sum", "force.torque", "update.linear", "plane.impulse"}, -1}, report);
  EXPECT_EQ(failing(report), Ids{}) << report_text(report, false);
}

// Not a stub as handed out, but as idle: bodies come back as they went in, answers are zero or the identity.
TEST(Judge, DoingNothingEarnsNothing) {
  const auto idle = [](const Call& call) -> Answer {
    Reply r{};
    r.A = call.request.A;
    r.B = call.request.B;
    for (int i = 0; i < 9; i += 4) {
      r.world_inertia[i] = r.world_inverse_inertia[i] = 1;
      if (call.request.direct == 0) r.A.body_inertia[i] = r.A.body_inverse_inertia[i] = 1;
    }
    return r;
  };
  for (const std::uint64_t seed : {1u, 20260414u}) {
    const Report report = judged(idle, 40, seed);
    EXPECT_EQ(report.score, 0) << report_text(report, false);
  }
}

TEST(Judge, NotANumberIsNeverRight) {
  const Report report = judged(
      [](const Call& call) -> Answer {
        Reply r = model_answer(Habits{}, call.constants, call.request);
        r.A.velocity[2] = NAN;
        return r;
      },
      24, 3, {}, {{"plane.restitution", "pair.linear-momentum", "plane.energy", "update.linear"}, -1});
  EXPECT_EQ(report.results.size(), 4u);
  for (const CheckResult& r : report.results) EXPECT_EQ(r.verdict, Verdict::fail) << r.check->id;
}

TEST(Judge, ShowsASmallCaseThatStillFails) {
  const Report report = judged("force.torque-reversed", 60, 8);
  for (const CheckResult& r : report.results) {
    if (r.check->id != "force.torque") continue;
    ASSERT_TRUE(r.counterexample);
    EXPECT_TRUE(r.counterexample->inputs.A.turn.tail<3>().isZero()) << "the turn does not matter for a reversed torque";
    EXPECT_TRUE(r.counterexample->inputs.A.velocity.isZero());
    EXPECT_FALSE(r.counterexample->judgement.ratio() <= 1);
  }
}

TEST(Judge, AcceptsWhatTheRubricAccepts) {
  Rubric rubric;
  rubric.accepted = {"plane.printed-restitution", "pair.printed-restitution"};
  const char* both = "plane.printed-restitution+pair.printed-restitution";
  EXPECT_EQ(failing(judged(both, 24, 3)), (Ids{"plane.restitution", "pair.restitution"}));
  EXPECT_EQ(judged(both, 24, 3, rubric).score, 100);
}

TEST(Formats, CarryTheSameScoreAndNothingThatABrowserOrTerminalWouldInterpret) {
  Report report = judged("force.torque-reversed", 24, 8);
  report.submission = "<script>alert('x')</script>";
  report.output = "\x1b[31m<b>\"&";
  report.notes = {"<img src=x>"};
  const auto json = nlohmann::json::parse(report_json(report));
  EXPECT_EQ(json["schema"], "rigor.report/1");
  EXPECT_EQ(json["score"], report.score);
  EXPECT_EQ(json["checks"].size(), checks().size());
  for (const auto& check : json["checks"])
    for (const char* key : {"id", "function", "formula", "verdict", "points", "max_points", "cases", "worst_ratio", "counterexample", "replay", "diagnosis"})
      EXPECT_TRUE(check.contains(key)) << key;
  const std::string html = report_html(report);
  EXPECT_EQ(html.find("<script>alert"), std::string::npos);
  EXPECT_EQ(html.find("<img"), std::string::npos);
  EXPECT_EQ(html.find('\x1b'), std::string::npos);
  EXPECT_NE(html.find("the torque is F x r instead of r x F"), std::string::npos);
  EXPECT_EQ(report_text(report, false).find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace rigor::grader
