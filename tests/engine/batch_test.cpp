// The batch against the plain method it must equal bit for bit.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cfenv>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>
#include <rigor/engine/batch.hpp>
#include <rigor/engine/flight_batch.hpp>
#include <rigor/linalg/rotation.hpp>
#include <system_error>
#include <thread>
#include <utility>

namespace rigor {
namespace {

using V = Vec3<double>;

struct World {
  std::vector<Cuboid<double>> bodies;
  std::vector<Motion> motions;
  std::vector<Load> loads;
  BatchMethod method = BatchMethod::euler_momentum;

  void add(const Cuboid<double>& body, const State<double>& state, const Load& load) {
    bodies.push_back(body);
    motions.push_back(motion_of(body, state));
    loads.push_back(load);
  }
  Batch batch() const {
    Batch made = *Batch::make(bodies, motions, method);
    for (std::size_t i = 0; i < loads.size(); ++i) made.set_load(i, loads[i]);
    return made;
  }
  // the plain method, body by body
  std::vector<Motion> plain(double h, long steps) const {
    std::vector<Motion> now = motions;
    const auto step = rigor::plain(method).step;
    for (std::size_t i = 0; i < now.size(); ++i)
      for (long k = 0; k < steps; ++k) now[i] = step(bodies[i], now[i], loads[i], h);
    return now;
  }
};

// Three different edges, generic attitude, off the origin, spinning, pushed and turned; every third body without a load.
World random_world(int count, unsigned seed) {
  std::mt19937_64 random(seed);
  const auto u = [&] { return double(random() >> 11) / 4503599627370496.0 - 1; };  // 2^52: [-1, 1)
  const auto vector = [&](double scale) {
    const double x = u(), y = u(), z = u();
    return V(scale * x, scale * y, scale * z);
  };
  World world;
  for (int i = 0; i < count; ++i) {
    const double mass = 2 + u();
    const V size = V(1.5, 2.5, 3.5) + vector(0.9);
    State<double> s;
    s.p_WB = vector(100);
    const V turn = vector(1);
    s.R_WB = rotation_of<double>(Vec4<double>(1.5, turn[0], turn[1], turn[2]));
    s.v_WB = vector(10);
    s.w_WB = vector(20);
    Load load;
    if (i % 3) load = {vector(50), vector(9)};
    world.add(*Cuboid<double>::make(mass, size), s, load);
  }
  return world;
}

bool same_bits(const Motion& a, const Motion& b) {
  const auto same = [](const auto& x, const auto& y) { return std::memcmp(x.data(), y.data(), sizeof(double) * std::size_t(x.size())) == 0; };
  return same(a.state.p_WB, b.state.p_WB) && same(a.state.R_WB, b.state.R_WB) && same(a.state.v_WB, b.state.v_WB) && same(a.state.w_WB, b.state.w_WB) && same(a.L_W, b.L_W);
}
void expect_same(const Batch& batch, const std::vector<Motion>& want, const std::string& what) {
  ASSERT_EQ(batch.size(), want.size());
  for (std::size_t i = 0; i < want.size(); ++i) ASSERT_TRUE(same_bits(batch.motion(i), want[i])) << what << ", body " << i << " of " << want.size();
}

// Counts around the lanes of a block and the blocks of a tile (8 and 128 bodies).
TEST(Batch, HasTheBitsOfThePlainMethodOnEveryInstructionSet) {
  for (const BatchMethod method : batch_methods)
    for (const double h : {0.01, 0.2})  // up to 7 rad a step, where split2 leaves its short series
      for (const int count : {1, 7, 8, 9, 127, 128, 129, 300}) {
        World world = random_world(count, unsigned(count));
        world.method = method;
        const auto want = world.plain(h, 40);
        for (const Instructions with : supported_instructions()) {
          Batch batch = world.batch();
          batch.step(h, 40, 1, with);
          expect_same(batch, want, std::string(plain(method).name) + ", " + name(with));
        }
      }
}

// Signed zeros, numbers without full precision, spins of twenty and of a million turns a step, steps backwards, equal moments:
// still the same bits.
TEST(Batch, HasTheBitsOfThePlainMethodOnAwkwardNumbers) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  const auto plate = *Cuboid<double>::make(3, {1e-3, 2, 3}), cube = *Cuboid<double>::make(1e9, {1, 1, 1});
  World world;
  const auto rod = *Cuboid<double>::make(1, {0.5, 0.5, 4}), slab = *Cuboid<double>::make(1, {4, 0.5, 4}), needle = *Cuboid<double>::make(1, {2, 0.1, 0.1});
  for (const auto& body : {plate, cube, rod, slab, needle})
    for (const V& w : {V(0, 0, 0), V(-0.0, -0.0, -0.0), V(tiny, -tiny, 0), V(1e-170, 1e-160, -1e-155), V(0, 12345, 0), V(1e8, -2e8, 3e7)})
      for (const Load& load : {Load{}, Load{V(-0.0, tiny, 1e300), V(1e-300, -0.0, tiny)}}) {
        State<double> s;
        s.v_WB = V(-0.0, tiny, 1e150);
        s.p_WB = V(1e15, -0.0, -1e-310);
        s.w_WB = w;
        world.add(body, s, load);
      }
  for (const BatchMethod method : batch_methods)
    for (const double h : {0.01, -0.01, 0.0, -0.0, 1e-300}) {
      world.method = method;
      const auto want = world.plain(h, 7);
      for (const Instructions with : supported_instructions()) {
        Batch batch = world.batch();
        batch.step(h, 7, 1, with);
        expect_same(batch, want, name(with) + std::string(", h ") + std::to_string(h));
      }
    }
}

// A block of split2 takes the short series only if no lane needs the other: half a turn angle from 0.4 to 0.8 rad around the joint
// at 1/2, alone in its block.
TEST(Batch, HasTheBitsOfThePlainMethodWhereTheSeriesChange) {
  for (const V& size : {V(1, 1, 1), V(1, 1.0625, 1.125), V(2, 0.125, 0.125), V(0.25, 2, 0.125)})
    for (int axis = 0; axis < 3; ++axis)
      for (int k = 0; k < 100; ++k) {
        State<double> s;
        s.w_WB = V(0.02, 0.01, 0.03);
        s.w_WB[axis] = 80 + 0.8 * k;
        World world;
        world.method = BatchMethod::split2;
        world.add(*Cuboid<double>::make(1, size), s, {});
        const auto want = world.plain(0.01, 5);
        for (const Instructions with : supported_instructions()) {
          Batch batch = world.batch();
          batch.step(0.01, 5, 1, with);
          expect_same(batch, want, name(with) + std::string(", spin ") + std::to_string(s.w_WB[axis]));
        }
      }
}

// case ST-07: the number of threads changes nothing, and neither does asking for the steps one by one.
TEST(Batch, DoesNotDependOnThreadsOrOnHowStepsAreAskedFor) {
  World world = random_world(1003, 5);
  for (const BatchMethod method : batch_methods) {
    world.method = method;
    const auto want = world.plain(1 / 240., 30);
    for (const unsigned threads : {1u, 2u, 3u, 8u, 1000u}) {
      Batch batch = world.batch();
      batch.step(1 / 240., 30, threads);
      expect_same(batch, want, std::to_string(threads) + " threads");
    }
    Batch batch = world.batch();
    for (int k = 0; k < 30; ++k) batch.step(1 / 240.);
    expect_same(batch, want, "one by one");
  }
}

TEST(Batch, TakesNewLoadsBetweenSteps) {
  World world = random_world(20, 6);
  Batch batch = world.batch();
  batch.step(0.01, 3);
  world.motions = world.plain(0.01, 3);
  world.loads = random_world(20, 7).loads;
  for (std::size_t i = 0; i < 20; ++i) batch.set_load(i, world.loads[i]);
  batch.step(0.02, 3);
  expect_same(batch, world.plain(0.02, 3), "second load");
}

// case D-08: without torque the angular momentum keeps its bits for ever.
TEST(Batch, KeepsAngularMomentumToTheBitWithoutTorque) {
  World world = random_world(64, 8);
  for (Load& load : world.loads) load.tau_W = zero3<double>();
  for (const BatchMethod method : batch_methods) {
    world.method = method;
    Batch batch = world.batch();
    batch.step(0.01, 10000);
    for (std::size_t i = 0; i < batch.size(); ++i) EXPECT_EQ(V(batch.L_W(i)), world.motions[i].L_W);
  }
}

TEST(Batch, ShowsItsStateWithoutCopying) {
  const World world = random_world(11, 9);
  Batch batch = world.batch();
  const auto p = batch.p_WB(10);
  const auto R = batch.R_WB(10);
  EXPECT_EQ(V(p), world.motions[10].state.p_WB);
  EXPECT_EQ(Mat3<double>(R), world.motions[10].state.R_WB);
  batch.step(0.01);
  EXPECT_EQ(V(p), batch.motion(10).state.p_WB) << "the view follows the step";
  EXPECT_NE(V(p), world.motions[10].state.p_WB);
  EXPECT_EQ(Mat3<double>(R), batch.motion(10).state.R_WB);
}

// Nothing is thrown out of what is called in a loop, and a system without threads costs time, not the result.
static_assert(noexcept(std::declval<Batch&>().step(0.01)) && noexcept(std::declval<FlightBatch&>().evaluate(1)) && noexcept(std::declval<const ExactFlight&>().at(1)));
[[noreturn]] void step_without_threads(const World& world, const std::vector<Motion>& want) {
  Batch batch = world.batch();
  const rlimit little{1 << 20, 1 << 20};  // of address space: less than there is, so that no stack can be had
  if (setrlimit(RLIMIT_AS, &little) != 0) std::_Exit(3);
  try {
    std::jthread([] {});
    std::_Exit(4);
  } catch (const std::system_error&) {
  }
  batch.step(0.01, 3, 8);
  bool same = true;
  for (std::size_t i = 0; i < want.size(); ++i) same &= same_bits(batch.motion(i), want[i]);
  std::_Exit(same ? 0 : 1);
}
TEST(BatchDeathTest, StepsWhereThereAreNoMoreThreads) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer itself needs the address space";
#endif
  const World world = random_world(300, 13);
  EXPECT_EXIT(step_without_threads(world, world.plain(0.01, 3)), ::testing::ExitedWithCode(0), "");
}

