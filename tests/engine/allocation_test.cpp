// What is called in a loop allocates nothing.
#include <gtest/gtest.h>

#include <rigor/engine/batch.hpp>
#include <rigor/engine/flight_batch.hpp>
#include <rigor/engine/flow_methods.hpp>
#include <rigor/engine/located.hpp>
#include <rigor/linalg/rotation.hpp>
#include <tests/scene/allocations.hpp>

namespace rigor {
namespace {

using V = Vec3<double>;

const Cuboid<double> box = *Cuboid<double>::make(2.5, {0.7, 1.1, 1.9});
Motion start(double w) {
  State<double> s;
  s.R_WB = rotation_of<double>(Vec4<double>(9, 1, -1, 3));
  s.w_WB = V(0.3, w, 0.1);
  return motion_of(box, s);
}

TEST(Allocation, TheCounterCounts) {
  const long before = allocations;
  const int* volatile one = new int(1);  // volatile: or the two are left out
  delete one;
  EXPECT_EQ(allocations, before + 1);
}

TEST(Allocation, NoneWhileABatchStepsOnOneThread) {
  std::vector<Motion> motions;
  for (int k = 0; k < 300; ++k) motions.push_back(start(1 + 0.7 * k));  // slow ones and such as turn by radians a step
  for (const BatchMethod method : batch_methods) {
    Batch batch = *Batch::make(std::vector<Cuboid<double>>(motions.size(), box), motions, method);
    batch.set_load(7, {V(1, 2, 3), V(3, 2, 1)});
    batch.step(0.01);  // the first of all asks what the processor has
    const long before = allocations;
    batch.step(0.01, 100);
    EXPECT_EQ(allocations, before) << plain(method).name;
  }
}

TEST(Allocation, NoneWhileAFlightIsSetUpAndEvaluated) {
  using Precision = ExactFlight::Precision;
  for (const V& w : {V(0.3, 2, 0.2), V(5, 0.01, 0.01), V(0, 1, 0), V(0, 0, 0)})
    for (const Precision precision : {Precision::plain, Precision::extended}) {
      const long before = allocations;
      const auto flight = ExactFlight::make({1, 2, 2.5}, w, identity3<double>(), precision);
      flight->at(0.5);
      EXPECT_EQ(allocations, before);
    }
}

TEST(Allocation, NoneWhileFlightsAreEvaluatedOnOneThread) {
  std::vector<ExactFlight> flights;
  for (int k = 0; k < 50; ++k) flights.push_back(*ExactFlight::make({1, 2, 2.5}, {0.3 + 0.01 * k, 2, k % 10 == 0 ? 0.0 : -0.2}, identity3<double>()));
  flights.push_back(*ExactFlight::make({1, 2, 2.5}, {0, 1, 0}, identity3<double>()));  // about an axis: evaluated alone
  FlightBatch batch(flights);  // evaluated at 0 already
  const long before = allocations;
  batch.evaluate(1.5);
  EXPECT_EQ(allocations, before);
}

TEST(Allocation, NoneInAStepOfAnyMethod) {
  const LoadAt load = [](double t, const State<double>& s) { return Load{V(0, t, 0), V(s.v_WB + V(1, 2, 3))}; };
  for (const auto* list : {&methods(), &flow_methods()})
    for (const Method& method : *list) {
      const Motion from = start(1);
      const long before = allocations;
      method.step(box, from, {V(1, 2, 3), V(3, 2, 1)}, 0.01);
      advance(method, box, from, load, 0, 0.01);
      EXPECT_EQ(allocations, before) << method.name;
    }
}

// Four cuboids in a closed box: flights, boxes, searches and what is to come keep their memory once it has grown, and
// everybody has met everybody.
TEST(Allocation, NoneBetweenLocatedImpacts) {
  Scene s;
  s.method = "located";
  s.gravity = zero3<double>();
  s.surface = *Surface<double>::make(1, 0, 0);
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      V n = zero3<double>();
      n[axis] = -side;
      s.planes.push_back(*Plane<double>::make(V(-2 * n), n));
    }
  for (int k = 0; k < 4; ++k) {
    State<double> b;
    b.p_WB = V(k & 1 ? 1 : -1, k & 2 ? 1 : -1, 0.1 * k), b.v_WB = V(1 + k, 3 - k, 2), b.w_WB = V(k, 2, -1);
    s.bodies.push_back({*Cuboid<double>::make(2, V(0.3, 0.4, 0.5)), b});
  }
  s.until = s.every = 200;
  long impacts = 0, at_half = 0, last = 0;
  const auto run = simulate_located(s, [](double, const std::vector<State<double>>&) {}, [&](const LocatedImpact& impact) {
    ++impacts;
    last = allocations;
    if (impact.t < s.until / 2) at_half = last;
  });
  ASSERT_TRUE(run && run->handed_over.empty());
  EXPECT_GT(impacts, 1000);
  EXPECT_GT(run->ledger.pair_impacts, 50);
  EXPECT_EQ(last, at_half);
}

}  // namespace
}  // namespace rigor
