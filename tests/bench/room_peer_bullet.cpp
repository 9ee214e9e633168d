// Bullet (double) in the assignment's room: no damping, no sleeping, no margin to speak of, its default gyroscopic term
// without a cap, fixed steps.
#include <btBulletDynamicsCommon.h>

#include "room_peer.hpp"

namespace rigor::bench {

static_assert(sizeof(btScalar) == 8, "the package bullet-float64");

std::array<double, 3> bullet_room(const PeerRoom& room) {
  const auto vector = [](const std::array<double, 3>& a) { return btVector3(a[0], a[1], a[2]); };
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity(vector(room.gravity));
  world.getSolverInfo().m_maxGyroscopicForce = 1e30;
  std::vector<std::unique_ptr<btStaticPlaneShape>> shapes;
  std::vector<std::unique_ptr<btRigidBody>> all;
  const auto add = [&](double mass, btCollisionShape* shape, const btVector3& inertia) -> btRigidBody& {
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape, inertia);
    info.m_linearDamping = info.m_angularDamping = 0;
    info.m_restitution = mass > 0 ? room.restitution : 1;  // Bullet multiplies the two
    info.m_friction = mass > 0 ? room.friction : 1;
    all.push_back(std::make_unique<btRigidBody>(info));
    return *all.back();
  };
  for (const auto& [normal, offset] : room.planes) {
    shapes.push_back(std::make_unique<btStaticPlaneShape>(vector(normal), offset));
    add(0, shapes.back().get(), btVector3(0, 0, 0));
  }
  btBoxShape box(vector(room.size) / 2);
  btVector3 inertia;
  box.calculateLocalInertia(room.mass, inertia);
  btRigidBody& body = add(room.mass, &box, inertia);
  body.setWorldTransform(btTransform(btQuaternion::getIdentity(), vector(room.p)));
  body.setLinearVelocity(vector(room.v));
  body.setAngularVelocity(vector(room.w));
  body.setActivationState(DISABLE_DEACTIVATION);
  for (const auto& each : all) world.addRigidBody(each.get());
  for (long k = 0; k < room.steps; ++k) world.stepSimulation(room.until / double(room.steps), 0, room.until / double(room.steps));
  const btVector3 p = body.getWorldTransform().getOrigin();
  for (const auto& each : all) world.removeRigidBody(each.get());
  return {p.x(), p.y(), p.z()};
}

}  // namespace rigor::bench