TEST(Batch, OfNoStepStaysWhereItIs) {
  const World world = random_world(9, 5);
  Batch batch = world.batch();
  batch.step(0.01, 0);
  expect_same(batch, world.motions, "no step");
}

// Three cuboids fill three of eight lanes; in the others nothing is computed that is no number, which a user who traps such would meet.
TEST(Batch, MakesNoInvalidOperationInLanesOfNobody) {
  for (const BatchMethod method : {BatchMethod::euler_momentum, BatchMethod::euler_momentum_cross, BatchMethod::split2}) {
    for (const double spin : {20., 300.}) {  // by a fast one, which turns 3 rad a step, the others are taken another way
      World world = random_world(3, 17);
      world.method = method;
      world.motions[1].state.w_WB *= spin / norm<double>(world.motions[1].state.w_WB);
      world.motions[1] = motion_of(world.bodies[1], world.motions[1].state);
      Batch batch = world.batch();
      for (const Instructions with : supported_instructions()) {
        std::feclearexcept(FE_ALL_EXCEPT);
        batch.step(0.01, 5, 1, with);
        EXPECT_FALSE(std::fetestexcept(FE_INVALID | FE_DIVBYZERO)) << plain(method).name << ", " << name(with) << ", " << spin << " rad/s";
      }
    }
  }
}

