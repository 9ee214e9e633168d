#pragma once
#include <rigor/linalg/types.hpp>

namespace rigor {

/// Size of the friction impulse by the assignment's rule, read with j_s = μ_s j_r and j_d = μ_d j_r.
///
///     j_f = m s   if m s ≤ μ_s j_r   (stops the slip, as if the body were a point mass)
///         = μ_d j_r   else,           applied along −t;   s = v_r·t ≥ 0, taken after the normal impulse
///
/// m is the body's own mass: right for a contact straight below the centre with no turning, an approximation
/// elsewhere (the tangential effective mass is 1/k_tt). It can reverse the slip and add energy.
///
/// shapes    scalars → scalar, ≥ 0
/// units     kg, 1, 1, N·s, m/s → N·s
/// frames    t along the slip; the impulse acts on the sliding body along −t
/// scalars   Field: exact over ℚ
/// domain    m > 0, μ_s ≥ 0, μ_d ≥ 0, j_r ≥ 0, s ≥ 0
/// rounding  within u of the branch's product; the branch is decided within 2u
/// id        friction.sheet
/// source    assignment, Part 2; reading: reference/errata.md, errata friction-coefficients and friction-law
template <Field T>
T sheet_friction_impulse(const T& m, const T& mu_s, const T& mu_d, const T& j_r, const T& slip) {
  const T stopping = m * slip;
  return stopping <= mu_s * j_r ? stopping : mu_d * j_r;
}

/// The same rule with its conditions read literally: "v_r·t = 0 AND m v_r·t ≤ j_s" holds only without slip, where
/// the impulse is zero; every slip, however small, gets the full dynamic impulse. Kept as a named variant.
///
///     j_f = 0 if s = 0,  else μ_d j_r
///
/// shapes    scalars → scalar, ≥ 0
/// units     1, N·s, m/s → N·s
/// frames    as sheet_friction_impulse
/// scalars   Field: exact over ℚ
/// domain    μ_d ≥ 0, j_r ≥ 0, s ≥ 0
/// rounding  within u
/// id        friction.sheet_literal
/// source    assignment, Part 2, verbatim; reference/errata.md, erratum friction-law
template <Field T>
T sheet_literal_friction_impulse(const T& mu_d, const T& j_r, const T& slip) {
  return slip == T(0) ? T(0) : mu_d * j_r;
}

}  // namespace rigor
