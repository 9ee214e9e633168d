#include <cstdio>
// arkode's headers use FILE without including it
#include <arkode/arkode_arkstep.h>
#include <cvodes/cvodes.h>  // CVODE and its sensitivities: the two libraries share their names, a program links one of them
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <reference/sundials.hpp>
#include <rigor/linalg/rotation.hpp>
#include <sundials/sundials_context.hpp>

namespace rigor::reference {
namespace {

struct FreeVector {
  void operator()(N_Vector v) const { N_VDestroy(v); }
};
using Vector = std::unique_ptr<std::remove_pointer_t<N_Vector>, FreeVector>;

Vector vector_of(const std::vector<double>& y, SUNContext context) {
  Vector v(N_VNew_Serial(sunindextype(y.size()), context));
  std::copy(y.begin(), y.end(), N_VGetArrayPointer(v.get()));
  return v;
}
std::span<double> view(N_Vector v) { return {N_VGetArrayPointer(v), std::size_t(N_VGetLength(v))}; }

struct User {
  const Rhs* f;
  const std::function<double(double, std::span<const double>)>* g = nullptr;
  const Tangent* df = nullptr;
};
int call_rhs(realtype t, N_Vector y, N_Vector dy, void* user) {
  (*static_cast<User*>(user)->f)(t, view(y), view(dy));
  return 0;
}
int call_tangent(int, realtype t, N_Vector y, N_Vector, int, N_Vector s, N_Vector ds, void* user, N_Vector, N_Vector) {
  (*static_cast<User*>(user)->df)(t, view(y), view(s), view(ds));
  return 0;
}
int call_root(realtype t, N_Vector y, realtype* out, void* user) {
  out[0] = (*static_cast<User*>(user)->g)(t, view(y));
  return 0;
}

Fault failed(const char* who, int code) {
  char* name = std::string_view(who) == "CVODE" ? CVodeGetReturnFlagName(code) : ARKStepGetReturnFlagName(code);
  Fault fault{Fault::Kind::unsupported, who, std::string("did not finish: ") + name};
  std::free(name);
  return fault;
}
std::optional<Fault> bad_tolerance(double tolerance) {
  if (tolerance >= 1e-15 && tolerance < 1) return std::nullopt;
  return Fault{Fault::Kind::out_of_range, "tolerance", "is " + std::to_string(tolerance) + ", must be in [1e-15, 1)"};
}

// One CVODE integrator with everything it owns.
class CvodeRun {
 public:
  CvodeRun(const Rhs& f, const std::vector<double>& y0, double t0, double tolerance, Cvode kind) : user_{&f}, y_(vector_of(y0, context_)) {
    memory_ = CVodeCreate(kind == Cvode::adams ? CV_ADAMS : CV_BDF, context_);
    CVodeInit(memory_, call_rhs, t0, y_.get());
    CVodeSStolerances(memory_, tolerance, tolerance);
    CVodeSetUserData(memory_, &user_);
    CVodeSetMaxNumSteps(memory_, 10000000);
    CVodeSetErrFile(memory_, nullptr);
    if (kind == Cvode::adams) {
      nonlinear_ = SUNNonlinSol_FixedPoint(y_.get(), 0, context_);
      CVodeSetNonlinearSolver(memory_, nonlinear_);
    } else {
      const sunindextype n = sunindextype(y0.size());
      matrix_ = SUNDenseMatrix(n, n, context_);
      linear_ = SUNLinSol_Dense(y_.get(), matrix_, context_);
      CVodeSetLinearSolver(memory_, linear_, matrix_);
    }
  }
  ~CvodeRun() {
    CVodeFree(&memory_);
    if (nonlinear_ != nullptr) SUNNonlinSolFree(nonlinear_);
    if (of_changes_ != nullptr) SUNNonlinSolFree(of_changes_);
    if (linear_ != nullptr) SUNLinSolFree(linear_);
    if (matrix_ != nullptr) SUNMatDestroy(matrix_);
  }
  CvodeRun(const CvodeRun&) = delete;

