// ODE in double precision. Damping and auto-disable off; gyroscopic mode on, which is its default.
#include <ode/ode.h>

#include <algorithm>
#include <rigor/studies/peers/peer.hpp>

namespace rigor::peers {
namespace {

static_assert(sizeof(dReal) == 8, "ODE built for double");

class OdeWorld : public World {
 public:
  OdeWorld(const Flight& f, long steps, bool quick, bool finite_rotation) : steps_(steps), h_(f.until / double(steps)), quick_(quick) {
    static const bool started = dInitODE2(0) != 0;
    (void)started;
    world_ = dWorldCreate();
    dWorldSetGravity(world_, f.a[0], f.a[1], f.a[2]);
    dWorldSetAutoDisableFlag(world_, 0);
    dWorldSetDamping(world_, 0, 0);
    body_ = dBodyCreate(world_);
    dMass mass;
    dMassSetBoxTotal(&mass, f.mass, f.size[0], f.size[1], f.size[2]);
    dBodySetMass(body_, &mass);
    dBodySetPosition(body_, f.p[0], f.p[1], f.p[2]);
    const dQuaternion q = {f.q[0], f.q[1], f.q[2], f.q[3]};
    dBodySetQuaternion(body_, q);
    dBodySetLinearVel(body_, f.v[0], f.v[1], f.v[2]);
    dBodySetAngularVel(body_, f.w[0], f.w[1], f.w[2]);
    dBodySetGyroscopicMode(body_, 1);
    dBodySetFiniteRotationMode(body_, finite_rotation);
  }
  ~OdeWorld() override { dWorldDestroy(world_); }
  void run() override {
    for (long k = 0; k < steps_; ++k) quick_ ? dWorldQuickStep(world_, h_) : dWorldStep(world_, h_);
  }
  End end() const override {
    const dReal* R = dBodyGetRotation(body_);  // rows of four
    End e{{R[0], R[1], R[2], R[4], R[5], R[6], R[8], R[9], R[10]}, {}, {}, {}};
    std::copy_n(dBodyGetPosition(body_), 3, e.p.begin());
    std::copy_n(dBodyGetLinearVel(body_), 3, e.v.begin());
    std::copy_n(dBodyGetAngularVel(body_), 3, e.w.begin());
    return e;
  }
  long evaluations() const override { return steps_; }

 private:
  long steps_;
  double h_;
  bool quick_;
  dWorldID world_;
  dBodyID body_;
};

}  // namespace

std::vector<Variant> variants() {
  const auto variant = [](const char* name, const char* says, bool quick, bool finite) {
    return Variant{name, std::string("ODE ") + dODE_VERSION + ", double, no damping, no auto-disable, gyroscopic mode on, " + says, false, 400,
                   [=](const Flight& f, long steps, double) { return std::make_unique<OdeWorld>(f, steps, quick, finite); }};
  };
  return {variant("step", "dWorldStep (its default)", false, false), variant("finite-rotation", "dWorldStep, finite rotation mode", false, true),
          variant("quickstep", "dWorldQuickStep", true, false)};
}

}  // namespace rigor::peers