// Nothing to do is done at once, however often; a single step for nobody, made so often, would not end.
TEST(Batch, OfNobodyHasNoSteps) {
  Batch batch = *Batch::make({}, {});
  batch.step(0.01, std::numeric_limits<long>::max());
  EXPECT_EQ(batch.size(), 0u);
}

TEST(Batch, RefusesWhatItCannotStep) {
  World world = random_world(3, 11);
  const auto fault = [&](auto spoil) {
    World spoilt = world;
    spoil(spoilt);
    return Batch::make(spoilt.bodies, spoilt.motions).fault();
  };
  EXPECT_EQ(fault([](World& w) { w.motions.pop_back(); }).text(), "motions are 2, must be one for each of 3 bodies");
  for (int k = 0; k < 3; ++k) {
    const std::string which = "[" + std::to_string(k) + "]";
    EXPECT_EQ(fault([&](World& w) { w.motions[2].state.p_WB[k] = NAN; }).where, "motions[2].p_WB" + which);
    EXPECT_EQ(fault([&](World& w) { w.motions[2].state.v_WB[k] = NAN; }).where, "motions[2].v_WB" + which);
    EXPECT_EQ(fault([&](World& w) { w.motions[2].state.w_WB[k] = NAN; }).where, "motions[2].w_WB" + which);
    EXPECT_EQ(fault([&](World& w) { w.motions[2].L_W[k] = NAN; }).where, "motions[2].L_W" + which);
  }
  for (int row = 0; row < 3; ++row)
    for (int col = 0; col < 3; ++col)
      EXPECT_EQ(fault([&](World& w) { w.motions[1].state.R_WB(row, col) = INFINITY; }).where, "motions[1].R_WB(" + std::to_string(row) + "," + std::to_string(col) + ")");
  EXPECT_EQ(fault([](World& w) { w.motions[0].L_W[0] = NAN; }).kind, Fault::Kind::not_finite);
  EXPECT_EQ((*Batch::make({}, {})).size(), 0u);
  Batch none = *Batch::make({}, {});
  none.step(0.01, 5, 4);  // nobody to move: nothing happens
}

}  // namespace
}  // namespace rigor