  void watch(const std::function<double(double, std::span<const double>)>& g) {
    user_.g = &g;
    CVodeRootInit(memory_, 1, call_root);
    int falling = -1;  // approaching only
    CVodeSetRootDirection(memory_, &falling);
  }
  /// Beside y its changes with something that it began with; their errors are controlled as y's.
  void carry(const Tangent& df, const std::vector<std::vector<double>>& s0, double tolerance) {
    user_.df = &df;
    for (const auto& s : s0) {
      changes_.push_back(vector_of(s, context_));
      raw_changes_.push_back(changes_.back().get());
    }
    const int n = int(s0.size());
    std::vector<double> absolute(s0.size(), tolerance);
    CVodeSensInit1(memory_, n, CV_SIMULTANEOUS, call_tangent, raw_changes_.data());
    CVodeSensSStolerances(memory_, tolerance, absolute.data());
    CVodeSetSensErrCon(memory_, SUNTRUE);
    of_changes_ = SUNNonlinSol_FixedPointSens(n + 1, y_.get(), 0, context_);
    CVodeSetNonlinearSolverSensSim(memory_, of_changes_);
  }
  std::vector<std::vector<double>> changes() {
    realtype t;
    CVodeGetSens(memory_, &t, raw_changes_.data());
    std::vector<std::vector<double>> out;
    for (N_Vector s : raw_changes_) out.emplace_back(view(s).begin(), view(s).end());
    return out;
  }
  int advance(double t1) {
    CVodeSetStopTime(memory_, t1);
    return CVode(memory_, t1, y_.get(), &t_, CV_NORMAL);
  }
  Solution solution() const {
    Solution s;
    const auto y = view(y_.get());
    s.y.assign(y.begin(), y.end());
    s.t = t_;
    CVodeGetNumSteps(memory_, &s.steps);
    CVodeGetNumRhsEvals(memory_, &s.evaluations);
    return s;
  }

