#include <cmath>
#include <rigor/base/interrupt.hpp>
#include <rigor/formulas/angular_acceleration.hpp>
#include <rigor/formulas/force_sum.hpp>
#include <rigor/formulas/friction_sheet.hpp>
#include <rigor/formulas/friction_tangent.hpp>
#include <rigor/formulas/kinetic_energy.hpp>
#include <rigor/formulas/linear_acceleration.hpp>
#include <rigor/formulas/momentum.hpp>
#include <rigor/formulas/normal_effective_mass.hpp>
#include <rigor/formulas/normal_impulse.hpp>
#include <rigor/formulas/point_velocity.hpp>
#include <rigor/formulas/positional_correction.hpp>
#include <rigor/formulas/semi_implicit_step.hpp>
#include <rigor/scalar/gamma.hpp>
#include <rigor/scalar/magnitude.hpp>
#include <rigor/scalar/rational.hpp>
#include <rigor/verify/inputs.hpp>
#include <rigor/verify/verify.hpp>

namespace rigor::verify {
namespace {

template <class T>
using Numbers = std::vector<T>;

template <class T>
void add(Numbers<T>& out, const T& x) { out.push_back(x); }
template <class T>
void add(Numbers<T>& out, const Vec3<T>& v) {
  for (int i = 0; i < 3; ++i) out.push_back(v[i]);
}
template <class T>
void add(Numbers<T>& out, const Mat3<T>& M) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out.push_back(M(i, j));
}

// The answer as a list of numbers, for any mix of scalars, vectors and matrices.
template <class T, class... Parts>
Numbers<T> flat(const Parts&... parts) {
  Numbers<T> out;
  (add<T>(out, parts), ...);
  return out;
}

// `k` is the index of gamma that the docstring states; the formula runs on three scalars: double, the exact one
// (over Q, or long double where a root occurs) and Magnitude, whose `size` is the absolute sum in the bound.
template <class Exact, class Formula>
Rounding measure(const char* id, int k, long cases, std::uint64_t seed, Formula formula) {
  Rounding row{id, "gamma(" + std::to_string(k) + ") |terms|", 0, 0};
  Random random(seed);
  for (long c = 0; c < cases && interrupted() == 0; ++c) {
    Inputs<double> in = draw<double>(random);
    in.each([&](double& x) { x *= 1 + double(random() >> 12) * 0x1p-58; });  // every bit of the significand in use
    const auto to_exact = [](double x) {
      if constexpr (std::is_same_v<Exact, Rational>) return Rational::exactly(x);
      else return Exact(x);
    };
    const Numbers<double> got = formula(in);
    const Numbers<Exact> want = formula(converted<Exact>(in, to_exact));
    const Numbers<Magnitude> sum = formula(converted<Magnitude>(in, [](double x) { return Magnitude(x); }));
    for (std::size_t i = 0; i < got.size(); ++i) {
      const double error = std::abs(double(to_exact(got[i]) - want[i])), bound = gamma_bound(k) * sum[i].size;
      const double ratio = error == 0 ? 0 : error / bound;
      if (!(ratio <= row.worst)) row.worst = ratio;
    }
    ++row.cases;
  }
  return row;
}

}  // namespace

