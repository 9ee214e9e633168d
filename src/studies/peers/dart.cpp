// DART (double).
#include <dart/config.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/simulation/World.hpp>

#include <rigor/studies/peers/peer.hpp>

namespace rigor::peers {
namespace {

Eigen::Vector3d vector(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

class DartWorld : public World {
 public:
  DartWorld(const Flight& f, long steps) : steps_(steps), world_(dart::simulation::World::create()) {
    using namespace dart::dynamics;
    world_->setTimeStep(f.until / double(steps));
    world_->setGravity(vector(f.a));
    const SkeletonPtr skeleton = Skeleton::create("cuboid");
    const auto [joint, body] = skeleton->createJointAndBodyNodePair<FreeJoint>();
    Inertia inertia;
    inertia.setMass(f.mass);
    inertia.setMoment(vector(f.inertia()).asDiagonal());
    body->setInertia(inertia);
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    X.linear() = Eigen::Quaterniond(f.q[0], f.q[1], f.q[2], f.q[3]).normalized().toRotationMatrix();
    X.translation() = vector(f.p);
    joint->setTransform(X);
    joint->setLinearVelocity(vector(f.v));
    joint->setAngularVelocity(vector(f.w));
    world_->addSkeleton(skeleton);
    body_ = body;
  }
  void run() override {
    for (long k = 0; k < steps_; ++k) world_->step();
  }
  End end() const override {
    const Eigen::Isometry3d X = body_->getTransform();
    const Eigen::Vector3d v = body_->getLinearVelocity(), w = body_->getAngularVelocity();
    End e{};
    for (int k = 0; k < 9; ++k) e.R[std::size_t(k)] = X.linear()(k / 3, k % 3);
    for (int k = 0; k < 3; ++k) e.p[std::size_t(k)] = X.translation()[k], e.v[std::size_t(k)] = v[k], e.w[std::size_t(k)] = w[k];
    return e;
  }
  long evaluations() const override { return steps_; }

 private:
  long steps_;
  dart::simulation::WorldPtr world_;
  dart::dynamics::BodyNode* body_;
};

}  // namespace

std::vector<Variant> variants() {
  return {{"default", "DART " DART_VERSION ", double, free joint, semi-implicit Euler (its only stepper)", false, 3800,
           [](const Flight& f, long steps, double) { return std::make_unique<DartWorld>(f, steps); }}};
}

}  // namespace rigor::peers
