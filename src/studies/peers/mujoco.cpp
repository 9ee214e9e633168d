// MuJoCo (always double). Contacts and constraints off; the inertia is given, not inferred.
#include <mujoco/mujoco.h>

#include <cmath>
#include <cstring>
#include <rigor/studies/peers/peer.hpp>
#include <stdexcept>

namespace rigor::peers {
namespace {

static_assert(sizeof(mjtNum) == 8, "MuJoCo built for double");

template <std::size_t n>
std::string words(const std::array<double, n>& v) {
  std::string out;
  for (const double x : v) {
    char text[32];
    std::snprintf(text, sizeof text, "%.17g ", x);
    out += text;
  }
  return out;
}

class MujocoWorld : public World {
 public:
  MujocoWorld(const Flight& f, long steps, const char* integrator) : steps_(steps), stages_(std::strcmp(integrator, "RK4") == 0 ? 4 : 1) {
    mju_user_warning = [](const char*) {};
    mju_user_error = [](const char* message) { throw std::runtime_error(message); };
    const std::string xml = std::string("<mujoco><compiler balanceinertia=\"false\" boundmass=\"0\" boundinertia=\"0\"/>"
                                        "<size nconmax=\"1\" njmax=\"4\" nstack=\"100000\"/><option timestep=\"") +
                            words(std::array{f.until / double(steps)}) + "\" gravity=\"" + words(f.a) + "\" integrator=\"" + integrator +
                            "\"><flag contact=\"disable\" constraint=\"disable\"/></option><worldbody><body pos=\"" + words(f.p) + "\" quat=\"" + words(f.q) +
                            "\"><freejoint/><inertial pos=\"0 0 0\" mass=\"" + words(std::array{f.mass}) + "\" diaginertia=\"" + words(f.inertia()) +
                            "\"/></body></worldbody></mujoco>";
    const auto files = std::make_unique<mjVFS>();  // a megabyte
    mj_defaultVFS(files.get());
    if (mj_makeEmptyFileVFS(files.get(), "flight.xml", int(xml.size()) + 1) != 0) throw std::runtime_error("no place for its model");
    std::memcpy(files->filedata[0], xml.c_str(), xml.size() + 1);
    char error[1000] = "";
    model_ = mj_loadXML("flight.xml", files.get(), error, sizeof error);
    mj_deleteVFS(files.get());
    if (model_ == nullptr) throw std::runtime_error(error);
    data_ = mj_makeData(model_);
    const auto w_B = f.spin_B();
    for (int i = 0; i < 3; ++i) data_->qvel[i] = f.v[std::size_t(i)], data_->qvel[3 + i] = w_B[std::size_t(i)];
  }
  ~MujocoWorld() override {
    mj_deleteData(data_);
    mj_deleteModel(model_);
  }
  void run() override {
    for (long k = 0; k < steps_; ++k) mj_step(model_, data_);
  }
  End end() const override {
    const mjtNum *x = data_->qpos, *v = data_->qvel;
    End e{rows_of({x[3], x[4], x[5], x[6]}), {x[0], x[1], x[2]}, {v[0], v[1], v[2]}, {}};
    for (std::size_t i = 0; i < 3; ++i) e.w[i] = e.R[3 * i] * v[3] + e.R[3 * i + 1] * v[4] + e.R[3 * i + 2] * v[5];
    return e;
  }
  long evaluations() const override { return steps_ * stages_; }

 private:
  long steps_;
  int stages_;
  mjModel* model_;
  mjData* data_;
};

}  // namespace

std::vector<Variant> variants() {
  const std::string version = std::string("MuJoCo ") + mj_versionString() + ", double, contacts and constraints off, ";
  const auto variant = [&](const char* name, const char* integrator, double ns) {
    return Variant{name, version + "integrator " + integrator, false, ns, [=](const Flight& f, long steps, double) { return std::make_unique<MujocoWorld>(f, steps, integrator); }};
  };
  return {variant("rk4", "RK4", 2400), variant("euler", "Euler", 700), variant("implicit", "implicit", 900)};
}

}  // namespace rigor::peers
