#include <rigor/formulas/angular_acceleration.hpp>
#include <rigor/formulas/force_sum.hpp>
#include <rigor/formulas/friction_tangent.hpp>
#include <rigor/formulas/linear_acceleration.hpp>
#include <rigor/formulas/semi_implicit_step.hpp>
#include <tests/property/generators.hpp>

namespace rigor {
namespace {

double determinant(const Mat3<double>& R) { return dot<double>(cross<double>(R.col(0), R.col(1)), R.col(2)); }

}  // namespace

// id: rotation.gram_schmidt, step.semi_implicit
// Gram-Schmidt on (1 + h[w]ₓ)R, whose condition number is √(1 + h²w²): |QᵀQ − 1| ≤ 12 u κ
// (rotation.gram_schmidt).
RC_GTEST_PROP(SemiImplicitStep, EndsWithARotation, (const Numbers& numbers)) {
  State<double> s = numbers.body<double>(0).state;
  const double h = std::ldexp(1, -*rc::gen::inRange(0, 12));
  const double kappa = std::sqrt(1 + h * h * dot<double>(s.w_WB, s.w_WB));
  for (int i = 0; i < 20; ++i) s = semi_implicit_step<double>(h, s, zero3<double>(), zero3<double>());
  RC_ASSERT(orthonormality_defect<double>(s.R_WB) <= 12 * unit_roundoff<double>() * kappa);
  RC_ASSERT(std::abs(determinant(s.R_WB) - 1) <= 12 * unit_roundoff<double>() * kappa);
}

// id: motion.euler
// ω·Iω̇ = ω·τ and Iω̇ + ω × Iω = τ: the power and the balance, to rounding.
RC_GTEST_PROP(EulersEquation, BalancesTorqueAndGivesItsPower, (const Numbers& numbers)) {
  const auto residual = []<class T>(const Numbers& n) {
    const Body<T> b = n.body<T>(0);
    const Mat3<T> I = b.inertia();
    const Vec3<T> w = b.state.w_WB, tau = n.body<T>(1).state.v_WB;
    const Vec3<T> w_dot = angular_acceleration<T>(I, b.at(zero3<T>()).inverse_I_B_W, w, tau);
    const Vec3<T> I_w_dot = apply<T>(I, w_dot), turn = cross<T>(w, apply<T>(I, w));
    return std::array<T, 4>{I_w_dot[0] + turn[0] - tau[0], I_w_dot[1] + turn[1] - tau[1],
                            I_w_dot[2] + turn[2] - tau[2], dot<T>(w, I_w_dot) - dot<T>(w, tau)};
  };
  RC_ASSERT(worst_ratio(numbers, 60, residual) <= 1);
}

// id: force.sum, force.torque, motion.linear
// The order in which forces are added changes the sums by rounding alone.
RC_GTEST_PROP(Wrench, DoesNotDependOnTheOrderOfItsForces, (const Numbers& numbers)) {
  const auto residual = []<class T>(const Numbers& n) {
    const Body<T> a = n.body<T>(0), b = n.body<T>(1);
    const Vec3<T> p[3] = {a.state.p_WB, b.state.p_WB, a.state.w_WB},
                  f[3] = {a.state.v_WB, b.state.v_WB, b.state.w_WB};
    Wrench<T> forth, back;
    for (int i = 0; i < 3; ++i)
      forth = add_force<T>(forth, p[i], f[i]), back = add_force<T>(back, p[2 - i], f[2 - i]);
    std::array<T, 6> r;
    for (int i = 0; i < 3; ++i) {
      r[std::size_t(i)] =
          linear_acceleration<T>(T(1) / a.m, forth.f_W)[i] - linear_acceleration<T>(T(1) / a.m, back.f_W)[i];
      r[std::size_t(3 + i)] = forth.tau_W[i] - back.tau_W[i];
    }
    return r;
  };
  RC_ASSERT(worst_ratio(numbers, 8, residual) <= 1);
}

// id: friction.tangent
// Of unit length (norm: γ₄) and in the tangent plane: the projection leaves 5u|v_r| of it
// (proofs/friction.md).
RC_GTEST_PROP(FrictionTangent, IsAUnitVectorInTheTangentPlaneAlongTheSlip, (const Numbers& numbers)) {
  const Meeting<double> m = numbers.meeting<double>();
  const Vec3<double> v_r = relative_velocity<double>(m.A(), m.B(), m.before()), n = m.n_AB_W;
  const Vec3<double> t = friction_tangent<double>(v_r, m.p_WC, n);
  const Vec3<double>& a = norm<double>(v_r) > 0 ? v_r : m.p_WC;
  const double slip = norm<double>(cross<double>(a, n));
  RC_PRE(slip > 1e-6 * norm<double>(a));
  RC_ASSERT(std::abs(dot<double>(t, t) - 1) <= 2 * gamma_bound(4));
  RC_ASSERT(std::abs(dot<double>(t, n)) <= gamma_bound(12) * norm<double>(a) / slip);
  RC_ASSERT(dot<double>(t, a) > 0);
}

}  // namespace rigor
