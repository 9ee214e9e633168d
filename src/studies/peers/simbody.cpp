// Simbody (double). Its integrators by their accuracy, and Runge-Kutta-Merson at a fixed step.
#include <Simbody.h>

#include <rigor/studies/peers/peer.hpp>

namespace rigor::peers {
namespace {

SimTK::Vec3 vector(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

enum class Kind { merson, feldberg, merson_fixed };

class SimbodyWorld : public World {
 public:
  SimbodyWorld(const Flight& f, Kind kind, long steps, double accuracy) : until_(f.until), steps_(kind == Kind::merson_fixed ? steps : 0) {
    using namespace SimTK;
    if (f.a != std::array<double, 3>{}) Force::UniformGravity(forces_, matter_, vector(f.a));
    const auto I = f.inertia();
    body_ = MobilizedBody::Free(matter_.Ground(), Transform(), Body::Rigid(MassProperties(f.mass, Vec3(0), Inertia(I[0], I[1], I[2]))), Transform());
    State state = system_.realizeTopology();
    body_.setQToFitTransform(state, Transform(Rotation(Quaternion(f.q[0], f.q[1], f.q[2], f.q[3])), vector(f.p)));
    body_.setUToFitVelocity(state, SpatialVec(vector(f.w), vector(f.v)));
    if (kind == Kind::feldberg) integrator_ = std::make_unique<RungeKuttaFeldbergIntegrator>(system_);
    else integrator_ = std::make_unique<RungeKuttaMersonIntegrator>(system_);
    if (kind == Kind::merson_fixed) integrator_->setFixedStepSize(until_ / double(steps));
    else integrator_->setAccuracy(accuracy);
    stepper_ = std::make_unique<TimeStepper>(system_, *integrator_);
    stepper_->initialize(state);
  }
  void run() override {
    for (long k = 1; k < steps_; ++k) stepper_->stepTo(until_ * double(k) / double(steps_));
    stepper_->stepTo(until_);
  }
  End end() const override {
    const SimTK::State& state = stepper_->getState();
    system_.realize(state, SimTK::Stage::Velocity);
    const SimTK::Transform& X = body_.getBodyTransform(state);
    const SimTK::SpatialVec& V = body_.getBodyVelocity(state);
    End e{};
    for (int k = 0; k < 9; ++k) e.R[std::size_t(k)] = X.R()[k / 3][k % 3];
    for (int k = 0; k < 3; ++k) e.p[std::size_t(k)] = X.p()[k], e.v[std::size_t(k)] = V[1][k], e.w[std::size_t(k)] = V[0][k];
    return e;
  }
  long evaluations() const override { return integrator_->getNumRealizations(); }

 private:
  double until_;
  long steps_;
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_{system_};
  SimTK::GeneralForceSubsystem forces_{system_};
  SimTK::MobilizedBody::Free body_;
  std::unique_ptr<SimTK::Integrator> integrator_;
  std::unique_ptr<SimTK::TimeStepper> stepper_;
};

}  // namespace

std::vector<Variant> variants() {
  int major = 0, minor = 0, patch = 0;
  SimTK_version_simbody(&major, &minor, &patch);
  const std::string version = "Simbody " + std::to_string(major) + "." + std::to_string(minor) + ", double, free joint with quaternions, ";
  const auto variant = [&](const char* name, const char* says, Kind kind) {
    return Variant{name, version + says, kind != Kind::merson_fixed, 54000,
                   [kind](const Flight& f, long steps, double accuracy) { return std::make_unique<SimbodyWorld>(f, kind, steps, accuracy); }};
  };
  return {variant("merson", "Runge-Kutta-Merson by accuracy (its default)", Kind::merson), variant("feldberg", "Runge-Kutta-Feldberg by accuracy", Kind::feldberg),
          variant("merson-fixed", "Runge-Kutta-Merson, fixed step", Kind::merson_fixed)};
}

}  // namespace rigor::peers
