// Many flights together against one by one: the same bits.
#include <gtest/gtest.h>

#include <cfenv>
#include <cstring>
#include <random>
#include <rigor/engine/flight_batch.hpp>
#include <rigor/linalg/rotation.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;
using Kind = ExactFlight::Tuned::Kind;

// Random cuboids of aspect up to 30, and every fifth an awkward motion: spheres, tops, the separatrix and spins beside it,
// spins about and near an axis, no spin.
std::vector<ExactFlight> flights(int count, unsigned seed) {
  const std::pair<V, V> awkward[] = {{{2, 2, 2}, {0.3, -1, 0.7}},      {{2, 2, 1}, {0.3, -1, 0.7}},         {{2, 2, 1}, {0.3, -1, 0}},
                                     {{1, 3, 6}, {1.5, 0.7, 0.5}},     {{1, 3, 6}, {-1.5, 0.7, 0.5 + 1e-12}}, {{1, 2, 2.5}, {0, 2, 0}},
                                     {{1, 2, 2.5}, {1e-15, 2, 1e-15}}, {{1, 2, 2.5}, {1e-200, 0, 3}},       {{1, 2, 2.5}, {0, 0, 0}},
                                     {{2.5, 1, 2}, {0.3, -4e5, 2}}};
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> U(0, 1);
  std::normal_distribution<double> N;
  std::vector<ExactFlight> all;
  for (int i = 0; i < count; ++i) {
    const Mat3<double> R = rotation_of<double>(Vec4<double>{N(random), N(random), N(random), N(random)}.normalized());
    const double a = std::pow(30, U(random)), b = std::pow(30, U(random)), c = std::pow(30, U(random));
    V I(b * b + c * c, a * a + c * c, a * a + b * b), w{N(random), N(random), N(random)};
    if (i % 5 == 0) std::tie(I, w) = awkward[i / 5 % std::size(awkward)];
    all.push_back(*ExactFlight::make(I, w, R));
  }
  return all;
}

void expect_same(const FlightBatch& batch, const std::vector<ExactFlight>& all, double t, const std::string& what) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Attitude want = all[i].at(t);
    const Mat3<double> R = batch.R_WB(i);
    const V L = batch.L_B(i);
    ASSERT_TRUE(want.R_WB.allFinite() && want.L_B.allFinite()) << what << ", flight " << i << " at " << t;
    ASSERT_EQ(std::memcmp(R.data(), want.R_WB.data(), sizeof R), 0) << what << ", flight " << i << " at " << t;
    ASSERT_EQ(std::memcmp(L.data(), want.L_B.data(), sizeof L), 0) << what << ", flight " << i << " at " << t;
  }
}

TEST(FlightBatch, HasTheBitsOfOneFlightOnEveryInstructionSet) {
  for (const int count : {1, 8, 9, 300, 1000}) {
    const auto all = flights(count, unsigned(count));
    int kinds[3] = {};
    for (const ExactFlight& f : all) ++kinds[int(f.tuned().kind)];
    if (count >= 300) {
      EXPECT_TRUE(kinds[0] > 20 && kinds[1] > 50 && kinds[2] > 50) << "all three kinds occur";
    }
    FlightBatch batch(all);
    expect_same(batch, all, 0, "as made");
    for (const Instructions with : supported_instructions())
      for (const double t : {0.0, 0.3, -7.7, 1234.5, 1e9}) {
        batch.evaluate(t, 1, with);
        expect_same(batch, all, t, name(with));
      }
  }
}

TEST(FlightBatch, DoesNotDependOnThreads) {
  const auto all = flights(500, 3);
  FlightBatch batch(all);
  double t = 1;
  for (const unsigned threads : {2u, 3u, 1000u}) {
    batch.evaluate(t, threads);
    expect_same(batch, all, t, std::to_string(threads) + " threads");
    t += 1;
  }
}

// As of Batch: in lanes of nobody too, all that is computed is a number.
TEST(FlightBatch, MakesNoInvalidOperationInLanesOfNobody) {
  for (const V& w : {V(2, 0.7, 1.1), V(0.3, 2, 0.2)}) {  // the two series
    FlightBatch batch({*ExactFlight::make({1, 2, 2.5}, w, identity3<double>())});
    for (const Instructions with : supported_instructions()) {
      std::feclearexcept(FE_ALL_EXCEPT);
      batch.evaluate(1.25, 1, with);
      EXPECT_FALSE(std::fetestexcept(FE_INVALID | FE_DIVBYZERO)) << w.transpose() << ", " << name(with);
    }
  }
}

TEST(FlightBatch, OfNobodyIsEmpty) {
  FlightBatch none(std::vector<ExactFlight>{});
  none.evaluate(1, 4);
  EXPECT_EQ(none.size(), 0u);
}

}  // namespace
}  // namespace rigor
