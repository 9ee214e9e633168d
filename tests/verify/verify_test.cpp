#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <rigor/cli/explain.hpp>
#include <rigor/scalar/magnitude.hpp>
#include <rigor/verify/verify.hpp>
#include <set>

namespace rigor::verify {
namespace {

TEST(Verify, EverythingHoldsAndEveryFormulaHasAnOracle) {
  const Result result = run("", 600, 7);
  EXPECT_TRUE(result.ok());
  std::set<std::string> with_oracle;
  for (const Agreement& a : result.agreements) {
    EXPECT_TRUE(a.ok()) << a.id << " " << a.worst << " > " << a.bound;
    with_oracle.insert(a.id);
  }
  for (const Identity& i : result.identities) EXPECT_TRUE(i.ok()) << i.id;
  for (const Rounding& r : result.roundings) {
    EXPECT_TRUE(r.ok()) << r.id << " " << r.worst;
    EXPECT_GT(r.worst, 0.05) << r.id << ": a bound nobody comes near proves little";
  }
  EXPECT_EQ(result.engines.size(), engine_ids().size());
  for (const Agreement& a : result.engines) {
    EXPECT_TRUE(a.ok()) << a.id << " " << a.worst << " > " << a.bound;
    EXPECT_TRUE(a.bound == 0 || a.worst > a.bound / 1000) << a.id << ": compares nothing?";
  }
  for (const std::string& id : cli::formula_ids(cli::texts())) {
    EXPECT_EQ(with_oracle.count(id), 1u) << id;
    // a row, or the reason why there is none
    const auto of = [&](const auto& row) { return row.id == id; };
    const auto absent = [&](const char* part) { return std::count_if(result.absent.begin(), result.absent.end(), [&](const Absent& a) { return a.id == id && a.part == part; }); };
    EXPECT_EQ(std::count_if(result.identities.begin(), result.identities.end(), of) + absent("exact identity"), 1) << id;
    EXPECT_EQ(std::count_if(result.roundings.begin(), result.roundings.end(), of) + absent("rounding"), 1) << id;
  }
}

TEST(Verify, SameSeedSameFigures) {
  EXPECT_EQ(run("motion.euler", 100, 3).roundings[0].worst, run("motion.euler", 100, 3).roundings[0].worst);
  EXPECT_NE(run("motion.euler", 100, 3).roundings[0].worst, run("motion.euler", 100, 4).roundings[0].worst);
}

TEST(Result, IsNotOkWhenOneRowIsNot) {
  Result result;
  result.identities.push_back({"a", "", 2, 2});
  result.roundings.push_back({"a", "", 2, 0.5});
  EXPECT_TRUE(result.ok());
  result.roundings.push_back({"b", "", 2, NAN});
  EXPECT_FALSE(result.ok());
  result.roundings.back().worst = 1.01;
  EXPECT_FALSE(result.ok());
}

// 3 - 2.5 + 0.25 has absolute sum 5.75.
TEST(Magnitude, AddsAbsoluteValuesWhereTheNumberSubtracts) {
  const Magnitude x = Magnitude(3) - Magnitude(2.5) + Magnitude(0.25);
  EXPECT_EQ(x.value, 0.75);
  EXPECT_EQ(x.size, 5.75);
  EXPECT_EQ((x * Magnitude(-2)).size, 11.5);
}

}  // namespace
}  // namespace rigor::verify