 private:
  sundials::Context context_;
  User user_;
  Vector y_;
  void* memory_ = nullptr;
  SUNNonlinearSolver nonlinear_ = nullptr, of_changes_ = nullptr;
  std::vector<Vector> changes_;
  std::vector<N_Vector> raw_changes_;
  SUNLinearSolver linear_ = nullptr;
  SUNMatrix matrix_ = nullptr;
  realtype t_ = 0;
};

ARKODE_ERKTableID id_of(ErkTable table) {
  switch (table) {
    case ErkTable::heun_euler_2_1_2: return ARKODE_HEUN_EULER_2_1_2;
    case ErkTable::bogacki_shampine_4_2_3: return ARKODE_BOGACKI_SHAMPINE_4_2_3;
    case ErkTable::ark324_4_2_3: return ARKODE_ARK324L2SA_ERK_4_2_3;
    case ErkTable::zonneveld_5_3_4: return ARKODE_ZONNEVELD_5_3_4;
    case ErkTable::ark436_6_3_4: return ARKODE_ARK436L2SA_ERK_6_3_4;
    case ErkTable::ark437_7_3_4: return ARKODE_ARK437L2SA_ERK_7_3_4;
    case ErkTable::sayfy_aburub_6_3_4: return ARKODE_SAYFY_ABURUB_6_3_4;
    case ErkTable::cash_karp_6_4_5: return ARKODE_CASH_KARP_6_4_5;
    case ErkTable::fehlberg_6_4_5: return ARKODE_FEHLBERG_6_4_5;
    case ErkTable::dormand_prince_7_4_5: return ARKODE_DORMAND_PRINCE_7_4_5;
    case ErkTable::ark548_8_4_5: return ARKODE_ARK548L2SA_ERK_8_4_5;
    case ErkTable::ark548b_8_4_5: return ARKODE_ARK548L2SAb_ERK_8_4_5;
    case ErkTable::verner_8_5_6: return ARKODE_VERNER_8_5_6;
    case ErkTable::fehlberg_13_7_8: return ARKODE_FEHLBERG_13_7_8;
  }
  return ARKODE_FEHLBERG_13_7_8;
}

Outcome<Solution> run_arkstep(const Rhs& f, const std::vector<double>& y0, double t0, double t1, double tolerance, long steps, ErkTable table) {
  if (t1 == t0) return Solution{y0, t0, 0, 0};
  sundials::Context context;
  const Vector y = vector_of(y0, context);
  User user{&f};
  void* memory = ARKStepCreate(call_rhs, nullptr, t0, y.get(), context);
  const std::unique_ptr<void, void (*)(void*)> guard(memory, [](void* m) { ARKStepFree(&m); });
  ARKStepSetUserData(memory, &user);
  ARKStepSetTableNum(memory, ARKODE_DIRK_NONE, id_of(table));
  ARKStepSetMaxNumSteps(memory, 100000000);
  ARKStepSetErrFile(memory, nullptr);
  ARKStepSStolerances(memory, tolerance, tolerance);
  if (steps > 0) ARKStepSetFixedStep(memory, (t1 - t0) / double(steps));
  ARKStepSetStopTime(memory, t1);
  realtype t = t0;
  const int code = ARKStepEvolve(memory, t1, y.get(), &t, ARK_NORMAL);
  if (code < 0) return failed("ARKStep", code);
  Solution s;
  const auto values = view(y.get());
  s.y.assign(values.begin(), values.end());
  s.t = t;
  ARKStepGetNumSteps(memory, &s.steps);
  long implicit;
  ARKStepGetNumRhsEvals(memory, &s.evaluations, &implicit);
  return s;
}

std::vector<double> initial(const FreeBody& body) { return {body.w_B[0], body.w_B[1], body.w_B[2], 1, 0, 0, 0}; }
Attitude<double> attitude_of(const FreeBody& body, const std::vector<double>& y) {
  const Mat3<double> turn = rotation_of<double>(Vec4<double>(y[3], y[4], y[5], y[6]));
  return {Mat3<double>(body.R_WB * turn), Vec3<double>(y[0], y[1], y[2])};
}

}  // namespace

Outcome<Solution> cvode(const Rhs& f, std::vector<double> y0, double t0, double t1, double tolerance, Cvode kind) {
  if (const auto bad = bad_tolerance(tolerance)) return *bad;
  if (t1 == t0) return Solution{std::move(y0), t0, 0, 0};
  CvodeRun run(f, y0, t0, tolerance, kind);
  const int code = run.advance(t1);
  if (code < 0) return failed("CVODE", code);
  return run.solution();
}

Outcome<Sensitivity> cvodes(const Rhs& f, const Tangent& df, std::vector<double> y0, std::vector<std::vector<double>> s0, double t0, double t1, double tolerance) {
  if (const auto bad = bad_tolerance(tolerance)) return *bad;
  if (t1 == t0) return Sensitivity{std::move(y0), std::move(s0)};
  CvodeRun run(f, y0, t0, tolerance, Cvode::adams);
  run.carry(df, s0, tolerance);
  const int code = run.advance(t1);
  if (code < 0) return failed("CVODE", code);
  return Sensitivity{run.solution().y, run.changes()};
}

Outcome<Solution> arkstep(const Rhs& f, std::vector<double> y0, double t0, double t1, double tolerance, ErkTable table) {
  if (const auto bad = bad_tolerance(tolerance)) return *bad;
  return run_arkstep(f, y0, t0, t1, tolerance, 0, table);
}

Outcome<Solution> arkstep_fixed(const Rhs& f, std::vector<double> y0, double t0, double t1, long steps, ErkTable table) {
  if (steps < 1) return Fault{Fault::Kind::not_positive, "steps", "is " + std::to_string(steps) + ", must be >= 1"};
  return run_arkstep(f, y0, t0, t1, 1e-10, steps, table);
}

Outcome<Event> first_fall(const Rhs& f, const std::function<double(double, std::span<const double>)>& g, std::vector<double> y0, double t0, double t1,
                          double tolerance) {
  if (const auto bad = bad_tolerance(tolerance)) return *bad;
  CvodeRun run(f, y0, t0, tolerance, Cvode::adams);
  run.watch(g);
  const int code = run.advance(t1);
  if (code < 0) return failed("CVODE", code);
  if (code != CV_ROOT_RETURN) return Fault{Fault::Kind::out_of_range, "event", "does not happen before the end of the interval"};
  // CVODE finds the root of its interpolant; from the start again, with a step that ends there, the secant rule finds
  // the root of the solution itself.
  double a = run.solution().t;
  Event event{a, {}};
  double b = 0, g_b = 0;
  for (int i = 0; i < 8; ++i) {
    const auto at = cvode(f, y0, t0, a, tolerance);
    if (!at) return at.fault();
    const double g_a = g(a, at->y);
    event = {a, at->y};
    if (g_a == 0 || (i > 0 && a == b)) break;
    const double slope = i == 0 ? 0 : (g_a - g_b) / (a - b);
    const double next = i == 0 ? a + 1e-7 * (a - t0) : slope == 0 ? a : a - g_a / slope;
    b = a, g_b = g_a;
    if (i > 1 && std::abs(next - a) <= 1e-16 * std::abs(a)) break;
    a = next;
  }
  return event;
}

Rhs free_body_rhs(const Vec3<double>& I) {
  const double c[3] = {(I[1] - I[2]) / I[0], (I[2] - I[0]) / I[1], (I[0] - I[1]) / I[2]};
  return [c0 = c[0], c1 = c[1], c2 = c[2]](double, std::span<const double> y, std::span<double> d) {
    const double x = y[0], w = y[1], z = y[2];
    d[0] = c0 * w * z, d[1] = c1 * z * x, d[2] = c2 * x * w;
    d[3] = -0.5 * (y[4] * x + y[5] * w + y[6] * z);
    d[4] = 0.5 * (y[3] * x + y[5] * z - y[6] * w);
    d[5] = 0.5 * (y[3] * w + y[6] * x - y[4] * z);
    d[6] = 0.5 * (y[3] * z + y[4] * w - y[5] * x);
  };
}

Outcome<Mat3<double>> cvodes_turn_by_spin(const FreeBody& body, double t, double tolerance) {
  const Rhs f = free_body_rhs(body.I_B);
  // the law is a quadratic form, f(y) = b(y, y): its change along s is b(y, s) + b(s, y) = (f(y + s) - f(y - s))/2
  const Tangent df = [&f](double at, std::span<const double> y, std::span<const double> s, std::span<double> ds) {
    double more[7], less[7], f_less[7];
    for (std::size_t i = 0; i < 7; ++i) more[i] = y[i] + s[i], less[i] = y[i] - s[i];
    f(at, more, ds);
    f(at, less, f_less);
    for (std::size_t i = 0; i < 7; ++i) ds[i] = (ds[i] - f_less[i]) / 2;
  };
  const auto end = cvodes(f, df, initial(body), {{1, 0, 0, 0, 0, 0, 0}, {0, 1, 0, 0, 0, 0, 0}, {0, 0, 1, 0, 0, 0, 0}}, 0, t, tolerance);
  if (!end) return end.fault();
  const double* q = end->y.data() + 3;
  Mat3<double> turn;
  for (int i = 0; i < 3; ++i) {  // 2 (dq q*) of quaternions, its vector part
    const double* d = end->dy[std::size_t(i)].data() + 3;
    const Vec3<double> v(q[1], q[2], q[3]), dv(d[1], d[2], d[3]);
    turn.col(i) = body.R_WB * Vec3<double>(2 * (q[0] * dv - d[0] * v + cross<double>(v, dv)));
  }
  return turn;
}

Outcome<Attitude<double>> cvode_free_body(const FreeBody& body, double t, double tolerance, Cvode kind) {
  const auto s = cvode(free_body_rhs(body.I_B), initial(body), 0, t, tolerance, kind);
  if (!s) return s.fault();
  return attitude_of(body, s->y);
}

Outcome<Attitude<double>> arkstep_free_body(const FreeBody& body, double t, double tolerance, ErkTable table) {
  const auto s = arkstep(free_body_rhs(body.I_B), initial(body), 0, t, tolerance, table);
  if (!s) return s.fault();
  return attitude_of(body, s->y);
}

}  // namespace rigor::reference
