#pragma once
#include <rigor/base/promise.hpp>
#include <rigor/contact/surface.hpp>
#include <rigor/formulas/apply_pair_impulse.hpp>
#include <rigor/formulas/friction_sheet.hpp>
#include <rigor/formulas/friction_stronge.hpp>
#include <rigor/formulas/friction_tangent.hpp>
#include <rigor/formulas/kinetic_energy.hpp>
#include <rigor/formulas/normal_effective_mass.hpp>
#include <rigor/formulas/normal_impulse.hpp>
#include <rigor/formulas/point_velocity.hpp>

namespace rigor {

/// One contact: the two sides at the impact pose, and the unit normal from A to B.
template <Field T>
struct Contact {
  ImpactBody<T> A, B;
  Vec3<T> n_AB_W;
  Vec3<T> f_B_W = zero3<T>();  ///< net force on B: gives friction its direction where there is no slip
};

/// What an impact did, for the ledgers. Energies in J, impulses in N·s, acting on B.
template <Field T>
struct ImpactReport {
  bool separating = true;       ///< v_n ≥ 0: nothing was done, the impulse is exactly 0
  Vec3<T> j_W = zero3<T>();
  T energy_change = T(0);       ///< j·(v_r + v_r')/2
  T restitution_loss = T(0);    ///< −j_n (v_n + v_n')/2
  T friction_loss = T(0);       ///< −j_t·(v_t + v_t')/2; the two losses add up to −energy_change
  FrictionOutcome outcome = FrictionOutcome::slid;
  bool energy_rose = false;     ///< Newton's restitution with friction, or the sheet's rule, can do that: FR-10, FR-11
};

template <Field T>
struct ImpactResult {
  PairVelocity<T> after;
  ImpactReport<T> report;
};

namespace detail {

/// The sheet's two impulses one after the other: the frictionless normal one, then friction against the slip left.
template <Field T>
FrictionImpact<T> sheet_impulse(const Contact<T>& c, const PairVelocity<T>& u, const T& v_n, const Surface<T>& surface,
                                FrictionLaw law) {
  const T j_r = normal_impulse<T>(surface.restitution(), v_n, normal_inverse_mass<T>(c.A, c.B, c.n_AB_W));
  Vec3<T> j(j_r * c.n_AB_W[0], j_r * c.n_AB_W[1], j_r * c.n_AB_W[2]);
  if (surface.frictionless()) return {j, FrictionOutcome::slid};
  const Vec3<T> v_after = relative_velocity<T>(c.A, c.B, apply_pair_impulse<T>(c.A, c.B, u, j));
  const Vec3<T> t = friction_tangent<T>(v_after, c.f_B_W, c.n_AB_W);
  const T slip = dot<T>(v_after, t);
  const T mass = T(1) / (c.A.inverse_mass + c.B.inverse_mass);  // the body's own where the other is immovable
  const T j_f = law == FrictionLaw::sheet
                    ? sheet_friction_impulse<T>(mass, surface.static_friction(), surface.dynamic_friction(), j_r, slip)
                    : sheet_literal_friction_impulse<T>(surface.dynamic_friction(), j_r, slip);
  for (int i = 0; i < 3; ++i) j[i] = j[i] - j_f * t[i];
  return {j, law == FrictionLaw::sheet && j_f == mass * slip ? FrictionOutcome::stuck : FrictionOutcome::slid};
}

}  // namespace detail

/// The impulse of one contact by the chosen law. Precondition: approaching, v_n < 0.
template <Field T>
FrictionImpact<T> impact_impulse(const Contact<T>& c, const PairVelocity<T>& u, const Surface<T>& surface, FrictionLaw law) {
  const Vec3<T> v_r = relative_velocity<T>(c.A, c.B, u);
  const T v_n = dot<T>(v_r, c.n_AB_W);
  if (surface.frictionless() || law == FrictionLaw::sheet || law == FrictionLaw::sheet_literal)
    return detail::sheet_impulse<T>(c, u, v_n, surface, law);
  const Mat3<T> K = effective_inverse_mass<T>(c.A, c.B);
  if constexpr (!std::is_same_v<T, double>)
    promise(law != FrictionLaw::stronge, "stronge's impulse is computed in double only");
  else if (law == FrictionLaw::stronge)
    return stronge_impulse(K, v_r, c.n_AB_W, surface.restitution(), surface.static_friction(), surface.dynamic_friction());
  return coulomb_impulse<T>(K, v_r, c.n_AB_W, friction_tangent<T>(v_r, c.f_B_W, c.n_AB_W), surface.restitution(),
                            surface.static_friction(), surface.dynamic_friction());
}

/// Resolves one contact: impulse, new velocities of both sides, energy account.
///
/// A contact that does not approach (v_n ≥ 0) is left alone. An immovable side has zeros in its ImpactBody and keeps
/// its velocity. Scalars other than double have no `stronge` (it is an ODE): asking for it breaks a promise.
template <Field T>
ImpactResult<T> resolve_impact(const Contact<T>& c, const PairVelocity<T>& before, const Surface<T>& surface, FrictionLaw law) {
  ImpactResult<T> result{before, {}};
  const Vec3<T> v_r = relative_velocity<T>(c.A, c.B, before);
  if (!(dot<T>(v_r, c.n_AB_W) < T(0))) return result;

  const FrictionImpact<T> impact = impact_impulse<T>(c, before, surface, law);
  result.after = apply_pair_impulse<T>(c.A, c.B, before, impact.j_W);
  const Vec3<T> v_after = relative_velocity<T>(c.A, c.B, result.after);
  ImpactReport<T>& report = result.report;
  report.separating = false;
  report.j_W = impact.j_W;
  report.outcome = impact.outcome;
  report.energy_change = impulse_energy<T>(impact.j_W, v_r, v_after);
  report.restitution_loss = -(dot<T>(impact.j_W, c.n_AB_W) * (dot<T>(v_r, c.n_AB_W) + dot<T>(v_after, c.n_AB_W)) / T(2));
  report.friction_loss = -report.energy_change - report.restitution_loss;
  // above rounding: the terms of the energy account are about |j||v_r| each
  const T unit = T(16) * T(Eigen::NumTraits<T>::epsilon());
  const T size = dot<T>(impact.j_W, impact.j_W) * (dot<T>(v_r, v_r) + dot<T>(v_after, v_after));
  report.energy_rose = report.energy_change > T(0) && report.energy_change * report.energy_change > unit * unit * size;
  return result;
}

}  // namespace rigor
