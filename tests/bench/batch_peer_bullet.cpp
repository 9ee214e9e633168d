// Bullet (double): the free bodies of the batch benchmark. No damping, no sleeping, its default gyroscopic term without a
// cap, nothing collides: four metres apart, and in collision groups that meet nobody.
#include <benchmark/benchmark.h>
#include <btBulletDynamicsCommon.h>

#include <memory>
#include <vector>

namespace {

static_assert(sizeof(btScalar) == 8, "the package bullet-float64");

constexpr int bodies = 1000;
void count(benchmark::State& state) {
  state.counters["ns_per_body_step"] = benchmark::Counter(bodies * double(state.iterations()) * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void bullet(benchmark::State& state) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity(btVector3(0, 0, 0));
  world.getSolverInfo().m_maxGyroscopicForce = 1e30;
  btBoxShape shape(btVector3(0.35, 0.55, 0.95));
  btVector3 inertia;
  shape.calculateLocalInertia(2.5, inertia);
  std::vector<std::unique_ptr<btRigidBody>> all;
  for (int i = 0; i < bodies; ++i) {
    btRigidBody::btRigidBodyConstructionInfo info(2.5, nullptr, &shape, inertia);
    info.m_startWorldTransform = btTransform(btQuaternion::getIdentity(), btVector3(4 * (i % 10), 4 * (i / 10 % 10), 4 * (i / 100)));
    info.m_linearDamping = info.m_angularDamping = 0;
    all.push_back(std::make_unique<btRigidBody>(info));
    all.back()->setAngularVelocity(btVector3(0.3, 1, 0.1 * (i % 11)));
    all.back()->setActivationState(DISABLE_DEACTIVATION);
    world.addRigidBody(all.back().get(), 0, 0);
  }
  for (auto _ : state) world.stepSimulation(1e-3, 0, 1e-3);
  count(state);
  for (const auto& body : all) world.removeRigidBody(body.get());
}
BENCHMARK(bullet);

}  // namespace
