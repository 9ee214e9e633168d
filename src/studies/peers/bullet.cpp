// Bullet in double precision (libbullet's float64 build). Damping, sleeping and the default cap on the gyroscopic force off.
#include <btBulletDynamicsCommon.h>

#include <rigor/studies/peers/peer.hpp>

namespace rigor::peers {
namespace {

static_assert(sizeof(btScalar) == 8, "the package bullet-float64");

btVector3 vector(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }
std::array<double, 3> array(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

class BulletWorld : public World {
 public:
  BulletWorld(const Flight& f, long steps, int gyroscopic) : steps_(steps), h_(f.until / double(steps)), shape_(vector(f.size) / 2) {
    world_.setGravity(vector(f.a));
    world_.getSolverInfo().m_maxGyroscopicForce = 1e30;
    btRigidBody::btRigidBodyConstructionInfo info(f.mass, nullptr, &shape_, vector(f.inertia()));
    info.m_startWorldTransform = btTransform(btQuaternion(f.q[1], f.q[2], f.q[3], f.q[0]), vector(f.p));
    info.m_linearDamping = info.m_angularDamping = 0;
    body_ = std::make_unique<btRigidBody>(info);
    body_->setFlags(gyroscopic);
    body_->setLinearVelocity(vector(f.v));
    body_->setAngularVelocity(vector(f.w));
    body_->setActivationState(DISABLE_DEACTIVATION);
    world_.addRigidBody(body_.get(), 0, 0);
  }
  ~BulletWorld() override { world_.removeRigidBody(body_.get()); }
  void run() override {
    for (long k = 0; k < steps_; ++k) world_.stepSimulation(h_, 0, h_);
  }
  End end() const override {
    const btTransform& X = body_->getWorldTransform();
    End e{{}, array(X.getOrigin()), array(body_->getLinearVelocity()), array(body_->getAngularVelocity())};
    for (std::size_t k = 0; k < 9; ++k) e.R[k] = X.getBasis()[int(k / 3)][int(k % 3)];
    return e;
  }
  long evaluations() const override { return steps_; }

 private:
  long steps_;
  double h_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  btBoxShape shape_;
  std::unique_ptr<btRigidBody> body_;
};

}  // namespace

std::vector<Variant> variants() {
  const std::string version = "Bullet " + std::to_string(BT_BULLET_VERSION / 100) + "." + std::to_string(BT_BULLET_VERSION % 100) +
                              ", double, no damping, no sleeping, no cap on the gyroscopic force, collisions off, ";
  const auto variant = [&](const char* name, const char* says, int flag) {
    return Variant{name, version + says, false, 800, [flag](const Flight& f, long steps, double) { return std::make_unique<BulletWorld>(f, steps, flag); }};
  };
  return {variant("default", "gyroscopic term implicit in body axes (its default)", BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY),
          variant("explicit", "gyroscopic term explicit", BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT)};
}

}  // namespace rigor::peers
