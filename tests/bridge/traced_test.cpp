#include <gtest/gtest.h>

#include <rigor/formulas/normal_impulse.hpp>
#include <rigor/formulas/positional_correction.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/scalar/traced.hpp>

// The recording scalar by itself. That its recordings are the formulas is proved in proofs/coq (proofs/check).
namespace rigor {
namespace {

Traced symbol(Recording& in, const char* name) { return {&in, name}; }

}  // namespace

TEST(Traced, WritesOperationsInTheOrderTheyAreDone) {
  Recording recording({});
  const Traced j = normal_impulse<Traced>(symbol(recording, "e"), symbol(recording, "v"), symbol(recording, "k"));
  EXPECT_EQ(recording.lets(""), "let t1 := 1 + e in\nlet t2 := - t1 in\nlet t3 := t2 * v in\nlet t4 := t3 / k in\n");
  EXPECT_EQ(j.term(), "t4");
}

TEST(Traced, StopsAtAQuestionAndFollowsTheAnswerItIsGiven) {
  const auto correct = [](Recording& in) {
    return positional_correction<Traced>(symbol(in, "d"), Vec3<Traced>(symbol(in, "x"), symbol(in, "y"), symbol(in, "z")));
  };
  Recording unanswered({});
  try {
    correct(unanswered);
    FAIL() << "no question was asked";
  } catch (const Recording::Undecided& at) {
    EXPECT_EQ(at.condition, "Rgt_dec d 0");
  }
  Recording no({false});
  EXPECT_EQ(correct(no)[0].term(), "0");
  Recording yes({true});
  EXPECT_NE(correct(yes)[0].term(), "0");
  EXPECT_NE(yes.lets("").find(":= d * x in"), std::string::npos);
}

TEST(Traced, RefusesToCompareConstantsAndToFollowALoopThatDataEnds) {
  EXPECT_THROW(void(Traced(1) < Traced(2)), std::logic_error);
  Recording always_yes(std::vector<bool>(100, true));
  const Traced x = symbol(always_yes, "x");
  const auto count_down = [&](Traced y) {
    while (y > Traced(0)) y = y - Traced(1);
  };
  EXPECT_THROW(count_down(x), std::logic_error);
}

TEST(Traced, KeepsConstantsInPlace) {
  Recording recording({});
  EXPECT_EQ((Traced(2) * Traced(-3)).term(), "(2 * (-3))");
  EXPECT_EQ((Traced(2) * symbol(recording, "x")).term(), "t1");
  static_assert(Real<Traced> && !std::is_constructible_v<Traced, double>);
}

}  // namespace rigor