std::vector<Rounding> roundings(const std::string& only, long cases, std::uint64_t seed) {
  std::vector<Rounding> rows;
  const auto field = [&](const char* id, int k, auto formula) {
    if (only.empty() || only == id) rows.push_back(measure<Rational>(id, k, cases, seed, formula));
  };
  // Gram-Schmidt: counting roundings gives an idle gamma(160); a million draws reached 0.22 of gamma(24).
  const auto rooted = [&](const char* id, int k, auto formula) {
    if (only.empty() || only == id) rows.push_back(measure<long double>(id, k, cases, seed, formula));
  };
  field("contact.correction", 1, []<class T>(const Inputs<T>& in) { return flat<T>(positional_correction<T>(in.m, in.n_W)); });
  field("energy.impulse", 5, []<class T>(const Inputs<T>& in) { return flat<T>(impulse_energy<T>(in.j_W, in.v_WB, in.w_WB)); });
  field("energy.kinetic", 8, []<class T>(const Inputs<T>& in) { return flat<T>(kinetic_energy<T>(in.m, in.I_B_W, in.v_WB, in.w_WB)); });
  field("force.sum", 3, []<class T>(const Inputs<T>& in) {
    const Wrench<T> sum = add_force<T>({in.tau_W, in.w_WB}, in.p_BC_W, in.f_W);
    return flat<T>(sum.f_W, sum.tau_W);
  });
  field("force.torque", 2, []<class T>(const Inputs<T>& in) { return flat<T>(torque_of_force<T>(in.p_BC_W, in.f_W)); });
  field("friction.sheet", 1, []<class T>(const Inputs<T>& in) { return flat<T>(sheet_friction_impulse<T>(in.m, in.e, in.mu, in.m_B, in.h)); });
  field("friction.sheet_literal", 1, []<class T>(const Inputs<T>& in) { return flat<T>(sheet_literal_friction_impulse<T>(in.mu, in.m, in.m_B)); });
  rooted("friction.tangent", 10, []<class T>(const Inputs<T>& in) { return flat<T>(friction_tangent<T>(in.v_WB, in.f_W, in.n_W)); });
  field("impulse.apply", 6, []<class T>(const Inputs<T>& in) {
    const Velocity<T> after = apply_impulse<T>(in.A, in.u.A, in.j_W);
    return flat<T>(after.v_WB, after.w_WB);
  });
  field("impulse.apply_pair", 6, []<class T>(const Inputs<T>& in) {
    const PairVelocity<T> after = apply_pair_impulse<T>(in.A, in.B, in.u, in.j_W);
    return flat<T>(after.A.v_WB, after.A.w_WB, after.B.v_WB, after.B.w_WB);
  });
  field("impulse.effective_mass", 8, []<class T>(const Inputs<T>& in) { return flat<T>(effective_inverse_mass<T>(in.A, in.B)); });
  field("impulse.normal", 3, []<class T>(const Inputs<T>& in) { return flat<T>(normal_impulse<T>(in.e, in.v_WB[0], in.m)); });
  field("impulse.normal_effective_mass", 12, []<class T>(const Inputs<T>& in) { return flat<T>(normal_inverse_mass<T>(in.A, in.B, in.n_W)); });
  field("impulse.normal_printed", 3, []<class T>(const Inputs<T>& in) { return flat<T>(normal_impulse_printed<T>(in.e, in.v_WB[0], in.m)); });
  field("impulse.relative_velocity", 4, []<class T>(const Inputs<T>& in) { return flat<T>(relative_velocity<T>(in.A, in.B, in.u)); });
  field("inertia.cuboid", 4, []<class T>(const Inputs<T>& in) { return flat<T>(cuboid_inertia<T>(in.m, in.s_B)); });
  field("inertia.cuboid_inverse", 1, []<class T>(const Inputs<T>& in) { return flat<T>(cuboid_inverse_inertia<T>(in.I_B)); });
  field("inertia.world", 5, []<class T>(const Inputs<T>& in) { return flat<T>(world_inertia<T>(in.R_WB, in.I_B)); });
  field("inertia.world_inverse", 5, []<class T>(const Inputs<T>& in) { return flat<T>(world_inverse_inertia<T>(in.R_WB, in.inverse_I_B)); });
  field("momentum.angular", 5, []<class T>(const Inputs<T>& in) {
    return flat<T>(angular_momentum<T>(in.m, in.I_B_W, in.p_WB, in.v_WB, in.w_WB, in.p_WO));
  });
  field("momentum.linear", 1, []<class T>(const Inputs<T>& in) { return flat<T>(linear_momentum<T>(in.m, in.v_WB)); });
  field("motion.euler", 9, []<class T>(const Inputs<T>& in) {
    return flat<T>(angular_acceleration<T>(in.I_B_W, in.inverse_I_B_W, in.w_WB, in.tau_W));
  });
  field("motion.linear", 1, []<class T>(const Inputs<T>& in) { return flat<T>(linear_acceleration<T>(in.m, in.f_W)); });
  field("motion.point_velocity", 3, []<class T>(const Inputs<T>& in) { return flat<T>(point_velocity<T>(in.v_WB, in.w_WB, in.p_BC_W)); });
  rooted("rotation.gram_schmidt", 24, []<class T>(const Inputs<T>& in) { return flat<T>(gram_schmidt<T>(in.M)); });
  field("rotation.naive_step", 4, []<class T>(const Inputs<T>& in) { return flat<T>(naive_rotation_step<T>(in.h, in.w_WB, in.R_WB)); });
  field("rotation.rate", 2, []<class T>(const Inputs<T>& in) { return flat<T>(rotation_rate<T>(in.w_WB, in.R_WB)); });
  rooted("step.semi_implicit", 28, []<class T>(const Inputs<T>& in) {
    const State<T> next = semi_implicit_step<T>(in.h, {in.p_WB, in.R_WB, in.v_WB, in.w_WB}, in.f_W, in.tau_W);
    return flat<T>(next.p_WB, next.v_WB, next.w_WB, next.R_WB);
  });
  return rows;
}

}  // namespace rigor::verify
